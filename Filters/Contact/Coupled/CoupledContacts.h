// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CoupledContacts_h
#define palpate_CoupledContacts_h

#include "Contact/Contact.h"
#include "Contact/ContactBody.h"
#include "Contact/ContactSettings.h"
#include "Contact/Coupled/BodyCoupling.h"
#include "Contact/ToolContact.h"
#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace palpate
{
/**
 * Several tools on one body that act on one another: each lowers the surface under the others,
 *   δ_i = δ_local,i(F_i) + Σ_j C_ij F_j,  F_i >= 0,
 * where δ_i is the depth of tool i and C_ij comes from BodyCoupling. A tick finds all contacts and
 * starts with forces extrapolated from the two preceding ticks. It then makes two rounds over the
 * contacts, F_i ← F_i,slow(δ_i - Σ_{j≠i} C_ij F_j) (Gauss-Seidel). Finally each ToolContact is
 * evaluated at the remaining part of its depth, which is Contact::deflection. A tool without
 * remaining depth has no force but is still followed. For up to MostSolved tools a round is a step
 * of Newton's method instead. Newton's method also finds the forces of fingers that pinch a slender
 * body, for which the rounds of Gauss-Seidel do not converge.
 *
 * After two rounds the residual is less than 1e-3 of the force for 10 contacts at 200 mm/s and
 * 1 kHz, and 5e-3 for 20. On a body that relaxes, only the slow forces lower the surface under the
 * other tools.
 *
 * With ForceForm::EnergyConsistent each tool is also drawn towards the others along the surface by
 *   F_i F_j ∂C_ij/∂x_i.
 * With this force, the forces have the energy Σ δ_i F_i - Σ U*_i(F_i) - Σ_{i<j} C_ij F_i F_j of the
 * body on any path of the contacts, with two exceptions: the residual of two rounds (2e-6 F δ per
 * period of two tools that press a quarter period apart), and contacts whose distance is limited to
 * the sum of their radii. This does not apply to a body that relaxes.
 *
 * For a body without coupling, and for one contact, the results are bit for bit those of
 * ToolContact. update() does not allocate, lock or throw. Its cost is bounded: N² multiply-adds and
 * N curves per round. One object serves one thread; the body may be shared and must outlive it.
 */
class PALPATE_EXPORT CoupledContacts
{
public:
  static constexpr std::size_t Most = 64;
  static constexpr int Rounds = 2;          ///< rounds per tick
  static constexpr int SettlingRounds = 64; ///< upper limit of rounds for forces exact to rounding
  static constexpr std::size_t MostSolved = 8;

  /// `count` is clamped to the range 1 to Most.
  CoupledContacts(const ContactBody& body, const ContactSettings& settings, std::size_t count);

  std::size_t count() const noexcept { return this->Contacts.size(); }

  /// Evaluates all contacts. `poses` has one pose for each contact. A contact whose pose is not
  /// finite is Invalid and does not act on the others. The results are valid until the next update.
  /// Without `elapsed` the response is the slow one; otherwise the force is that `elapsed` s after
  /// the last update.
  const std::vector<Contact>& update(const ToolPose* poses) noexcept;
  const std::vector<Contact>& update(const ToolPose* poses, double elapsed) noexcept;
  /// As update(), but solved to rounding whatever the forces were before; at most SettlingRounds.
  const std::vector<Contact>& settle(const ToolPose* poses) noexcept;
  const std::vector<Contact>& settle(const ToolPose* poses, double elapsed) noexcept;

  /// Makes a tick of a servo loop, `elapsed` s after the last one. A contact without a pose is
  /// kept: its result is Invalid, it does not act on the others, and only its time advances. A
  /// single contact with a pose is evaluated by its ToolContact alone; stiffness() does not include
  /// it.
  const std::vector<Contact>& step(const std::optional<ToolPose>* poses, double elapsed) noexcept;
  /// Moves one contact, without time, so that the next tick continues at this pose.
  void move(std::size_t contact, const ToolPose& pose) noexcept
  {
    this->Contacts[contact].update(pose);
  }
  /// Continues the friction of the same contact of another scene; see ToolContact.
  void assumeFriction(std::size_t contact, const CoupledContacts& other) noexcept
  {
    this->Contacts[contact].assumeFriction(other.Contacts[contact]);
  }
  /// Takes the history of other contacts, as many, on the same body. Allocates nothing.
  void assume(const CoupledContacts& other) noexcept;

  const std::vector<Contact>& felt() const noexcept { return this->Felt; }
  /// Lowering of the surface at a contact by the other contacts, mm.
  double sunk(std::size_t contact) const noexcept { return this->Loads[contact].sunk; }

  /// Relative error of a contact's force because the others act on it as point forces
  /// (BodyCoupling::pointForceError), 0 to 1.
  double pointForceError(std::size_t contact) const noexcept;

  /// These functions apply the function of ToolContact with the same name to all contacts.
  void reset() noexcept;
  void lose() noexcept
  {
    for (std::size_t i = 0; i < this->Contacts.size(); ++i)
    {
      this->lose(i);
    }
  }
  void foresee() const noexcept
  {
    for (const ToolContact& contact : this->Contacts)
    {
      contact.foresee();
    }
  }
  /// Ends one contact, which then no longer acts on the others.
  void lose(std::size_t contact) noexcept;

  /// Derivatives of the slow normal forces of the last update by the depths, N/mm: ∂F_i/∂δ_j, row
  /// by row. This is the inverse of the matrix with 1/K_i on the diagonal and C_ij elsewhere; zero
  /// for contacts without force. Allocates, N³ multiply-adds: not for use in a tick.
  Eigen::MatrixXd stiffness() const;
  /// Upper bound of the stiffness of the contacts of the last update together, divided by that of
  /// the stiffest contact alone; at least 1. No motion of the contacts, in or out, is stiffer. (Two
  /// contacts that move in opposite directions are stiffer than one alone by 1/(1 - K C).) The
  /// bound is exact for two contacts, at most 13 % too large for seven, and 21 % for twenty.
  /// Infinite if the compliances are not positive definite. Costs 4 N³ multiply-adds: too much for
  /// every tick with many contacts.
  double stiffening() noexcept;
  /// As ToolContact::cappedShare(), for a limit on the stiffness of all contacts together.
  double cappedShare(std::size_t contact, double maximumStiffness) noexcept;

private:
  /// State of one contact in this tick.
  struct Load
  {
    Pressed found;
    Pressed pressed; ///< if the tool presses: `found` with its depth on a surface that no other
                     ///< contact lowers
    bool presses = false;
    double sunk = 0.0;
    double force = 0.0;
    double before = 0.0; ///< force in the preceding tick, N
    double stiffness = 0.0;
    BodyCoupling::Spot spot;
    double whole = 0.0;     ///< force of the curve, N, even if it does not act on the tool
    bool isMissing = false; ///< there is no pose in this tick
    /// The tool had no force in the last tick although its curve had one: its contact ended at an
    /// edge, or the relaxing body was still dented below the tool.
    bool isOff = false;

    double appliedForce() const noexcept { return this->isOff ? 0.0 : this->whole; }
    bool counts() const noexcept { return this->force > 0.0 && this->stiffness > 0.0; }
  };

  template <class Find>
  const std::vector<Contact>& feelAll(const Find& find, int rounds) noexcept;
  const std::vector<Contact>& solve(int rounds) noexcept;
  void load(std::size_t contact) noexcept;
  void fillCompliances() noexcept;
  /// Returns the lowering of the surface at a contact by the other contacts, mm.
  double sunkBy(std::size_t contact) const noexcept;
  /// Evaluates the curve of a contact at its depth less sunkBy(). Returns the change of its force,
  /// N.
  double press(std::size_t contact) noexcept;
  /// Makes one round of Gauss-Seidel. Returns the largest change of a force over the largest force.
  double goRound() noexcept;
  /// Makes one step of Newton's method, for up to MostSolved contacts. Returns the same ratio as
  /// goRound().
  double solveRound() noexcept;
  void addSideForce(std::size_t contact, Contact& felt) const noexcept;
  /// Writes the compliances of the contacts with a force, times `factor`, row by row: 1/K_i on the
  /// diagonal, C_ij elsewhere. Returns the number of these contacts.
  std::size_t gatherCompliances(double factor, double* matrix) const noexcept;
  double& compliance(std::size_t i, std::size_t j) noexcept
  {
    return this->Compliance[i * this->Contacts.size() + j];
  }
  double compliance(std::size_t i, std::size_t j) const noexcept
  {
    return this->Compliance[i * this->Contacts.size() + j];
  }

  const ContactBody& Body;
  ContactSettings Settings;
  std::vector<ToolContact> Contacts;
  std::vector<Load> Loads;
  std::vector<Contact> Felt;
  std::vector<double> Compliance; ///< C_ij, row by row
  std::vector<double> Work;
  double Stiffening = 0.0; ///< stiffening() of the last update; 0: not computed yet
};
} // namespace palpate

#endif

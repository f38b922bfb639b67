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
 * Several tools on one body. The force of each tool lowers the surface under the other tools:
 *   δ_i = δ_local,i(F_i) + Σ_j C_ij F_j,  F_i >= 0,
 * where δ_i is the depth of tool i and C_ij comes from BodyCoupling. A tick finds all contacts and
 * starts with forces extrapolated from the two preceding ticks. It then computes two rounds over
 * the contacts, F_i ← F_i,slow(δ_i - Σ_{j≠i} C_ij F_j) (Gauss-Seidel). Finally each ToolContact is
 * evaluated at the remaining part of its depth, which is Contact::deflection. A tool without
 * remaining depth has no force but is still followed. With up to MostSolved tools, a round is a
 * step of Newton's method instead. Newton's method also converges for fingers that pinch a slender
 * body, where Gauss-Seidel does not.
 *
 * After two rounds at 200 mm/s and 1 kHz, the residual is less than 1e-3 of the force for 10
 * contacts, and less than 5e-3 for 20. On a body that relaxes, only the slow forces lower the
 * surface under the other tools.
 *
 * With ForceForm::EnergyConsistent each tool is also drawn towards the other tools along the
 * surface by the force
 *   F_i F_j ∂C_ij/∂x_i.
 * Then all forces derive from the energy Σ δ_i F_i - Σ U*_i(F_i) - Σ_{i<j} C_ij F_i F_j of the body
 * on any path of the contacts, with two exceptions: the residual after two rounds (2e-6 F δ per
 * period of two tools that press a quarter period apart), and contacts that are nearer to each
 * other than the sum of their radii. This does not apply to a body that relaxes.
 *
 * For a body without coupling, and for a single contact, the results are bit for bit those of
 * ToolContact. update() neither allocates, locks nor throws. Its cost is bounded: N² multiply-adds
 * and N evaluations of a curve per round. Each thread needs its own object. Objects may share the
 * body, which must outlive them.
 */
class PALPATE_EXPORT CoupledContacts
{
public:
  static constexpr std::size_t Most = 64;
  static constexpr int Rounds = 2;          ///< number of rounds per tick
  static constexpr int SettlingRounds = 64; ///< largest number of rounds of settle()
  static constexpr std::size_t MostSolved = 8;

  /// `count` is clamped to the range 1 to Most.
  CoupledContacts(const ContactBody& body, const ContactSettings& settings, std::size_t count);

  std::size_t count() const noexcept { return this->Contacts.size(); }

  /// Evaluates all contacts. `poses` has one pose for each contact. A contact whose pose is not
  /// finite is Invalid and does not act on the other contacts. The results are valid until the next
  /// update. Without `elapsed` the slow response is used. With `elapsed` the forces are those
  /// `elapsed` s after the last update.
  const std::vector<Contact>& update(const ToolPose* poses) noexcept;
  const std::vector<Contact>& update(const ToolPose* poses, double elapsed) noexcept;
  /// As update(), but iterates until the forces have converged to rounding error, independent of
  /// the preceding forces; at most SettlingRounds rounds.
  const std::vector<Contact>& settle(const ToolPose* poses) noexcept;
  const std::vector<Contact>& settle(const ToolPose* poses, double elapsed) noexcept;

  /// Computes one tick of a servo loop, `elapsed` s after the last tick. A contact without a pose
  /// is kept: its result is Invalid, it does not act on the other contacts, and only its relaxation
  /// time advances. If only one contact has a pose, its ToolContact is evaluated alone, and
  /// stiffness() does not include the contact.
  const std::vector<Contact>& step(const std::optional<ToolPose>* poses, double elapsed) noexcept;
  /// Moves one contact to a pose without advancing time. The next tick continues from this pose.
  void move(std::size_t contact, const ToolPose& pose) noexcept
  {
    this->Contacts[contact].update(pose);
  }
  /// Takes over the friction state of the same contact in another scene; see ToolContact.
  void assumeFriction(std::size_t contact, const CoupledContacts& other) noexcept
  {
    this->Contacts[contact].assumeFriction(other.Contacts[contact]);
  }
  /// Takes over the state of the contacts of `other`, which has the same number of contacts on the
  /// same body. Does not allocate.
  void assume(const CoupledContacts& other) noexcept;

  const std::vector<Contact>& felt() const noexcept { return this->Felt; }
  /// Returns the lowering of the surface at a contact by the other contacts, mm.
  double sunk(std::size_t contact) const noexcept { return this->Loads[contact].sunk; }

  /// Returns the relative error of a contact's force, 0 to 1, due to the approximation of the other
  /// contacts as point forces (BodyCoupling::pointForceError).
  double pointForceError(std::size_t contact) const noexcept;

  /// The following functions apply the function of ToolContact with the same name to all contacts.
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
  /// Ends one contact. It then no longer acts on the other contacts.
  void lose(std::size_t contact) noexcept;

  /// Returns the derivatives of the slow normal forces of the last update with respect to the
  /// depths, ∂F_i/∂δ_j, N/mm. The matrix is the inverse of the matrix with 1/K_i on the diagonal
  /// and C_ij elsewhere. Rows and columns of contacts without force are zero. The function
  /// allocates and needs N³ multiply-adds: do not use it in a tick.
  Eigen::MatrixXd stiffness() const;
  /// Returns an upper bound, at least 1, of the stiffness of all contacts of the last update
  /// together, divided by the stiffness of the stiffest single contact. No combined motion of the
  /// contacts is stiffer than this bound. (Two contacts that move in opposite directions are
  /// stiffer than one contact by the factor 1/(1 - K C).) The bound is exact for two contacts, at
  /// most 13 % too large for seven, and at most 21 % too large for twenty. It is infinite if the
  /// compliances are not positive definite. The cost is 4 N³ multiply-adds, too much for every tick
  /// if there are many contacts.
  double stiffening() noexcept;
  /// As ToolContact::cappedShare(), with `maximumStiffness` (N/mm) as the limit of the stiffness of
  /// all contacts together.
  double cappedShare(std::size_t contact, double maximumStiffness) noexcept;

private:
  /// State of one contact in this tick.
  struct Load
  {
    Pressed found;
    /// `found` with its depth on a surface that no other contact lowers. Set only if the tool
    /// presses.
    Pressed pressed;
    bool presses = false;
    double sunk = 0.0;
    double force = 0.0;
    double before = 0.0; ///< force in the preceding tick, N
    double stiffness = 0.0;
    BodyCoupling::Spot spot;
    double whole = 0.0;     ///< force of the curve, N, even if this force does not act on the tool
    bool isMissing = false; ///< whether the contact has no pose in this tick
    /// Whether the tool had no force in the last tick although its curve had a force. Reasons: the
    /// contact ended at an edge, or the relaxing body was still dented below the tool.
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
  /// Evaluates the curve of a contact at its depth minus sunkBy(). Returns the change of its force,
  /// N.
  double press(std::size_t contact) noexcept;
  /// Computes one round of Gauss-Seidel. Returns the largest change of a force, divided by the
  /// largest force.
  double goRound() noexcept;
  /// Computes one step of Newton's method, for up to MostSolved contacts. Returns the same ratio as
  /// goRound().
  double solveRound() noexcept;
  void addSideForce(std::size_t contact, Contact& felt) const noexcept;
  /// Writes the compliances of the contacts that have a force, multiplied by `factor`, row by row:
  /// 1/K_i on the diagonal, C_ij elsewhere. Returns the number of these contacts.
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
  /// Result of stiffening() for the last update; 0 if it is not computed yet.
  double Stiffening = 0.0;
};
} // namespace palpate

#endif

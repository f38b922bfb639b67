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
#include <vector>

namespace palpate
{
/**
 * Several tools on one body that act on one another: each lowers the surface under the others,
 *   δ_i = δ_local,i(F_i) + Σ_j C_ij F_j,  F_i >= 0,
 * where δ_i is the depth of tool i and C_ij comes from BodyCoupling. A tick finds all contacts and
 * starts with forces extrapolated from the two ticks before. It then makes two rounds over the
 * contacts, F_i ← F_i,slow(δ_i - Σ_{j≠i} C_ij F_j) (Gauss-Seidel). Finally each ToolContact is
 * evaluated at the remaining part of its depth, which is Contact::deflection. A tool without
 * remaining depth has no force but is still followed. For up to MostSolved tools a round is a step
 * of Newton's method instead. That also finds the forces of fingers that pinch a slender body, for
 * which the rounds of Gauss-Seidel do not converge.
 *
 * After two rounds the residual is less than 1e-3 of the force for 10 contacts at 200 mm/s and
 * 1 kHz, and 5e-3 for 20. On a body that relaxes, only the slow forces lower the surface under the
 * other tools. Near sharp edges and beyond borders, the force that acts on the others is
 * approximately the reduced force at that depth.
 *
 * With ForceForm::EnergyConsistent each tool is also drawn towards the others along the surface by
 *   F_i F_j ∂C_ij/∂x_i.
 * With this force the forces have the energy Σ δ_i F_i - Σ U*_i(F_i) - Σ_{i<j} C_ij F_i F_j of the
 * body on any path of the contacts, except for the residual of two rounds (2e-6 F δ per period of
 * two tools that press a quarter period apart) and where they are held apart at the sum of their
 * radii. This does not hold for a body that relaxes, nor near edges.
 *
 * For a body without coupling, and for one contact, the results are bit by bit those of
 * ToolContact. update() does not allocate, lock or throw. It costs N² multiply-adds and N curves
 * per round, which is bounded. One object serves one thread; the body may be shared and must
 * outlive it.
 */
class PALPATE_EXPORT CoupledContacts
{
public:
  static constexpr std::size_t Most = 64;
  static constexpr int Rounds = 2;          ///< rounds per tick
  static constexpr int SettlingRounds = 64; ///< at most, until forces are exact to rounding
  static constexpr std::size_t MostSolved = 8;

  /// `count` is limited to 1 to Most.
  CoupledContacts(const ContactBody& body, const ContactSettings& settings, std::size_t count);

  std::size_t count() const noexcept { return this->Contacts.size(); }

  /// One pose for each contact. A contact whose pose is not finite is Invalid and does not act on
  /// the others. The results are valid until the next update. Without `elapsed`: the slow response;
  /// with it: the force `elapsed` s after the last update.
  const std::vector<Contact>& update(const ToolPose* poses) noexcept;
  const std::vector<Contact>& update(const ToolPose* poses, double elapsed) noexcept;
  /// The same, solved to rounding whatever the forces were before; SettlingRounds at most.
  const std::vector<Contact>& settle(const ToolPose* poses) noexcept;
  const std::vector<Contact>& settle(const ToolPose* poses, double elapsed) noexcept;

  const std::vector<Contact>& felt() const noexcept { return this->Felt; }
  /// How far the others lower the surface at a contact, mm.
  double sunk(std::size_t contact) const noexcept { return this->Loads[contact].sunk; }

  /// Relative error of a contact's force because the others act on it as point forces
  /// (BodyCoupling::pointForceError), 0 to 1.
  double pointForceError(std::size_t contact) const noexcept;

  /// The functions of ToolContact of these names, for all contacts.
  void pass(double elapsed) noexcept;
  void reset() noexcept;
  void lose() noexcept;
  void foresee() const noexcept;
  void rehearse(double elapsed) const noexcept;
  /// One contact is lost and no longer acts on the others.
  void lose(std::size_t contact) noexcept;

  /// Derivatives of the slow normal forces of the last update by the depths, N/mm: ∂F_i/∂δ_j, row
  /// by row. This is the inverse of the matrix with 1/K_i on the diagonal and C_ij elsewhere; zero
  /// for contacts without force. Allocates, N³ multiply-adds: not for use in a tick.
  Eigen::MatrixXd stiffness() const;
  /// Upper bound of the stiffness of the contacts of the last update together, over that of the
  /// stiffest contact alone; at least 1. No motion of the contacts, in or out, is stiffer than
  /// that. (The opposite motion of two contacts is stiffer than one alone by 1/(1 - K C).) The
  /// bound is exact for two contacts, at most 13 % too large for seven, and 21 % for twenty.
  /// Infinite if the compliances are not positive definite. 4 N³ multiply-adds: not for every tick
  /// with many contacts.
  double stiffening() noexcept;
  /// ToolContact::cappedShare for a limit on the stiffness of all contacts together.
  double cappedShare(std::size_t contact, double maximumStiffness) noexcept;

private:
  /// State of one contact in this tick.
  struct Load
  {
    ContactTracker::Result found;
    ToolContact::Pressed pressed; ///< if it presses
    bool presses = false;
    double sunk = 0.0;
    double force = 0.0;
    double before = 0.0; ///< force in the tick before
    double stiffness = 0.0;
    BodyCoupling::Spot spot;
    double whole = 0.0; ///< force of the curve, even if the tool does not get it
    /// The tool had no force in the last tick although the curve had: an edge released it, or the
    /// relaxing body has not come back to it.
    bool isOff = false;

    double felt() const noexcept { return this->isOff ? 0.0 : this->whole; }
    bool counts() const noexcept { return this->force > 0.0 && this->stiffness > 0.0; }
  };

  const std::vector<Contact>& feelAll(int rounds) noexcept;
  template <class Find>
  void findAll(const Find& find) noexcept;
  const std::vector<Contact>& settleAll() noexcept;
  void load(std::size_t contact) noexcept;
  void fillCompliances() noexcept;
  /// How far the others lower the surface at a contact, mm.
  double sunkBy(std::size_t contact) const noexcept;
  /// Evaluates the curve of a contact at the part of its depth that the others leave. Returns the
  /// change of its force, N.
  double press(std::size_t contact) noexcept;
  /// One round of Gauss-Seidel. Returns the largest change of a force over the largest force.
  double goRound() noexcept;
  /// The same by Newton's method, for up to MostSolved contacts.
  double solveRound() noexcept;
  void addSideForce(std::size_t contact, Contact& felt) const noexcept;
  /// Writes the compliances of the contacts that count, times `factor`, row by row: 1/K_i on the
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
  double Stiffening = 0.0; ///< of the last update; 0: not computed yet
};
} // namespace palpate

#endif

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
 * Several tools on one body that feel one another: each lets the surface down under the others,
 *   δ_i = δ_local,i(F_i) + Σ_j C_ij F_j,  F_i >= 0,
 * δ_i the depth of tool i, C_ij of BodyCoupling. A tick finds all contacts, goes twice around them,
 * F_i ← F_i,slow(δ_i - Σ_{j≠i} C_ij F_j) from the forces of the two ticks before, extrapolated
 * (Gauss and Seidel), and lets each ToolContact feel what is left of its depth. Contact::deflection
 * is that rest. Where nothing is left the tool has no force, and is followed all the same. Of up to
 * MostSolved tools a round is a step of Newton's method instead, which also finds the forces of
 * fingers that pinch a slender body, for which Gauss and Seidel's rounds do not converge.
 *
 * Two rounds leave less than 1e-3 of the force at 200 mm/s and 1 kHz (10 contacts; 5e-3: 20), and
 * a body that relaxes is let down by its slow forces alone. Beside sharp edges and beyond borders
 * the others feel what is left there of the force at that depth, about.
 *
 * With ForceForm::EnergyConsistent each tool is also drawn towards the others by
 *   F_i F_j ∂C_ij/∂x_i
 * along the surface: with it the forces have the energy Σ δ_i F_i - Σ U*_i(F_i) - Σ_{i<j} C_ij F_i
 * F_j of the body, wherever the contacts go, but for what two rounds leave (2e-6 F δ in a turn of
 * two tools a quarter of it apart) and where they are held apart at the sum of their radii. Not of
 * a body that relaxes, nor near edges.
 *
 * Of a body without coupling, and of one contact, every bit is that of ToolContacts alone. Neither
 * update allocates, locks or throws; they cost N² multiply-adds and N curves a round, bounded. One
 * of these serves one thread; the body may be shared and must outlive it.
 */
class PALPATE_EXPORT CoupledContacts
{
public:
  static constexpr std::size_t Most = 64;
  static constexpr int Rounds = 2;          ///< of a tick
  static constexpr int SettlingRounds = 64; ///< at most, to the last bits
  static constexpr std::size_t MostSolved = 8;

  /// `count` is taken within 1 to Most.
  CoupledContacts(const ContactBody& body, const ContactSettings& settings, std::size_t count);

  std::size_t count() const noexcept { return this->Contacts.size(); }

  /// One pose for each contact; one that is not finite is Invalid, and the others do not feel it.
  /// What each feels is there until the next: of the slow response, or `elapsed` s after the last.
  const std::vector<Contact>& update(const ToolPose* poses) noexcept;
  const std::vector<Contact>& update(const ToolPose* poses, double elapsed) noexcept;
  /// The same to the last bits, whatever the forces were before: SettlingRounds at most.
  const std::vector<Contact>& settle(const ToolPose* poses) noexcept;
  const std::vector<Contact>& settle(const ToolPose* poses, double elapsed) noexcept;

  const std::vector<Contact>& felt() const noexcept { return this->Felt; }
  /// By how much the others have let the surface down at a contact, mm.
  double sunk(std::size_t contact) const noexcept { return this->Loads[contact].sunk; }

  /// The functions of ToolContact of these names, for all contacts.
  void pass(double elapsed) noexcept;
  void reset() noexcept;
  void lose() noexcept;
  void foresee() const noexcept;
  void rehearse(double elapsed) const noexcept;
  /// One contact is lost, and the others feel it no more.
  void lose(std::size_t contact) noexcept;

  /// By how much the slow normal force of each contact of the last update rises with the depth of
  /// each, N/mm: ∂F_i/∂δ_j, row by row, the inverse of 1/K_i on the diagonal and C_ij beside it;
  /// zero where one has no force. Allocates, N³ multiply-adds: not in a tick.
  Eigen::MatrixXd stiffness() const;
  /// By how much the contacts of the last update are stiffer together than the stiffest of them
  /// alone, at least 1: no motion of them, in or out, is stiffer than that (the opposite motion of
  /// two is, by 1/(1 - K C)). A bound: exact for two, at most 13 % too large for seven, 21 % for
  /// twenty. Infinite where the compliances are not positive definite. 4 N³ multiply-adds: not in
  /// each tick of many.
  double stiffening() noexcept;
  /// ToolContact::cappedShare where the stiffness of all together is to be no larger.
  double cappedShare(std::size_t contact, double maximumStiffness) noexcept;

private:
  /// A contact in this tick.
  struct Load
  {
    ContactTracker::Result found;
    ToolContact::Pressed pressed; ///< if it presses
    bool presses = false;
    double sunk = 0.0;
    double force = 0.0;
    double before = 0.0; ///< of the tick before
    double stiffness = 0.0;
    BodyCoupling::Spot spot;
    double whole = 0.0; ///< the force of the curve, also where the tool does not feel it
    /// The tool felt nothing of it: an edge let it go, or a body that relaxes has not come back.
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
  /// By how much the others let a contact down, mm.
  double sunkBy(std::size_t contact) const noexcept;
  /// Evaluates the curve of a contact at what the others leave of its depth. Returns by how much
  /// its force has changed, N.
  double press(std::size_t contact) noexcept;
  /// One round of Gauss and Seidel. Returns the largest change of a force over the largest force.
  double goRound() noexcept;
  /// The same by Newton's method, of up to MostSolved contacts.
  double solveRound() noexcept;
  void addSideForce(std::size_t contact, Contact& felt) const noexcept;
  /// Writes the compliances of the contacts that count, times `factor`, row by row: 1/K_i on the
  /// diagonal, C_ij beside it. Returns how many contacts these are.
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
  double Stiffening = 0.0; ///< of the last update; 0: nobody has asked
};
} // namespace palpate

#endif

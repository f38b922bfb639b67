// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/Coupled/CoupledContacts.h"

#include "Contact/BorderFade.h"
#include "Contact/Coupled/StiffnessBound.h"
#include "Contact/EnergyGradient.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
/// Forces that change by less in a round, as part of the largest, are settled.
constexpr double Settled = 1e-14;
} // namespace

CoupledContacts::CoupledContacts(
  const ContactBody& body, const ContactSettings& settings, std::size_t count)
  : Body(body)
  , Settings(settings)
{
  const std::size_t number = std::clamp<std::size_t>(count, 1, Most);
  this->Contacts.reserve(number);
  for (std::size_t i = 0; i < number; ++i)
  {
    this->Contacts.emplace_back(body, settings);
  }
  this->Loads.resize(number);
  this->Felt.resize(number);
  this->Compliance.resize(number * number);
  this->Work.resize(2 * number * number);
}

const std::vector<Contact>& CoupledContacts::update(const ToolPose* poses) noexcept
{
  for (std::size_t i = 0; i < this->Contacts.size(); ++i)
  {
    this->Loads[i].found = this->Contacts[i].find(poses[i]);
    this->load(i);
  }
  return this->feelAll(Rounds);
}

const std::vector<Contact>& CoupledContacts::update(const ToolPose* poses, double elapsed) noexcept
{
  for (std::size_t i = 0; i < this->Contacts.size(); ++i)
  {
    this->Loads[i].found = this->Contacts[i].find(poses[i], elapsed);
    this->load(i);
  }
  return this->feelAll(Rounds);
}

const std::vector<Contact>& CoupledContacts::settle(const ToolPose* poses) noexcept
{
  for (std::size_t i = 0; i < this->Contacts.size(); ++i)
  {
    this->Loads[i].found = this->Contacts[i].find(poses[i]);
    this->load(i);
    this->Loads[i].force = 0.0;
  }
  return this->feelAll(SettlingRounds);
}

const std::vector<Contact>& CoupledContacts::settle(const ToolPose* poses, double elapsed) noexcept
{
  for (std::size_t i = 0; i < this->Contacts.size(); ++i)
  {
    this->Loads[i].found = this->Contacts[i].find(poses[i], elapsed);
    this->load(i);
    this->Loads[i].force = 0.0;
  }
  return this->feelAll(SettlingRounds);
}

void CoupledContacts::load(std::size_t contact) noexcept
{
  Load& load = this->Loads[contact];
  load.sunk = 0.0;
  load.presses = this->Body.coupling && this->place(contact);
  if (!load.presses)
  {
    load.force = 0.0;
    load.before = 0.0;
    load.whole = 0.0;
    load.stiffness = 0.0;
    load.isOff = false;
    return;
  }
  // As it went in the tick before.
  const double last = load.force;
  load.force = last > 0.0 && load.before > 0.0 ? std::max(0.0, 2.0 * last - load.before) : last;
  load.before = last;
  load.spot = this->Body.coupling->at(
    load.place.triangle, load.place.projection.weights, this->slow(contact, load.depth).stiffness);
}

bool CoupledContacts::place(std::size_t contact) noexcept
{
  Load& load = this->Loads[contact];
  const Vector3& tip = this->Contacts[contact].followed();
  using Outcome = ContactTracker::Outcome;
  const Outcome outcome = load.found.outcome;
  if (outcome == Outcome::Outside || outcome == Outcome::Invalid)
  {
    return false;
  }
  const PackedMesh& surface = this->Body.surface;
  ContactPlace& place = load.place;
  place = load.found.place;
  const TriangleCorners& corners = surface.corners(place.triangle);
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (place.projection.weights[static_cast<Eigen::Index>(k)] != 0.0 &&
      !this->Body.response.isValid(corners[k]))
    {
      return false;
    }
  }
  load.share = 1.0;
  const double under = this->Contacts[contact].underTool(place);
  if (outcome == Outcome::Border)
  {
    const BorderFade left = BorderFade::at(
      surface, place.triangle, place.projection.weights, tip - place.projection.point);
    load.depth = left.depth - under;
    load.share = left.fraction;
    place.weightGradients.setZero();
    return load.depth > 0.0 && load.share > 0.0;
  }
  const bool isAtEdge =
    outcome == Outcome::Crease || (this->Body.edges && this->Body.edges->areNear(place.triangle));
  if (!place.isSmooth &&
    (isAtEdge ||
      (this->Settings.form == ForceForm::EnergyConsistent &&
        this->Settings.surface == ContactSurface::Facets)))
  {
    place = EnergyGradient::onFacet(surface, tip, place);
  }
  load.depth = -place.signedDistance - under;
  if (isAtEdge)
  {
    const Vector3 normal = place.onCrease ? surface.faceNormal(place.triangle) : place.normal;
    const Vector3 pressed = tip + under * normal;
    const double depth = normal.dot(place.projection.point - pressed);
    const EdgeEffect effect =
      this->Body.edges->at(surface.toLocal(pressed), place.triangle, normal, depth);
    const BlendedResponse response(this->Body.response, corners, place.projection.weights);
    const double whole = response.evaluate(effect.depth).force;
    load.depth = effect.depth;
    load.share =
      effect.share + (whole > 0.0 ? response.energy(effect.depth) * effect.byDepth / whole : 0.0);
  }
  return load.depth > 0.0 && load.share > 0.0;
}

ResponseValue CoupledContacts::slow(std::size_t contact, double depth) const noexcept
{
  const Load& load = this->Loads[contact];
  ResponseValue value = this->Contacts[contact].slowResponse(load.place, depth);
  value.force *= load.share;
  value.stiffness *= load.share;
  return value;
}

void CoupledContacts::fillCompliances() noexcept
{
  for (std::size_t i = 0; i < this->Loads.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const bool areBoth = this->Loads[i].presses && this->Loads[j].presses;
      const double between =
        areBoth ? this->Body.coupling->compliance(this->Loads[i].spot, this->Loads[j].spot) : 0.0;
      this->compliance(i, j) = between;
      this->compliance(j, i) = between;
    }
  }
}

double CoupledContacts::sunkBy(std::size_t contact) const noexcept
{
  const double* row = this->Compliance.data() + contact * this->Loads.size();
  double sum = 0.0;
  for (std::size_t j = 0; j < this->Loads.size(); ++j)
  {
    sum += j == contact ? 0.0 : row[j] * this->Loads[j].force;
  }
  return sum;
}

double CoupledContacts::goRound() noexcept
{
  double largest = 0.0;
  double change = 0.0;
  for (std::size_t i = 0; i < this->Loads.size(); ++i)
  {
    Load& load = this->Loads[i];
    if (!load.presses)
    {
      continue;
    }
    load.sunk = this->sunkBy(i);
    const ResponseValue value = this->slow(i, load.depth - load.sunk);
    change = std::max(change, std::abs(value.force - load.whole));
    largest = std::max(largest, value.force);
    load.whole = std::isfinite(value.force) ? value.force : 0.0;
    load.force = load.isOff ? 0.0 : load.whole;
    load.stiffness = value.stiffness;
  }
  return largest > 0.0 ? change / largest : 0.0;
}

double CoupledContacts::solveRound() noexcept
{
  // (1/K_i) ΔF_i + Σ_j C_ij ΔF_j = (f_i - F_i)/K_i, of those that touch; the others come to none.
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, MostSolved, MostSolved>;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, MostSolved, 1>;
  std::array<std::size_t, MostSolved> active{};
  std::array<double, MostSolved> lack{}; // f_i - F_i
  Eigen::Index rows = 0;
  double largest = 0.0;
  double change = 0.0;
  for (std::size_t i = 0; i < this->Loads.size(); ++i)
  {
    Load& load = this->Loads[i];
    if (!load.presses)
    {
      continue;
    }
    load.sunk = this->sunkBy(i);
    const ResponseValue value = this->slow(i, load.depth - load.sunk);
    load.whole = std::isfinite(value.force) ? value.force : 0.0;
    load.stiffness = value.stiffness;
    largest = std::max(largest, load.whole);
    const double felt = load.isOff ? 0.0 : load.whole;
    lack[i] = felt - load.force;
    change = std::max(change, std::abs(lack[i]));
    if (felt > 0.0 && load.stiffness > 0.0)
    {
      active[static_cast<std::size_t>(rows++)] = i;
    }
  }
  const auto isActive = [&](std::size_t i)
  { return std::find(active.begin(), active.begin() + rows, i) != active.begin() + rows; };
  Matrix system(rows, rows);
  Vector right(rows);
  for (Eigen::Index r = 0; r < rows; ++r)
  {
    const std::size_t i = active[static_cast<std::size_t>(r)];
    const double own = 1.0 / this->Loads[i].stiffness;
    right[r] = own * lack[i];
    for (std::size_t j = 0; j < this->Loads.size(); ++j)
    {
      right[r] -= j == i || isActive(j) ? 0.0 : this->compliance(i, j) * lack[j];
    }
    for (Eigen::Index k = 0; k < rows; ++k)
    {
      const std::size_t j = active[static_cast<std::size_t>(k)];
      system(r, k) = j == i ? own : this->compliance(i, j);
    }
  }
  const Eigen::LLT<Eigen::Ref<Matrix>> factor(system);
  const bool isSolved = factor.info() == Eigen::Success;
  if (isSolved)
  {
    factor.solveInPlace(right);
  }
  for (std::size_t i = 0; i < this->Loads.size(); ++i)
  {
    this->Loads[i].force += this->Loads[i].presses && !isActive(i) ? lack[i] : 0.0;
  }
  for (Eigen::Index r = 0; r < rows; ++r)
  {
    const std::size_t i = active[static_cast<std::size_t>(r)];
    Load& load = this->Loads[i];
    // Compliances that are no body's: as if the others stayed.
    load.force = std::max(0.0, load.force + (isSolved ? right[r] : lack[i]));
  }
  return largest > 0.0 ? change / largest : 0.0;
}

const std::vector<Contact>& CoupledContacts::feelAll(int rounds) noexcept
{
  if (this->Body.coupling)
  {
    this->fillCompliances();
    const bool isSolved = this->Loads.size() <= MostSolved;
    double change = 1.0;
    for (int round = 0; round < rounds && change > Settled; ++round)
    {
      change = isSolved ? this->solveRound() : this->goRound();
    }
  }
  for (std::size_t i = 0; i < this->Contacts.size(); ++i)
  {
    Load& load = this->Loads[i];
    Contact& felt = this->Felt[i];
    load.sunk = load.presses ? this->sunkBy(i) : 0.0;
    felt = this->Contacts[i].feel(load.found, load.sunk);
    if (load.force > 0.0 && felt.normalForce > 0.0 &&
      this->Settings.form == ForceForm::EnergyConsistent)
    {
      this->addSideForce(i, felt);
    }
  }
  for (std::size_t i = 0; i < this->Contacts.size(); ++i)
  {
    this->Loads[i].isOff = this->Loads[i].whole > 0.0 && !(this->Felt[i].normalForce > 0.0);
  }
  return this->Felt;
}

void CoupledContacts::addSideForce(std::size_t contact, Contact& felt) const noexcept
{
  const Load& own = this->Loads[contact];
  Vector3 byWeights = Vector3::Zero();
  bool hasOthers = false;
  for (std::size_t j = 0; j < this->Loads.size(); ++j)
  {
    const Load& other = this->Loads[j];
    if (j != contact && other.force > 0.0)
    {
      hasOthers = true;
      byWeights +=
        other.force * this->Body.coupling->gradient(own.spot, own.place.triangle, other.spot);
    }
  }
  // As the area coordinates sum to 1, a common constant of the derivatives is nothing.
  const Eigen::Matrix3d& gradients = own.place.weightGradients;
  const Vector3 side = own.force *
    (gradients.col(1) * (byWeights[1] - byWeights[0]) +
      gradients.col(2) * (byWeights[2] - byWeights[0]));
  if (hasOthers && side.allFinite())
  {
    felt.force += side;
  }
}

void CoupledContacts::pass(double elapsed) noexcept
{
  for (ToolContact& contact : this->Contacts)
  {
    contact.pass(elapsed);
  }
}

void CoupledContacts::reset() noexcept
{
  for (std::size_t i = 0; i < this->Contacts.size(); ++i)
  {
    this->Contacts[i].reset();
    this->Loads[i] = Load{};
  }
}

void CoupledContacts::lose() noexcept
{
  for (std::size_t i = 0; i < this->Contacts.size(); ++i)
  {
    this->lose(i);
  }
}

void CoupledContacts::lose(std::size_t contact) noexcept
{
  this->Contacts[contact].lose();
  this->Loads[contact] = Load{};
}

void CoupledContacts::foresee() const noexcept
{
  for (const ToolContact& contact : this->Contacts)
  {
    contact.foresee();
  }
}

double CoupledContacts::stiffening() noexcept
{
  std::size_t rows = 0;
  double stiffest = 0.0;
  for (const Load& load : this->Loads)
  {
    const bool counts = load.force > 0.0 && load.stiffness > 0.0;
    rows += counts ? 1 : 0;
    stiffest = counts ? std::max(stiffest, load.stiffness) : stiffest;
  }
  if (rows < 2)
  {
    return 1.0;
  }
  std::size_t next = 0;
  for (std::size_t i = 0; i < this->Loads.size(); ++i)
  {
    for (std::size_t j = 0; j < this->Loads.size(); ++j)
    {
      const Load& one = this->Loads[i];
      const Load& other = this->Loads[j];
      if (one.force > 0.0 && one.stiffness > 0.0 && other.force > 0.0 && other.stiffness > 0.0)
      {
        this->Work[next++] = stiffest * (i == j ? 1.0 / one.stiffness : this->compliance(i, j));
      }
    }
  }
  double* matrix = this->Work.data();
  return std::max(1.0, stiffnessBound(matrix, matrix + rows * rows, rows));
}

double CoupledContacts::cappedShare(std::size_t contact, double maximumStiffness) noexcept
{
  return this->Contacts[contact].cappedShare(
    this->Felt[contact], maximumStiffness / this->stiffening());
}
} // namespace palpate

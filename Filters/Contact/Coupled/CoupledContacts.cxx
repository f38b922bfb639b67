// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/Coupled/CoupledContacts.h"

#include "Contact/Coupled/StiffnessBound.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
/// The forces have converged if the largest change in a round is below this fraction of the largest
/// force.
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

template <class Find>
[[gnu::hot]] const std::vector<Contact>& CoupledContacts::feelAll(
  const Find& find, int rounds) noexcept
{
  for (std::size_t i = 0; i < this->Contacts.size(); ++i)
  {
    this->Loads[i].isMissing = false;
    this->Loads[i].found = find(i);
    this->load(i);
    if (rounds > Rounds)
    {
      this->Loads[i].force = 0.0;
    }
  }
  return this->solve(rounds);
}

const std::vector<Contact>& CoupledContacts::update(const ToolPose* poses) noexcept
{
  return this->feelAll([&](std::size_t i) { return this->Contacts[i].find(poses[i]); }, Rounds);
}

const std::vector<Contact>& CoupledContacts::update(const ToolPose* poses, double elapsed) noexcept
{
  return this->feelAll(
    [&](std::size_t i) { return this->Contacts[i].find(poses[i], elapsed); }, Rounds);
}

const std::vector<Contact>& CoupledContacts::settle(const ToolPose* poses) noexcept
{
  return this->feelAll(
    [&](std::size_t i) { return this->Contacts[i].find(poses[i]); }, SettlingRounds);
}

const std::vector<Contact>& CoupledContacts::settle(const ToolPose* poses, double elapsed) noexcept
{
  return this->feelAll(
    [&](std::size_t i) { return this->Contacts[i].find(poses[i], elapsed); }, SettlingRounds);
}

[[gnu::hot]] const std::vector<Contact>& CoupledContacts::step(
  const std::optional<ToolPose>* poses, double elapsed) noexcept
{
  if (this->Contacts.size() == 1 && poses[0])
  {
    this->Felt[0] = this->Contacts[0].update(*poses[0], elapsed);
    return this->Felt;
  }
  const auto find = [&](std::size_t i)
  {
    if (poses[i])
    {
      return this->Contacts[i].find(*poses[i], elapsed);
    }
    this->Contacts[i].pass(elapsed);
    this->Loads[i].isMissing = true;
    return Pressed();
  };
  return this->feelAll(find, Rounds);
}

void CoupledContacts::assume(const CoupledContacts& other) noexcept
{
  this->Contacts.clear();
  for (const ToolContact& contact : other.Contacts) // a contact can be copied, but not assigned
  {
    this->Contacts.push_back(contact);
  }
  this->Loads = other.Loads;
}

[[gnu::hot]] void CoupledContacts::load(std::size_t contact) noexcept
{
  Load& load = this->Loads[contact];
  Pressed& pressed = load.pressed;
  load.sunk = 0.0;
  load.presses = this->Body.coupling && this->Contacts[contact].press(pressed = load.found);
  if (!load.presses)
  {
    load.force = 0.0;
    load.before = 0.0;
    load.whole = 0.0;
    load.stiffness = 0.0;
    load.isOff = false;
    return;
  }
  // Extrapolates the force from the two preceding ticks.
  const double last = load.force;
  load.force = last > 0.0 && load.before > 0.0 ? std::max(0.0, 2.0 * last - load.before) : last;
  load.before = last;
  load.spot = this->Body.coupling->at(pressed.place().triangle, pressed.place().projection.weights,
    this->Contacts[contact].slowResponse(pressed, pressed.reach.depth).stiffness);
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

double CoupledContacts::pointForceError(std::size_t contact) const noexcept
{
  const Load& own = this->Loads[contact];
  double sum = 0.0;
  for (std::size_t j = 0; own.counts() && j < this->Loads.size(); ++j)
  {
    const Load& other = this->Loads[j];
    if (j != contact && other.counts())
    {
      sum += this->Body.coupling->pointForceError(own.spot, other.spot) *
        std::max(1.0, other.force / own.force);
    }
  }
  return std::min(1.0, sum);
}

double CoupledContacts::press(std::size_t contact) noexcept
{
  Load& load = this->Loads[contact];
  const ResponseValue value = this->Contacts[contact].slowResponse(
    load.pressed, load.pressed.reach.depth - this->sunkBy(contact));
  const double before = load.whole;
  load.whole = std::isfinite(value.force) ? value.force : 0.0;
  load.stiffness = value.stiffness;
  return std::abs(load.whole - before);
}

double CoupledContacts::goRound() noexcept
{
  double largest = 0.0;
  double change = 0.0;
  for (std::size_t i = 0; i < this->Loads.size(); ++i)
  {
    Load& load = this->Loads[i];
    if (load.presses)
    {
      change = std::max(change, this->press(i));
      largest = std::max(largest, load.whole);
      load.force = load.appliedForce();
    }
  }
  return largest > 0.0 ? change / largest : 0.0;
}

double CoupledContacts::solveRound() noexcept
{
  // Solves (1/K_i) ΔF_i + Σ_j C_ij ΔF_j = (f_i - F_i)/K_i for the contacts that touch. The forces
  // of the other contacts are set to 0.
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, MostSolved, MostSolved>;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, MostSolved, 1>;
  const std::size_t count = this->Loads.size();
  std::array<double, MostSolved> lack{}; // f_i - F_i
  std::array<bool, MostSolved> touches{};
  double largest = 0.0;
  double change = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    Load& load = this->Loads[i];
    if (load.presses)
    {
      this->press(i);
      largest = std::max(largest, load.whole);
      lack[i] = load.appliedForce() - load.force;
      change = std::max(change, std::abs(lack[i]));
      touches[i] = load.appliedForce() > 0.0 && load.stiffness > 0.0;
    }
  }
  const auto size = static_cast<Eigen::Index>(count);
  Matrix system = Matrix::Identity(size, size);
  Vector right(size);
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto row = static_cast<Eigen::Index>(i);
    const double own = touches[i] ? 1.0 / this->Loads[i].stiffness : 1.0;
    system(row, row) = own;
    right[row] = own * lack[i];
    for (std::size_t j = 0; j < count; ++j)
    {
      const double between = touches[i] && j != i ? this->compliance(i, j) : 0.0;
      right[row] -= touches[j] ? 0.0 : between * lack[j];
      system(row, static_cast<Eigen::Index>(j)) += touches[j] ? between : 0.0;
    }
  }
  const Eigen::LLT<Eigen::Ref<Matrix>> factor(system);
  const bool isSolved = factor.info() == Eigen::Success;
  if (isSolved)
  {
    factor.solveInPlace(right);
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    // If the compliances are not positive definite (impossible for a body), the step assumes
    // constant forces of the other contacts.
    const double step = isSolved ? right[static_cast<Eigen::Index>(i)] : lack[i];
    this->Loads[i].force = std::max(0.0, this->Loads[i].force + step);
  }
  return largest > 0.0 ? change / largest : 0.0;
}

[[gnu::hot]] const std::vector<Contact>& CoupledContacts::solve(int rounds) noexcept
{
  this->Stiffening = 0.0;
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
    if (load.isMissing)
    {
      felt = Contact();
      felt.state = ContactState::Invalid;
      continue;
    }
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
      byWeights += other.force *
        this->Body.coupling->gradient(own.spot, own.pressed.place().triangle, other.spot);
    }
  }
  // The sum of the area coordinates is constant. Therefore an additive constant of the derivatives
  // has no effect.
  const Eigen::Matrix3d& gradients = own.pressed.place().weightGradients;
  const Vector3 side = own.force *
    (gradients.col(1) * (byWeights[1] - byWeights[0]) +
      gradients.col(2) * (byWeights[2] - byWeights[0]));
  if (hasOthers && side.allFinite())
  {
    felt.force += side;
  }
}

void CoupledContacts::reset() noexcept
{
  this->lose();
  for (ToolContact& contact : this->Contacts)
  {
    contact.reset();
  }
}

void CoupledContacts::lose(std::size_t contact) noexcept
{
  this->Contacts[contact].lose();
  this->Loads[contact] = Load{};
  this->Stiffening = 0.0;
}

std::size_t CoupledContacts::gatherCompliances(double factor, double* matrix) const noexcept
{
  std::size_t rows = 0;
  for (std::size_t i = 0; i < this->Loads.size(); ++i)
  {
    rows += this->Loads[i].counts() ? 1 : 0;
    for (std::size_t j = 0; j < this->Loads.size(); ++j)
    {
      if (this->Loads[i].counts() && this->Loads[j].counts())
      {
        *matrix++ = factor * (i == j ? 1.0 / this->Loads[i].stiffness : this->compliance(i, j));
      }
    }
  }
  return rows;
}

Eigen::MatrixXd CoupledContacts::stiffness() const
{
  std::vector<Eigen::Index> counting;
  for (std::size_t i = 0; i < this->Loads.size(); ++i)
  {
    if (this->Loads[i].counts())
    {
      counting.push_back(static_cast<Eigen::Index>(i));
    }
  }
  const auto rows = static_cast<Eigen::Index>(counting.size());
  Eigen::MatrixXd compliances(rows, rows);
  this->gatherCompliances(1.0, compliances.data());
  const auto size = static_cast<Eigen::Index>(this->Loads.size());
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(size, size);
  const Eigen::MatrixXd inverse = compliances.partialPivLu().inverse();
  all(counting, counting) = inverse;
  return all;
}

double CoupledContacts::stiffening() noexcept
{
  if (this->Stiffening > 0.0)
  {
    return this->Stiffening;
  }
  double stiffest = 0.0;
  for (const Load& load : this->Loads)
  {
    stiffest = load.counts() ? std::max(stiffest, load.stiffness) : stiffest;
  }
  double* matrix = this->Work.data();
  const std::size_t rows = this->gatherCompliances(stiffest, matrix);
  this->Stiffening =
    rows < 2 ? 1.0 : std::max(1.0, stiffnessBound(matrix, matrix + rows * rows, rows));
  return this->Stiffening;
}

double CoupledContacts::cappedShare(std::size_t contact, double maximumStiffness) noexcept
{
  return this->Contacts[contact].cappedShare(
    this->Felt[contact], maximumStiffness / this->stiffening());
}
} // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
// Energy that coupled tools gain or lose on closed paths.
#include "Contact/Coupled/CoupledContacts.h"

#include "CoupledPlate.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <vector>

using namespace palpate;
using palpate::Pi;
using namespace palpate::testing;

namespace
{
ContactSettings energyConsistent()
{
  ContactSettings settings;
  settings.form = ForceForm::EnergyConsistent;
  return settings;
}

using Motion = std::function<Vector3(std::size_t tool, double angle)>;

/// Work of the tools in the last of `turns` turns of their closed paths, N mm, by chords.
double workOfATurn(CoupledContacts& contacts, const Motion& motion, int steps, int turns,
  bool isSettled, double* sideWork = nullptr)
{
  const std::size_t count = contacts.count();
  std::vector<Vector3> places(count);
  std::vector<Vector3> forces(count);
  double work = 0.0;
  for (int step = 0; step <= turns * steps; ++step)
  {
    const double angle = 2.0 * Pi * (step % steps) / steps;
    std::vector<ToolPose> poses;
    for (std::size_t i = 0; i < count; ++i)
    {
      poses.emplace_back(motion(i, angle));
    }
    const auto& felt = isSettled ? contacts.settle(poses.data()) : contacts.update(poses.data());
    for (std::size_t i = 0; i < count; ++i)
    {
      if (step > (turns - 1) * steps)
      {
        const Vector3 way = poses[i].tip - places[i];
        work += 0.5 * (forces[i] + felt[i].force).dot(way);
        if (sideWork)
        {
          const Vector3 side = felt[i].force - felt[i].normalForce * felt[i].normal;
          *sideWork += std::abs(side.dot(way));
        }
      }
      places[i] = poses[i].tip;
      forces[i] = felt[i].force;
    }
  }
  return work;
}
} // namespace

// Two fingers press up and down at fixed places with a phase difference of a quarter turn, at 1
// kHz. The reference sheet states 2e-6 F δ for two rounds, 7e-5 for one.
TEST(CoupledEnergy, OfTwoFingersOutOfStepIsKept)
{
  const auto body = CoupledPlate().body();
  const Motion motion = [](std::size_t tool, double angle)
  {
    const double depth = 0.5 + 0.25 * std::sin(angle + 0.5 * Pi * static_cast<double>(tool));
    return Vector3(25.0 + 5.0 * static_cast<double>(tool), 29.3, -depth);
  };
  const double scale = 10.0 * std::pow(0.5, 1.5) * 0.5;
  CoupledContacts contacts(*body, energyConsistent(), 2);
  EXPECT_LT(std::abs(workOfATurn(contacts, motion, 1000, 2, false)), 2e-6 * scale);
  CoupledContacts settled(*body, energyConsistent(), 2);
  // On a smooth closed path chords have only rounding errors.
  EXPECT_LT(std::abs(workOfATurn(settled, motion, 1000, 2, true)), 1e-10 * scale);
}

// Tools that press and also circle around each other on a plate. Their attraction is one per cent
// of the force; without it the energy of the loop would not be zero.
TEST(CoupledEnergy, OfToolsThatMoveAboutIsKept)
{
  const auto body = CoupledPlate().body();
  const Motion motion = [](std::size_t tool, double angle)
  {
    const double phase = angle + 2.1 * static_cast<double>(tool);
    const double depth = 0.5 + 0.3 * std::sin(angle + 1.3 * static_cast<double>(tool));
    return Vector3(18.0 + 9.0 * static_cast<double>(tool) + 1.5 * std::cos(phase),
      29.3 + 2.5 * std::sin(phase), -depth);
  };
  const double scale = 10.0 * std::pow(0.5, 1.5) * 0.5;
  CoupledContacts settled(*body, energyConsistent(), 3);
  double sideWork = 0.0;
  const double lost = workOfATurn(settled, motion, 2000, 1, true, &sideWork);
  EXPECT_LT(std::abs(lost), 2e-6 * scale); // error of the curve in floats, and of chords
  EXPECT_GT(sideWork, 1e-2 * scale);
  CoupledContacts normal(*body, {}, 3);
  EXPECT_GT(std::abs(workOfATurn(normal, motion, 2000, 1, true)), 2e-4 * scale);
}

namespace
{
/// A body with another curve, modulus, layer thickness and modes at each point.
struct VariedBody
{
  explicit VariedBody(const Surface& given)
    : surface(given)
    , store(given.points.size())
    , modulus(given.points.size())
    , thickness(given.points.size())
    , modes(2 * given.points.size())
    , law(LayerKernel(0.3, LayerBase::Bonded))
  {
    takeMeshNormals(this->store, given);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> share(0.7F, 1.3F);
    for (std::size_t p = 0; p < given.points.size(); ++p)
    {
      const float scale = share(random);
      this->modulus[p] = 3.35F * scale;
      this->thickness[p] = 6.0F * share(random);
      this->modes[2 * p] = 0.1F * share(random);
      this->modes[2 * p + 1] = 0.1F * (share(random) - 1.0F);
      for (std::size_t i = 8 * p; i < 8 * (p + 1); ++i)
      {
        this->store.force[i] *= scale;
        this->store.stiffness[i] *= scale;
      }
    }
  }

  std::unique_ptr<ContactBody> body() const
  {
    ResponseArrays arrays = this->store.arrays();
    arrays.coupling.modulus = 3.35;
    arrays.coupling.thickness = 6.0;
    arrays.coupling.knots = this->law.knots().data();
    arrays.coupling.localModulus = this->modulus.data();
    arrays.coupling.localThickness = this->thickness.data();
    arrays.coupling.modes = this->modes.data();
    arrays.coupling.modeCount = 2;
    return contactBody(this->surface, arrays);
  }

  Surface surface;
  ResponseStore store;
  std::vector<float> modulus;
  std::vector<float> thickness;
  std::vector<float> modes;
  CouplingLaw law;
};
} // namespace

// The facets of a plate and the smooth surface of a ball. On both a contact continues without a
// jump, so every term of the gradient has an effect.
TEST(CoupledEnergy, OfABodyThatVariesIsKept)
{
  const auto ball = VariedBody(icosphere(20.0, 2)).body();
  const auto plate = VariedBody(openPlate(60.0, 12)).body();
  for (const bool isSmooth : { false, true })
  {
    const Motion motion = [isSmooth](std::size_t tool, double angle)
    {
      const double which = static_cast<double>(tool);
      const double phase = angle + 2.1 * which;
      const double depth = 0.9 - 0.3 * std::sin(angle + which);
      if (!isSmooth)
      {
        return Vector3(
          24.0 + 9.0 * which + 1.2 * std::cos(phase), 29.0 + 1.5 * std::sin(phase), -depth);
      }
      const Vector3 out(
        0.3 + 0.06 * std::cos(phase), 0.15 + 0.08 * std::sin(phase) + 0.4 * which, 0.8);
      return Vector3((20.0 - depth) * out.normalized());
    };
    ContactSettings settings = energyConsistent();
    settings.surface = isSmooth ? ContactSurface::Smooth : ContactSurface::Facets;
    CoupledContacts contacts(isSmooth ? *ball : *plate, settings, 2);
    double sideWork = 0.0;
    const double lost = workOfATurn(contacts, motion, 16000, 1, true, &sideWork);
    // Chords across the kinks at the edges of triangles have an error of second order in the step.
    EXPECT_LT(std::abs(lost), 1e-4 * sideWork) << isSmooth;
    EXPECT_GT(sideWork, 0.1);
  }
}

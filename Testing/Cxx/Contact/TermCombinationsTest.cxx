// SPDX-License-Identifier: BSD-3-Clause
// The energy-consistent force form under every combination of edges, tilt, relaxation and coupling,
// at points with different curves, tilt laws and strengths. Forces and torques do no work on a
// closed path.
#include "Contact/Coupled/CoupledContacts.h"

#include "SampleBodies.h"
#include "SampleResponses.h"
#include "SampleSeries.h"
#include "SampleTilts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

using namespace palpate;
using namespace palpate::testing;

namespace
{
struct Terms
{
  bool edges, tilt, relaxation, coupling;
};

std::string nameOfTerms(const ::testing::TestParamInfo<Terms>& info)
{
  const Terms& terms = info.param;
  std::string name = std::string(terms.edges ? "Edges" : "") + (terms.tilt ? "Tilt" : "") +
    (terms.relaxation ? "Relaxation" : "") + (terms.coupling ? "Coupling" : "");
  return name.empty() ? "None" : name;
}

/// A block of 20 x 16 x 12 mm under a ball of 5 mm. Each point has another multiple of F = 10
/// δ^1.5, other weights of two tilt laws, and other strengths of relaxation.
struct VariedBlock
{
  explicit VariedBlock(const Terms& terms)
    : surface(subdivided(block(20.0, 16.0, 12.0), 1))
    , store(surface.points.size())
    , tilts(
        { [](double depth, double angle) { return 1.0 + angle * angle * (0.8 + 0.5 * depth); },
          [](double depth, double angle) { return 1.0 - angle * angle * (0.4 - 0.1 * depth); } },
        dropOfSphere(5.0), 2.0, 0.6)
  {
    for (std::size_t p = 0; p < this->surface.points.size(); ++p)
    {
      const auto phase = static_cast<double>(p);
      const auto scale = static_cast<float>(1.0 + 0.3 * std::sin(2.1 * phase));
      for (std::size_t i = 8 * p; i < 8 * (p + 1); ++i)
      {
        this->store.force[i] *= scale;
        this->store.stiffness[i] *= scale;
      }
      const auto share = static_cast<float>(0.5 + 0.5 * std::sin(1.3 * phase));
      this->weight.insert(this->weight.end(), { share, 1.0F - share });
      this->strength.push_back(static_cast<float>(0.3 + 0.2 * std::sin(0.7 * phase)));
    }
    ResponseArrays arrays = this->store.arrays();
    if (terms.edges)
    {
      arrays.edges = sphereOverEdges();
    }
    if (terms.tilt)
    {
      arrays.tilt = this->tilts.views;
      arrays.tilt.weight = this->weight.data();
    }
    if (terms.relaxation)
    {
      arrays.relaxation.series = relaxation({ { 0.3, 0.05 } });
      arrays.relaxation.strength = this->strength.data();
      arrays.relaxation.exponent = 1.5;
    }
    if (terms.coupling)
    {
      arrays.coupling.modulus = 30.0;
    }
    this->body = contactBody(this->surface, arrays);
  }

  Surface surface;
  ResponseStore store;
  TiltStore tilts;
  std::vector<float> weight;
  std::vector<float> strength;
  std::unique_ptr<ContactBody> body;
};

/// A pose on a closed path over the upper face, 1.1 to 2.5 mm from an edge of the block, at depths
/// of 0.3 to 0.7 mm. `side` is -1 or 1 for the two tools, which are 5 mm apart.
ToolPose poseOnTurn(double turn, double side)
{
  const double phase = turn + 0.9 * side;
  const Vector3 tip(1.8 + 0.7 * std::sin(phase), 2.5 * side + 11.5 + 0.5 * std::cos(phase),
    11.5 + 0.2 * std::sin(2.0 * phase));
  return { tip, Vector3(0.3 * std::cos(2.0 * phase), 0.3 * std::sin(phase), 1.0) };
}

std::vector<ToolPose> posesOnTurn(std::size_t count, double turn, double above = 0.0)
{
  std::vector<ToolPose> poses{ poseOnTurn(turn, -1.0) };
  if (count > 1)
  {
    poses.push_back(poseOnTurn(turn, 1.0));
  }
  for (ToolPose& pose : poses)
  {
    pose.tip.z() += above;
  }
  return poses;
}

struct TurnWork
{
  double net = 0.0;      ///< N mm
  double put = 0.0;      ///< sum of the positive steps
  double sideways = 0.0; ///< sum of the magnitudes of the steps of the tangential force
};

/// Work of all tools in the second of two turns, by the trapezoidal rule.
TurnWork workOfATurn(CoupledContacts& contacts, bool isInTime, int steps)
{
  const std::size_t count = contacts.count();
  std::vector<ToolPose> before;
  std::vector<Contact> last;
  TurnWork work;
  const auto evaluate = [&](const std::vector<ToolPose>& poses)
  {
    constexpr double instant = 1e-15; // s: too short for relaxation during the path
    return isInTime ? contacts.update(poses.data(), instant) : contacts.settle(poses.data());
  };
  for (int i = 100; i >= 0; --i) // the tools move down onto the upper face
  {
    evaluate(posesOnTurn(count, 0.0, 0.01 * i));
  }
  for (int i = 0; i <= 2 * steps; ++i)
  {
    const std::vector<ToolPose> poses = posesOnTurn(count, 2.0 * M_PI * i / steps);
    const std::vector<Contact> now = evaluate(poses);
    for (std::size_t k = 0; k < count && i > steps; ++k)
    {
      EXPECT_GT(now[k].normalForce, 0.0) << i;
      const Vector3 way = poses[k].tip - before[k].tip;
      // rotation of the axis, a small angle
      const Vector3 turned = before[k].axis.cross(poses[k].axis);
      const Vector3 force = 0.5 * (last[k].force + now[k].force);
      const double step = -(force.dot(way) + 0.5 * (last[k].torque + now[k].torque).dot(turned));
      work.net += step;
      work.put += std::max(step, 0.0);
      work.sideways += std::abs(force.head<2>().dot(way.head<2>()));
    }
    before = poses;
    last = now;
  }
  return work;
}

class TermCombinations : public ::testing::TestWithParam<Terms>
{
};
} // namespace

TEST_P(TermCombinations, NothingIsGainedOnAClosedPath)
{
  const Terms& terms = GetParam();
  const VariedBlock block(terms);
  ContactSettings settings;
  settings.form = ForceForm::EnergyConsistent;
  for (const ContactSurface surface : { ContactSurface::Facets, ContactSurface::Smooth })
  {
    settings.surface = surface;
    CoupledContacts contacts(*block.body, settings, terms.coupling ? 2 : 1);
    const TurnWork work = workOfATurn(contacts, terms.relaxation, 4000);
    // Curves are floats, and the memory force follows chords of the curve: 6e-6 at most.
    EXPECT_LT(std::abs(work.net), 1e-5 * work.put);
    // the tangential force has a measurable part in the work
    EXPECT_GT(work.sideways, 2e-2 * work.put);
  }
}

INSTANTIATE_TEST_SUITE_P(All, TermCombinations,
  ::testing::Values(Terms{ false, false, false, false }, Terms{ true, false, false, false },
    Terms{ false, true, false, false }, Terms{ true, true, false, false },
    Terms{ false, false, true, false }, Terms{ true, false, true, false },
    Terms{ false, true, true, false }, Terms{ true, true, true, false },
    Terms{ false, false, false, true }, Terms{ false, true, false, true },
    Terms{ true, false, false, true }, Terms{ true, true, false, true }),
  nameOfTerms);

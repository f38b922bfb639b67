// SPDX-License-Identifier: BSD-3-Clause
// Part e: jumps and loop energy over edges, grooves, slabs and coarse meshes, per force form and
// surface, with and without the edge law.
#include "ContinuityMeasures.h"
#include "Parts.h"
#include "Renderings.h"
#include "SampleResponses.h"
#include "UnkindBodies.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace palpate::testing
{
namespace
{
const char* nameOf(ForceForm form)
{
  switch (form)
  {
    case ForceForm::Paper:
      return "Paper";
    case ForceForm::NormalizedDirection:
      return "NormalizedDirection";
    default:
      return "EnergyConsistent";
  }
}

/// Results of a tip that moves once along a closed path in steps of `step` mm.
struct Lap
{
  double jump = 0.0;        ///< largest |ΔF| of a step, divided by the force before the step
  double contactJump = 0.0; ///< jump of the contact point, mm, while in contact
  double gain = 0.0;        ///< ∮F·dx, the energy gained by the hand, mJ
  double scale = 0.0;       ///< ∮|F||dx|, mJ
};

Lap lap(
  const ContactBody& body, const ContactSettings& settings, std::vector<Vector3> path, double step)
{
  ToolContact contact(body, settings);
  Contact last = contact.update(path.front());
  Lap found;
  for (std::size_t side = 1; side < path.size(); ++side)
  {
    const Vector3 way = path[side] - path[side - 1];
    const int steps = static_cast<int>(std::ceil(way.norm() / step));
    for (int i = 1; i <= steps; ++i)
    {
      const Contact now = contact.update(path[side - 1] + way * i / steps);
      found.gain += 0.5 * (last.force + now.force).dot(way) / steps;
      found.scale += 0.5 * (last.force.norm() + now.force.norm()) * way.norm() / steps;
      // Begin and end of a contact with a small force do not count as jumps.
      if (last.force.norm() > 0.5)
      {
        found.jump = std::max(found.jump, (now.force - last.force).norm() / last.force.norm());
        if (now.triangle >= 0)
        {
          found.contactJump =
            std::max(found.contactJump, (now.contactPoint - last.contactPoint).norm());
        }
      }
      last = now;
    }
  }
  return found;
}

/// Energy (mJ) that a rigid hand gains in some laps at 20 mm/s, in addition to the damping of the
/// device.
double generated(const std::shared_ptr<const ContactBody>& body, const ContactSettings& settings,
  const std::vector<Vector3>& path, int laps, Control control)
{
  LoopSetting setting;
  setting.rate = 8000.0;
  setting.plant.mass = 0.01;
  setting.plant.damping = 1.5; // 2b/T is 24 N/mm: more than the laws' stiffness here
  setting.hand = { 1e9, 1e5 };
  SafetySettings safety = safetyOf(control, setting);
  safety.maximumForce = 1e6;
  std::vector<WayPoint> way;
  double time = 0.0;
  for (int turn = 0; turn < laps; ++turn)
  {
    for (std::size_t side = 0; side < path.size(); ++side)
    {
      time += side > 0 ? 1e-3 * (path[side] - path[side - 1]).norm() / 0.02 : 0.0;
      way.push_back({ time, 1e-3 * path[side] });
    }
  }
  ServoRendering rendering(body, safety, settings);
  VirtualLoop loop(setting, way, rendering);
  loop.run(static_cast<int>(std::ceil(time * setting.rate)) + 2);
  return 1e3 * loop.audit().mostGenerated();
}

/// The tip goes down at the softest place of a varying response, moves at constant depth to the
/// stiffest place, and goes up and back outside. Energy put in at one place is returned at the
/// other.
std::vector<Vector3> fromSoftToStiff(const MeshedBody& body)
{
  Vector3 softest = Vector3::UnitX();
  Vector3 stiffest = Vector3::UnitX();
  for (int i = 0; i < 1000; ++i)
  {
    // Fibonacci directions
    const double z = 1.0 - 2.0 * (i + 0.5) / 1000.0;
    const double turn = 2.399963229728653 * i;
    const double r = std::sqrt(1.0 - z * z);
    const Vector3 direction(r * std::cos(turn), r * std::sin(turn), z);
    softest = body.factor(direction) < body.factor(softest) ? direction : softest;
    stiffest = body.factor(direction) > body.factor(stiffest) ? direction : stiffest;
  }
  std::vector<Vector3> path;
  constexpr int steps = 200;
  for (const double depth : { UnkindDepth, -UnkindDepth })
  {
    for (int i = 0; i <= steps; ++i)
    {
      const double share = static_cast<double>(depth > 0.0 ? i : steps - i) / steps;
      const Vector3 direction = ((1.0 - share) * softest + share * stiffest).normalized();
      path.push_back(body.shape.point(direction) - depth * body.shape.normal(direction));
    }
  }
  std::rotate(path.begin(), path.begin() + steps + 1, path.end()); // starts outside
  path.push_back(path.front());
  return path;
}

/// Treatment of a contact at a sharp edge.
enum class Edges
{
  Dropped,
  Felt
};
constexpr Edges AllEdges[] = { Edges::Dropped, Edges::Felt };

EdgeTerms termsOf(Edges edges)
{
  return edges == Edges::Felt ? sphereOverEdges() : EdgeTerms{};
}

void print(const std::string& body, double edge, const ContactSettings& settings, Edges edges,
  double jump, double expectedJump, double contactJump, double expectedContactJump, double loop,
  double bare, double controlled)
{
  std::printf("\"%s\",%.3g,%s,%s,%s,%.4g,%.4g,%.4g,%.4g,%.4g,%.4g,%.4g\n", body.c_str(), edge,
    nameOf(settings.form), settings.surface == ContactSurface::Facets ? "Facets" : "Smooth",
    edges == Edges::Felt ? "felt" : "dropped", jump, expectedJump, contactJump, expectedContactJump,
    loop, bare, controlled);
  std::fflush(stdout);
}

void sharp(const UnkindBody& unkind, double step, Edges edges)
{
  const std::shared_ptr<const ContactBody> body = uniformBody(unkind.surface, termsOf(edges));
  std::vector<Vector3> back = unkind.path;
  std::reverse(back.begin(), back.end());
  for (const ContactSettings& settings : allFormsAndSurfaces())
  {
    const Lap there = lap(*body, settings, unkind.path, step);
    const Lap again = lap(*body, settings, back, step);
    const double loop = std::max(there.gain / there.scale, again.gain / again.scale);
    const std::vector<Vector3>& worse = there.gain > again.gain ? unkind.path : back;
    print(unkind.name, 1.0, settings, edges, std::max(there.jump, again.jump), unkind.forceJump,
      std::max(there.contactJump, again.contactJump), unkind.contactJump, loop,
      generated(body, settings, worse, 1, Control::None),
      generated(body, settings, worse, 1, Control::Passivity));
  }
}

void coarse(int cuts, bool isVaried, bool isQuick, Edges edges)
{
  MeshedBody body(
    smoothSphere(20.0), cuts, isVaried ? varied : uniform, MeshNormals::Exact, termsOf(edges));
  const std::vector<Vector3> path = fromSoftToStiff(body);
  const std::shared_ptr<const ContactBody> contact = std::move(body.contact);
  const int laps = isQuick ? 1 : 5;
  const MeshedBody measured(
    smoothSphere(20.0), cuts, isVaried ? varied : uniform, MeshNormals::Exact, termsOf(edges));
  for (const ContactSettings& settings : allFormsAndSurfaces())
  {
    // The expected jump is δ h/R². For EnergyConsistent on facets it is the angle between facets.
    const bool turns = settings.form == ForceForm::EnergyConsistent;
    const double jump = settings.surface == ContactSurface::Smooth
      ? 0.0
      : body.longestEdge / 20.0 * (turns ? 1.0 : UnkindDepth / 20.0);
    print(isVaried ? "sphere, varied" : "sphere", body.longestEdge, settings, edges,
      forceJump(measured, settings, UnkindDepth, isQuick ? 30.0 : 120.0), jump, 0.0, 0.0,
      loopEnergy(measured, settings, UnkindDepth, isQuick ? 2 : 8),
      isVaried ? generated(contact, settings, path, laps, Control::None) : 0.0,
      isVaried ? generated(contact, settings, path, laps, Control::Passivity) : 0.0);
  }
}
} // namespace

void unkindGeometry(bool isQuick)
{
  std::puts("body,edge_mm,form,surface,edges,force_jump,nearest_force_jump,contact_jump_mm,"
            "nearest_contact_jump_mm,loop_gain,generated_mJ,generated_controlled_mJ");
  for (const UnkindBody& body : unkindBodies())
  {
    if (!isQuick || body.name == "edge 90°" || body.name == "slab")
    {
      for (const Edges edges : AllEdges)
      {
        sharp(body, isQuick ? 1e-2 : 1e-3, edges);
      }
    }
  }
  for (const int cuts : { 5, 10, 20 })
  {
    if (!isQuick || cuts == 10)
    {
      for (const Edges edges : AllEdges)
      {
        coarse(cuts, false, isQuick, edges);
        coarse(cuts, true, isQuick, edges);
      }
    }
  }
}
} // namespace palpate::testing

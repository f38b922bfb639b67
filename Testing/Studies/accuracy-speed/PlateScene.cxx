// SPDX-License-Identifier: BSD-3-Clause
#include "FiniteBody.h"
#include "FiniteMethods.h"
#include "LawMethods.h"
#include "StudyScene.h"

#include <algorithm>
#include <array>

namespace palpate::testing
{
namespace
{
constexpr double HalfTop = 20.0;                        // half side of the meshed face, mm
constexpr std::array<double, 3> Edges{ 1.0, 2.0, 4.0 }; // mm
constexpr double Deepest = 3.0; // mm, the largest depth of the finite-element curves

FiniteMesh meshFor(const StudyEffort& effort)
{
  return effort.withFinite ? FiniteMesh{} : FiniteMesh::quick();
}
} // namespace

StudyScene plateScene(const StudyEffort& effort)
{
  const FiniteBodyPointer plate = FiniteBody::make(finitePlate(), meshFor(effort));
  const double window = plate->mesh().window;
  const SpotMap spotAt = [plate, window](double x, double y)
  {
    return Spot{ 0.0,
      plate->globalCompliance(std::clamp(x, -window, window), std::clamp(y, -window, window)) };
  };
  StudyScene scene;
  scene.name = "plate on edges";
  scene.curves = "plateedges";
  scene.material = { plate->scene().reducedModulus, plate->scene().poissonRatio };
  for (const char* tool : { "sphere:6.35", "sphere:1.6", "flat:1.6", "cone:60" })
  {
    scene.tools.push_back(studyTool(tool, Deepest));
  }
  for (const double edge : Edges)
  {
    Surface top = flatTop(HalfTop, edge);
    std::vector<Spot> spots;
    for (const Vector3& point : top.points)
    {
      spots.push_back(spotAt(point.x(), point.y()));
    }
    scene.bodies.push_back(std::make_unique<StudyBody>(std::move(top), std::move(spots)));
  }
  scene.tips = [plate, effort](const StudyTool& tool)
  {
    // Most of the deflection is bending of the plate, so that the contact is narrower than on a
    // half-space.
    const double half = std::min(4.0, plate->reach(0.5 * tool.shape->contactRadius(tool.range)));
    return flatTips(half, tool.range, effort.sites, effort.path);
  };
  if (!effort.withFinite)
  {
    scene.reference = [spotAt](const StudyLaw& law) { return planeReference(spotAt, law); };
    return scene;
  }
  scene.stride = 20;
  scene.reference = [plate](const StudyLaw& law)
  { return finiteReference(plate, law.tool().shape); };
  scene.finiteVertices = static_cast<std::size_t>(plate->windowNodes());
  scene.finite = [plate](const StudyTool& tool) { return finiteMethods(plate, tool.shape); };
  return scene;
}
} // namespace palpate::testing

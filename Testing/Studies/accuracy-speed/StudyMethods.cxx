// SPDX-License-Identifier: BSD-3-Clause
#include "LawMethods.h"
#include "PenetratingVertices.h"
#include "SpringMethods.h"
#include "StoredMethods.h"
#include "StudyScene.h"

#include <array>
#include <utility>

namespace palpate::testing
{
namespace
{
constexpr std::array<int, 4> SampleCounts{ 3, 5, 8, 16 };
constexpr int Usual = 8; // number of samples that is normally used
constexpr double Tolerance = 0.01;
constexpr std::array<const char*, 3> Sizes{ "fine", "medium", "coarse" };

/// Whether the body has a global compliance. The method `exact law` ignores the compliance, so that
/// a scene with such a body shows the effect of the compliance.
bool isGlobal(const StudyBody& body)
{
  return body.spots().front().compliance != 0.0;
}
} // namespace

MethodList studyMethods(const StudyScene& scene, const StudyTool& tool)
{
  const StudyBody& body = *scene.bodies.front();
  const StudyLaw known(scene.tools.front(), scene.material);
  const StudyLaw law(tool, scene.material);
  MethodList methods;
  const auto addOn = [&](const StudyBody& mesh, std::unique_ptr<ContactMethod> method) {
    methods.push_back({ std::move(method), mesh.pointCount(), mesh.meshBytes() });
  };
  const auto add = [&](std::unique_ptr<ContactMethod> method) { addOn(body, std::move(method)); };
  add(oneSpring(body, known));
  add(pointSprings("point spring per vertex", body, known));
  add(pointSprings("point spring per vertex and tool", body, law));
  for (std::size_t i = 0; i < scene.bodies.size() && i < Sizes.size(); ++i)
  {
    const StudyBody& mesh = *scene.bodies[i];
    addOn(mesh,
      std::make_unique<PenetratingVertices>(
        std::string("penetrating vertices, ") + Sizes[i], mesh, known, tool.shape));
  }
  add(fixedPatch(body, known));
  if (std::unique_ptr<ContactMethod> closed = tableOne(body, law))
  {
    add(std::move(closed));
  }
  if (!isGlobal(body))
  {
    add(exactLaw(body, law));
  }
  for (const int samples : SampleCounts)
  {
    const SampledCurves curves = law.sample(body.spots(), samples);
    const std::string number = std::to_string(samples);
    add(linear("linear " + number, body, curves));
    add(hermite("Hermite " + number, body, curves));
    if (samples == Usual)
    {
      add(hermite("Hermite 8, smooth surface", body, curves, ContactSurface::Smooth));
      add(hermiteIn(FloatWidth::Half, "Hermite 8, float16", body, curves));
      add(hermiteIn(FloatWidth::Single, "Hermite 8, float32", body, curves));
      add(hermiteIn(FloatWidth::Double, "Hermite 8, float64", body, curves));
      add(reducedBasis("reduced basis, 1 %", body, curves, Tolerance));
    }
  }
  if (scene.finite)
  {
    for (std::unique_ptr<ContactMethod>& method : scene.finite(tool))
    {
      methods.push_back({ std::move(method), scene.finiteVertices, 0 });
    }
  }
  return methods;
}
} // namespace palpate::testing

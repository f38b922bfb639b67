// SPDX-License-Identifier: BSD-3-Clause
#include "StudyScene.h"

#include "FiniteMethods.h"
#include "LawMethods.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate::testing
{
namespace
{
/// E* of the paper's rubber, MPa, with the Poisson's ratio of the CalculiX curves.
constexpr StudyMaterial Rubber{ 3.45, 0.45 };
/// E = 0.035 MPa, as in the study of reduction.
constexpr StudyMaterial Scalp{ 0.035 / (1.0 - 0.45 * 0.45), 0.45 };
constexpr std::array<double, 3> Edges{ 1.0, 2.0, 4.0 }; // mm
constexpr double HalfTop = 40.0;                        // half side of the meshed face, mm
constexpr double HalfTouched = 4.0;                     // half side of the touched part, mm

std::size_t verticesOf(const FiniteMesh& mesh)
{
  const auto side = static_cast<std::size_t>(std::lround(2.0 * mesh.window / mesh.spacing)) + 1;
  return side * side;
}

/// Finite-element methods on this body. They are created at the first use.
std::function<std::vector<MethodPointer>(const StudyTool&)> finiteOn(const FiniteScene& body)
{
  const auto made = std::make_shared<FiniteBodyPointer>();
  return [body, made](const StudyTool& tool)
  {
    if (!*made)
    {
      *made = FiniteBody::make(body, FiniteMesh{});
    }
    return finiteMethods(*made, tool.shape);
  };
}

/// The tools and the largest depths of the finite-element curves. The cone's depth gives a contact
/// 2 mm wide.
std::vector<StudyTool> localTools()
{
  return { studyTool("sphere:6.35", 2.0), studyTool("sphere:1.6", 0.8), studyTool("flat:1.6", 0.6),
    studyTool("cone:60", 1.0) };
}

StudyScene flatScene(const StudyEffort& effort, const Spot& spot)
{
  StudyScene scene;
  scene.material = Rubber;
  scene.tools = localTools();
  for (const double edge : Edges)
  {
    Surface top = flatTop(HalfTop, edge);
    std::vector<Spot> spots(top.points.size(), spot);
    scene.bodies.push_back(std::make_unique<StudyBody>(std::move(top), std::move(spots)));
  }
  scene.tips = [effort](const StudyTool& tool)
  { return flatTips(HalfTouched, tool.range, effort.sites, effort.path); };
  scene.reference = [spot](const StudyLaw& law)
  { return planeReference([spot](double, double) { return spot; }, law); };
  return scene;
}
} // namespace

StudyScene blockScene(const StudyEffort& effort)
{
  StudyScene scene = flatScene(effort, {});
  scene.name = "half-space block";
  scene.curves = "block";
  if (effort.withFinite)
  {
    scene.finite = finiteOn(finiteBlock());
    scene.finiteVertices = verticesOf(FiniteMesh{});
  }
  return scene;
}

StudyScene layerScene(const StudyEffort& effort)
{
  StudyScene scene = flatScene(effort, { 0.1, 0.0 });
  scene.name = "10 mm layer";
  scene.curves = "layer10";
  if (effort.withFinite)
  {
    scene.finite = finiteOn(finiteLayer());
    scene.finiteVertices = verticesOf(FiniteMesh{});
  }
  return scene;
}

StudyScene headScene(const StudyEffort& effort, const std::vector<std::string>& files)
{
  StudyScene scene;
  scene.name = "head";
  scene.material = Scalp;
  scene.tools = localTools();
  for (const std::string& file : files)
  {
    scene.bodies.push_back(readStudyBody(file));
  }
  const StudyBody& finest = *scene.bodies.front();
  scene.tips = [effort, &finest](const StudyTool& tool)
  { return bodyTips(finest, tool.range, effort.sites, effort.path); };
  scene.reference = [&finest](const StudyLaw& law) { return exactReference(finest, law); };
  return scene;
}
} // namespace palpate::testing

// SPDX-License-Identifier: BSD-3-Clause
#include "WholeBodyScene.h"

#include "Mechanics/JoinedText.h"
#include "Mechanics/Tools/ToolSpecification.h"
#include "ProgressLine.h"
#include "Response/Bodies/BodyYield.h"
#include "Response/Bodies/SoundBody.h"
#include "Response/BodyConversion.h"

#include <algorithm>
#include <cstdio>

namespace palpate
{
namespace
{
bool isAsked(const ViewerOptions& options, const ViewerScene& scene)
{
  const bool isHalfSpace =
    !scene.layer.isStack() && !scene.layer.scanned && scene.layer.thickness == 0.0;
  return options.wholeBody && !options.body.empty() && !scene.stored && isHalfSpace &&
    options.hands.empty() && options.trial.empty() && scene.poissonRatio <= LargestYieldRatio;
}

double widestContact(const ViewerOptions& options, const ViewerScene& scene)
{
  double widest = 0.0;
  for (const std::string& text : scene.tools)
  {
    ToolSpecification specification;
    std::string fault;
    if (parseTool(text, specification, fault))
    {
      widest = std::max(widest, makeTool(specification)->contactRadius(options.maximumDeflection));
    }
  }
  return widest;
}

/// Computes the compliance of the body as a whole, and attaches it if it is accurate. Returns "" or
/// a message about the fault.
std::string solve(
  const ViewerOptions& options, ViewerScene& scene, BodyYield& found, bool& isAttached)
{
  const SoundBody sound(scene.body);
  const double radius = widestContact(options, scene);
  if (!sound.fault().empty() || !(radius > 0.0) || !makeBodyMesh(sound.body()).isClosed())
  {
    return {}; // the response reports the fault
  }
  ProgressLine line("the body as a whole is solved");
  const YieldRequest asked{ scene.youngsModulus, scene.poissonRatio, radius,
    options.fixedGiven ? options.fixedFaces : "" };
  const std::string fault = findYield(
    sound.body(), asked, [&line](double done) { return line.show(done); }, found);
  isAttached = isAccurate(found, sound.body(), asked);
  if (isAttached)
  {
    const auto body = vtkSmartPointer<vtkPolyData>::New();
    body->ShallowCopy(sound.body());
    attachYield(found, body);
    sound.giveBack(body);
    scene.body = body;
  }
  return fault;
}
} // namespace

void addBodyCompliance(const ViewerOptions& options, ViewerScene& scene)
{
  if (!isAsked(options, scene))
  {
    return;
  }
  BodyYield found;
  bool isAttached = false;
  const std::string fault = solve(options, scene, found, isAttached);
  if (!fault.empty())
  {
    std::fprintf(stderr,
      "palpate: warning: the deflection of the whole body is not included, since %s\n",
      fault.c_str());
  }
  if (!isAttached)
  {
    if (!found.compliance.empty())
    {
      scene.notes.push_back("the forces do not include the deflection of the whole body: the "
                            "triangles of the surface are too large for it");
    }
    return;
  }
  scene.solid = true;
  scene.modelReason = "in series with the compliance of the whole body, by finite elements";
  scene.notes.push_back(joined("the forces include the deflection of the whole body, held at ",
    found.heldAt, " (--fixed, --no-whole-body)"));
  for (const std::string& warning : found.warnings)
  {
    std::fprintf(stderr, "palpate: warning: %s\n", warning.c_str());
  }
}
} // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "ComparisonStage.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <cstdio>

namespace palpate
{
namespace
{
constexpr double SupportColor[3] = { 0.58, 0.60, 0.63 };
}

void addSupport(vtkRenderer* renderer, vtkPolyData* support)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(support);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(SupportColor[0], SupportColor[1], SupportColor[2]);
  actor->PickableOff();
  renderer->AddActor(actor);
}

void setStage(vtkBodyComparison* comparison, const std::array<ComparedBody, 2>& bodies)
{
  const ViewerScene& scene = bodies[0].scene;
  comparison->SetYoungsModulus(scene.youngsModulus);
  comparison->SetPoissonRatio(scene.poissonRatio);
  comparison->SetDeflection(scene.depth);
  for (const int side : { vtkBodyComparison::Left, vtkBodyComparison::Right })
  {
    const ComparedBody& body = bodies[static_cast<std::size_t>(side)];
    comparison->SetBody(side, body.responses.body, body.scene.title);
    addSupport(comparison->GetRenderer(side), body.support);
  }
  const ResponseSet& responses = bodies[0].responses;
  for (std::size_t i = 0; i < responses.tools.size(); ++i)
  {
    comparison->AddTool(responses.tools[i], responses.names[i]);
  }
}

void printStatements(vtkBodyComparison* comparison, const std::array<ComparedBody, 2>& bodies)
{
  const ViewerScene& scene = bodies[0].scene;
  std::printf("  material    E = %g MPa, nu = %g (%s)\n  tools      ", scene.youngsModulus,
    scene.poissonRatio, scene.materialSource.c_str());
  for (const std::string& tool : scene.tools)
  {
    std::printf(" %s", tool.c_str());
  }
  std::printf("; the first one touches\n  model       local law %s\n", scene.modelReason.c_str());
  for (const int side : { vtkBodyComparison::Left, vtkBodyComparison::Right })
  {
    std::printf("\n%s\n%s\n", bodies[static_cast<std::size_t>(side)].scene.title.c_str(),
      comparison->GetStatement(side).c_str());
    for (int tool = 0; tool < comparison->GetNumberOfTools(); ++tool)
    {
      std::printf("  %-12s %8.4g N, lambda %.3f, sensitivity %.3f\n",
        scene.tools[static_cast<std::size_t>(tool)].c_str(), comparison->GetForce(side, tool),
        comparison->GetRegimeIndex(side, tool), comparison->GetToolSensitivity(side, tool));
    }
  }
}
} // namespace palpate

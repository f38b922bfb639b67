// SPDX-License-Identifier: BSD-3-Clause
#include "FrameScenes.h"

#include "vtkContactTool.h"

#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkLookupTable.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkScalarBarActor.h"

#include <chrono>

namespace palpate::benchmarks
{
namespace
{
constexpr int Width = 1024;
constexpr int Height = 768;
constexpr double View[3] = { 0.3, -1.0, 0.5 };
constexpr double Up[3] = { 0.0, 0.0, 1.0 };

/// Makes an actor as in a plain VTK program: with the body's normals, and coloured by a scalar
/// through the same legend.
vtkNew<vtkActor> plainActor(vtkPolyData* body, vtkScalarsToColors* colors)
{
  vtkNew<vtkPolyData> drawn;
  drawn->CopyStructure(body);
  drawn->GetPointData()->SetNormals(body->GetPointData()->GetNormals());
  vtkNew<vtkFloatArray> scalars;
  scalars->SetName("Displacement");
  scalars->SetNumberOfTuples(body->GetNumberOfPoints());
  scalars->Fill(0.0);
  drawn->GetPointData()->SetScalars(scalars);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(drawn);
  mapper->SetLookupTable(colors);
  mapper->UseLookupTableScalarRangeOn();
  mapper->InterpolateScalarsBeforeMappingOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  return actor;
}
} // namespace

std::string nameOf(FramePath path)
{
  return path == FramePath::Plain ? "plain" : path == FramePath::Shader ? "shader" : "filter";
}

FrameScene::FrameScene(FramePath path, vtkPolyData* body, vtkPolyData* probed)
  : Path(path)
  , Probed(probed)
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(Width, Height);
  this->Window->AddRenderer(this->Renderer);
  this->Scene->SetRenderer(this->Renderer);
  this->Scene->SetDeflectionByShader(path != FramePath::Filter);
  this->Scene->SetBody(body);
  vtkNew<vtkContactTool> tool;
  tool->SetShapeToSphere();
  this->Scene->SetTool(tool);
  this->Scene->SetLargestDeflection(1.5);
  this->Scene->SetLargestForce(30.0);
  this->Scene->LookAtBody(View, Up);
  if (path == FramePath::Plain)
  {
    vtkNew<vtkPolyData> nothing; // hides the scene's own body
    this->Scene->SetBody(nothing);
    this->Scene->GetBodyActor()->VisibilityOff();
    this->Renderer->AddActor(plainActor(body, this->Scene->GetLegend()->GetLookupTable()));
  }
}

double FrameScene::draw(vtkIdType contact)
{
  const auto begin = std::chrono::steady_clock::now();
  this->Scene->ShowTip(this->Probed, contact % this->Probed->GetNumberOfPoints());
  this->Window->Render();
  this->Window->WaitForCompletion();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}
} // namespace palpate::benchmarks

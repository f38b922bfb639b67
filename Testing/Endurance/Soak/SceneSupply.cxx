// SPDX-License-Identifier: BSD-3-Clause
#include "SceneSupply.h"

#include "Response/BodyConversion.h"

#include "vtkCellArray.h"
#include "vtkContactTool.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkToolContactResponse.h"

#include <array>

namespace palpate::endurance
{
namespace
{
constexpr double PoissonRatio = 0.45;
constexpr double Reach = 6.0;            // mm; deeper than any device presses
constexpr const char* Modulus = "Young"; // point array
// Strength and time constant (s). The first term relaxes within a press, the second within a visit.
constexpr std::array<std::array<double, 2>, 2> Relaxations = { { { 0.6, 0.03 }, { 0.4, 0.5 } } };

vtkSmartPointer<vtkPolyData> polyDataOf(const RoundBody& body)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vector3& point : body.points())
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  for (const Vector3& normal : body.normals())
  {
    normals->InsertNextTuple(normal.data());
  }
  vtkNew<vtkDoubleArray> young;
  young->SetName(Modulus);
  for (const double modulus : body.moduli())
  {
    young->InsertNextValue(modulus * (1.0 - PoissonRatio * PoissonRatio));
  }
  vtkNew<vtkCellArray> cells;
  for (const auto& triangle : body.triangles())
  {
    cells->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetPolys(cells);
  result->GetPointData()->SetNormals(normals);
  result->GetPointData()->AddArray(young);
  return result;
}

void shape(vtkContactTool* tool, const ToolLaw& law)
{
  tool->SetRadius(law.size());
  switch (law.shape())
  {
    case ToolLaw::Flat:
      tool->SetShapeToFlat();
      break;
    case ToolLaw::Paraboloid:
      tool->SetShapeToParaboloid();
      break;
    case ToolLaw::Cone:
      tool->SetShapeToCone();
      tool->SetRadius(1.0);
      tool->SetHalfAngle(law.size());
      break;
    case ToolLaw::Sphere:
      tool->SetShapeToSphere();
      break;
  }
}
} // namespace

SceneSupply::SceneSupply(unsigned seed, Supplied bodies)
  : Centre(12.5, -7.25, 3.125)
  , Tools({ { ToolLaw::Flat, 3.0 }, { ToolLaw::Paraboloid, 6.35 }, { ToolLaw::Cone, 70.0 },
      { ToolLaw::Sphere, 12.0 } })
  , Random(seed)
{
  const double r = Radius;
  const std::vector<BodyForm> forms = { { this->Centre, { r, r, r }, 0.0, 0.1, 0.0 },
    { this->Centre, { r - 1.0, r + 1.0, r + 0.5 }, 0.0, 0.06, 0.3 },
    { this->Centre, { r, r, r }, 0.5, 0.12, 0.2 },
    { this->Centre, { r - 0.5, r - 0.5, r - 0.5 }, 0.0, 0.3, 0.5 },
    { this->Centre, { r, r - 0.5, r }, 0.2, 0.08, 0.2 } }; // only the last one relaxes
  for (const BodyForm& form : forms)
  {
    constexpr int times = 3; // 1280 triangles of about 7 mm
    this->Bodies.push_back(std::make_shared<RoundBody>(form, times));
    this->Shapes.push_back(polyDataOf(*this->Bodies.back()));
  }
  this->From = bodies == Supplied::Relaxing ? forms.size() - 1 : 0;
  this->Count = bodies == Supplied::Relaxing ? 1 : forms.size();
  this->Count -= bodies == Supplied::Elastic ? 1 : 0;
}

SuppliedScene SceneSupply::make()
{
  // Chooses any pair of body and tool except the previous pair.
  const std::size_t pairs = this->Count * this->Tools.size();
  this->Last = (this->Last + 1 + this->draw(pairs - 1)) % pairs;
  const std::size_t body = this->From + this->Last / this->Tools.size();
  const ToolLaw& law = this->Tools[this->Last % this->Tools.size()];
  SuppliedScene made;
  made.felt = { this->Bodies[body], law, this->draw(2) == 0 ? 0.0 : 0.4, 0.0, 16 };
  const bool relaxes = body + 1 == this->Bodies.size();

  vtkNew<vtkContactTool> tool;
  shape(tool, law);
  vtkNew<vtkToolContactResponse> response;
  response->SetInputData(this->Shapes[body]);
  response->SetTool(tool);
  response->SetPoissonRatio(PoissonRatio);
  response->SetMaximumDeflection(Reach);
  response->SetResponseName(ResponseName);
  response->CurvatureCorrectionOff(); // the closed form is valid for a flat body
  response->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, Modulus);
  for (const auto& [strength, seconds] : Relaxations)
  {
    if (relaxes)
    {
      response->AddRelaxation(strength, seconds);
      made.felt.relaxation += strength;
    }
  }
  made.felt.elements = relaxes && this->draw(2) == 0 ? 0 : 16; // quasi-linear
  response->Update();
  made.body = vtkSmartPointer<vtkPolyData>::New();
  made.body->DeepCopy(response->GetOutput());
  made.kernel = palpate::makeContactBody(made.body, ResponseName, made.error);
  return made;
}
} // namespace palpate::endurance

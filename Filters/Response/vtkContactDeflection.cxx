// SPDX-License-Identifier: BSD-3-Clause
#include "vtkContactDeflection.h"

#include "AxisymmetricTool.h"
#include "BodyConversion.h"
#include "LayerContact.h"
#include "LayerSurface.h"
#include "ReducedModulus.h"
#include "ResponseTool.h"
#include "SurfacePatch.h"
#include "vtkContactTool.h"

#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace
{
/// The contact of one tip, read back from the probe's arrays.
struct TipContact
{
  vtkIdType cell = -1;
  double deflection = 0.0;
  palpate::Vector3 point;
  palpate::Vector3 normal;
};

/// Returns an error that names what is missing, or "".
std::string readTip(vtkPolyData* tips, vtkIdType index, TipContact& contact)
{
  vtkPointData* data = tips->GetPointData();
  vtkDataArray* cells = data->GetArray("ContactCell");
  vtkDataArray* deflections = data->GetArray("Deflection");
  vtkDataArray* points = data->GetArray("ContactPoint");
  vtkDataArray* normals = data->GetArray("Normal");
  if (!cells || !deflections || !points || !normals || points->GetNumberOfComponents() != 3 ||
    normals->GetNumberOfComponents() != 3)
  {
    return "port 1 must be the output of vtkToolContactProbe: ContactCell, Deflection, "
           "ContactPoint(3) or Normal(3) is missing";
  }
  contact.cell = static_cast<vtkIdType>(cells->GetTuple1(index));
  contact.deflection = deflections->GetTuple1(index);
  points->GetTuple(index, contact.point.data());
  normals->GetTuple(index, contact.normal.data());
  return {};
}

/// The thickness of the layer under the contact, mm; 0 on a half-space. 1/h is interpolated, which
/// is what a base stiffens by, and 0 where there is none.
double thicknessAt(const palpate::BodyMesh& mesh, std::int32_t triangle,
  const palpate::Vector3& contact, vtkDataArray* thickness)
{
  const auto& corners = mesh.corners(triangle);
  const palpate::Vector3 weights = mesh.project(contact, triangle).weights;
  double inverse = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double h = thickness->GetTuple1(corners[i]);
    inverse += h > 0.0 ? weights[static_cast<Eigen::Index>(i)] / h : 0.0;
  }
  return inverse > 0.0 ? 1.0 / inverse : 0.0;
}
} // namespace

vtkStandardNewMacro(vtkContactDeflection);

vtkContactDeflection::vtkContactDeflection()
{
  this->SetNumberOfInputPorts(2);
}

vtkContactDeflection::~vtkContactDeflection() = default;

void vtkContactDeflection::SetTool(vtkContactTool* tool)
{
  if (this->Tool != tool)
  {
    this->Tool = tool;
    this->Modified();
  }
}

vtkContactTool* vtkContactDeflection::GetTool()
{
  return this->Tool;
}

vtkMTimeType vtkContactDeflection::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Tool ? std::max(own, this->Tool->GetMTime()) : own;
}

int vtkContactDeflection::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

const palpate::BodyMesh& vtkContactDeflection::PrepareMesh(vtkPolyData* body)
{
  // Modification times are unique, so the two name this pair.
  const vtkMTimeType points = body->GetPoints()->GetMTime();
  const vtkMTimeType polys = body->GetPolys()->GetMTime();
  if (!this->Mesh || this->MeshPointsTime != points || this->MeshPolysTime != polys)
  {
    this->Mesh = std::make_unique<palpate::BodyMesh>(palpate::makeBodyMesh(body));
    this->MeshPointsTime = points;
    this->MeshPolysTime = polys;
  }
  return *this->Mesh;
}

vtkContactDeflection::Field vtkContactDeflection::MakeField(
  vtkPolyData* body, const palpate::AxisymmetricTool& tool, double thickness, double deflection)
{
  if (!(thickness > 0.0))
  {
    return [&tool, deflection, nu = this->PoissonRatio](double r)
    { return tool.surfaceDisplacement(r, deflection, nu); };
  }
  vtkDataArray* stored = body->GetFieldData()->GetArray((this->ResponseName + "LayerBase").c_str());
  const auto base = stored && stored->GetNumberOfValues() == 1 && stored->GetTuple1(0) == 1.0
    ? palpate::LayerBase::Slip
    : palpate::LayerBase::Bonded;
  if (!this->Kernel || this->Kernel->poissonsRatio() != this->PoissonRatio ||
    this->Kernel->base() != base)
  {
    this->Kernel = std::make_shared<const palpate::LayerKernel>(this->PoissonRatio, base);
  }
  auto layer = std::make_shared<const palpate::LayerContact>(tool, this->Kernel, thickness);
  if (deflection > layer->deepest())
  {
    vtkWarningMacro(<< "No field: the layer of " << thickness
                    << " mm at the contact is thinner than a tenth of the contact radius.");
  }
  auto surface = std::make_shared<const palpate::LayerSurface>(*layer, deflection);
  return [layer, surface](double r) { return surface->at(r); };
}

int vtkContactDeflection::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* body = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* tips = vtkPolyData::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (!body || body->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  const std::string fault = palpate::checkTriangles(body);
  if (!fault.empty())
  {
    vtkErrorMacro(<< "Wrong body: " << fault << ".");
    return 0;
  }
  if (!palpate::isPoissonsRatio(this->PoissonRatio))
  {
    vtkErrorMacro(<< "PoissonRatio must lie between 0 and 0.5, but is " << this->PoissonRatio
                  << ".");
    return 0;
  }
  std::string noTool;
  const vtkSmartPointer<vtkContactTool> tool =
    palpate::findTool(this->Tool, body, this->ResponseName, noTool);
  if (!noTool.empty())
  {
    vtkErrorMacro(<< noTool << ".");
  }
  const palpate::AxisymmetricTool* law = tool ? tool->GetKernel() : nullptr;
  if (!law)
  {
    return 0;
  }

  vtkNew<vtkFloatArray> displacement;
  displacement->SetName("ContactDisplacement");
  displacement->SetNumberOfComponents(3);
  displacement->SetNumberOfTuples(body->GetNumberOfPoints());
  displacement->Fill(0.0);
  TipContact contact;
  if (tips && tips->GetNumberOfPoints() > 0)
  {
    const vtkIdType tip = this->TipIndex < 0 ? tips->GetNumberOfPoints() - 1 : this->TipIndex;
    const std::string missing =
      tip < tips->GetNumberOfPoints() ? readTip(tips, tip, contact) : std::string();
    if (tip >= tips->GetNumberOfPoints() || !missing.empty())
    {
      vtkErrorMacro(<< (missing.empty()
                           ? "TipIndex " + std::to_string(tip) + " is beyond the last of " +
                             std::to_string(tips->GetNumberOfPoints()) + " tips"
                           : missing)
                    << ".");
      return 0;
    }
  }
  const vtkIdType firstPoly = body->GetNumberOfVerts() + body->GetNumberOfLines();
  if (contact.cell >= firstPoly + body->GetNumberOfPolys() ||
    (contact.cell >= 0 && contact.cell < firstPoly))
  {
    vtkErrorMacro(<< "ContactCell " << contact.cell
                  << " is not a triangle of the body: were the tips probed on another body?");
    return 0;
  }
  if (contact.cell >= 0 && contact.deflection > 0.0)
  {
    const std::string model = palpate::responseText(body, this->ResponseName, "Model");
    if (model.find("compliance") != std::string::npos && model != this->WarnedOfModel)
    {
      vtkWarningMacro(<< "The response has a global compliance; the field shows the local "
                         "part alone, at the whole deflection.");
      this->WarnedOfModel = model; // a live display asks for the field many times a second
    }
    const palpate::BodyMesh& mesh = this->PrepareMesh(body);
    const auto triangle = static_cast<std::int32_t>(contact.cell - firstPoly);
    vtkDataArray* layers =
      body->GetPointData()->GetArray((this->ResponseName + "LayerThickness").c_str());
    const Field field = this->MakeField(body, *law,
      layers ? thicknessAt(mesh, triangle, contact.point, layers) : 0.0, contact.deflection);
    palpate::visitSurfacePatch(mesh, triangle, contact.point, contact.normal, this->MaximumDistance,
      [&](std::int32_t id, double distance, const palpate::Vector3& away)
      {
        const palpate::SurfaceDisplacement u = field(distance);
        const Eigen::Vector3f vector = (u.radial * away - u.normal * contact.normal).cast<float>();
        displacement->SetTypedTuple(id, vector.data());
      });
  }
  output->ShallowCopy(body);
  output->GetPointData()->AddArray(displacement);
  return 1;
}

void vtkContactDeflection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tool: " << this->Tool.Get() << "\n";
  os << indent << "TipIndex: " << this->TipIndex << "\n";
  os << indent << "PoissonRatio: " << this->PoissonRatio << "\n";
  os << indent << "MaximumDistance: " << this->MaximumDistance << " mm\n";
  os << indent << "ResponseName: " << this->ResponseName << "\n";
}

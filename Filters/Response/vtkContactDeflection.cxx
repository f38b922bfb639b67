// SPDX-License-Identifier: BSD-3-Clause
#include "vtkContactDeflection.h"

#include "BodyConversion.h"
#include "ContactField.h"
#include "ReducedModulus.h"
#include "ResponseTool.h"
#include "SurfacePatch.h"
#include "vtkContactTool.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <vector>

namespace
{
/// Returns an error that names what is missing, or "".
std::string readTip(vtkPolyData* tips, vtkIdType index, palpate::FieldContact& contact)
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
  vtkDataArray* forces = data->GetArray("NormalForce");
  contact.force = forces ? forces->GetTuple1(index) : 0.0;
  return {};
}

void addGlobalPart(const std::vector<vtkDataArray*>& modes, const palpate::ContactField& field,
  vtkFloatArray* displacement)
{
  for (std::size_t k = 0; k < field.modeWeights().size(); ++k)
  {
    const double weight = field.modeWeights()[k];
    vtkSMPTools::For(0, displacement->GetNumberOfTuples(),
      [mode = modes[k], weight, displacement](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          palpate::Vector3 phi;
          mode->GetTuple(i, phi.data());
          Eigen::Map<Eigen::Vector3f>(displacement->GetPointer(3 * i)) +=
            (weight * phi).cast<float>();
        }
      });
  }
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

bool vtkContactDeflection::CheckTip(vtkPolyData* tips, palpate::FieldContact& contact)
{
  if (!tips || tips->GetNumberOfPoints() == 0)
  {
    return true;
  }
  const vtkIdType count = tips->GetNumberOfPoints();
  const vtkIdType tip = this->TipIndex < 0 ? count - 1 : this->TipIndex;
  if (tip >= count)
  {
    vtkErrorMacro(<< "TipIndex " << tip << " is beyond the last of " << count << " tips.");
    return false;
  }
  const std::string missing = readTip(tips, tip, contact);
  if (!missing.empty())
  {
    vtkErrorMacro(<< missing << ".");
  }
  return missing.empty();
}

palpate::ContactField vtkContactDeflection::MakeField(
  vtkPolyData* body, const palpate::AxisymmetricTool& tool, const palpate::FieldContact& contact)
{
  const palpate::FieldSettings settings{ this->ResponseName, this->PoissonRatio,
    this->MaximumDistance };
  palpate::ContactField field(body, tool, contact, settings, this->Kernel);
  if (!field.fault().empty())
  {
    vtkWarningMacro(<< field.fault() << ".");
  }
  const std::string model = palpate::responseText(body, this->ResponseName, "Model");
  if (palpate::isInSeries(body, this->ResponseName) && field.modeWeights().empty() &&
    model != this->WarnedOfModel)
  {
    vtkWarningMacro(<< "The response has a global compliance, but the body no GlobalMode0...; the "
                       "field shows the local part alone, at the whole deflection.");
    this->WarnedOfModel = model; // a live display asks for the field many times a second
  }
  return field;
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
  palpate::FieldContact contact;
  if (!this->CheckTip(tips, contact))
  {
    return 0;
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
    const palpate::ContactField field = this->MakeField(body, *law, contact);
    addGlobalPart(palpate::globalModes(body, this->ResponseName), field, displacement);
    const palpate::BodyMesh& mesh = this->PrepareMesh(body);
    palpate::visitSurfacePatch(mesh, static_cast<std::int32_t>(contact.cell - firstPoly),
      contact.point, contact.normal, this->MaximumDistance,
      [&](std::int32_t id, double distance, const palpate::Vector3& away)
      {
        const palpate::SurfaceDisplacement u = field.local(distance);
        const double share = field.fade(distance, mesh.pointNormal(id).dot(contact.normal));
        float* vector = displacement->GetPointer(3 * static_cast<vtkIdType>(id));
        Eigen::Map<Eigen::Vector3f>(vector) +=
          (share * (u.radial * away - u.normal * contact.normal)).cast<float>();
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

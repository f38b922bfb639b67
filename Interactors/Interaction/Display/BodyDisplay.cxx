// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/BodyDisplay.h"

#include "Response/BodyConversion.h"
#include "Response/Pieces/Ranks.h"
#include "Interaction/Display/DeflectionShader.h"
#include "Interaction/Display/ModeAttributes.h"
#include "Mechanics/ReducedModulus.h"
#include "Response/ResponseTool.h"
#include "vtkContactTool.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkTriangleMeshPointNormals.h"
#include "vtkWarpVector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace palpate
{
namespace
{
constexpr const char* Displacement = "ContactDisplacement";
constexpr const char* Normals = "SurfaceNormals";

void colorByDisplacement(vtkMapper* mapper, vtkLookupTable* colors)
{
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray(Displacement);
  mapper->SetLookupTable(colors);
  mapper->UseLookupTableScalarRangeOn();
  mapper->InterpolateScalarsBeforeMappingOn();
}

vtkSmartPointer<vtkFloatArray> normalsOf(const BodyMesh& mesh)
{
  auto normals = vtkSmartPointer<vtkFloatArray>::New();
  normals->SetName(Normals);
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(static_cast<vtkIdType>(mesh.pointCount()));
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    const Eigen::Vector3f normal = mesh.pointNormal(static_cast<std::int32_t>(i)).cast<float>();
    normals->SetTypedTuple(i, normal.data());
  }
  return normals;
}

/// Mean length of the edges of a triangle, mm.
double edgeOf(const std::array<Vector3, 3>& corners)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    sum += (corners[(i + 1) % 3] - corners[i]).norm();
  }
  return sum / 3.0;
}

double longestOf(const std::vector<vtkDataArray*>& modes)
{
  double longest = 0.0;
  for (vtkDataArray* mode : modes)
  {
    longest = std::max(longest, mode->GetMaxNorm());
  }
  return longest;
}

/// Of all that is drawn of a body but the dent. Such times are unique, so they name it.
std::vector<vtkMTimeType> timesOf(vtkPolyData* body, const std::vector<vtkDataArray*>& modes)
{
  std::vector<vtkMTimeType> times;
  if (body->GetPoints())
  {
    times = { body->GetPoints()->GetMTime(), body->GetVerts()->GetMTime(),
      body->GetLines()->GetMTime(), body->GetPolys()->GetMTime(), body->GetStrips()->GetMTime() };
  }
  for (vtkDataArray* mode : modes)
  {
    times.push_back(mode->GetMTime());
  }
  return times;
}

FieldContact fieldContact(const ShownContact& shown)
{
  const Contact& felt = shown.tick.contact;
  return { shown.cell, felt.deflection, (shown.tick.idealForce - felt.friction).dot(felt.normal),
    felt.contactPoint, felt.normal };
}
} // namespace

BodyDisplay::BodyDisplay(vtkLookupTable* colors)
  : Actor(vtkSmartPointer<vtkActor>::New())
  , Mapper(vtkSmartPointer<DentMapper>::New())
  , Shader(this->Actor)
  , Displaced(vtkSmartPointer<vtkPolyData>::New())
  , Warp(vtkSmartPointer<vtkWarpVector>::New())
  , PointsMapper(vtkSmartPointer<vtkPolyDataMapper>::New())
{
  this->Warp->SetInputData(this->Displaced);
  this->Warp->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, Displacement);
  vtkNew<vtkTriangleMeshPointNormals> normals;
  normals->SetInputConnection(this->Warp->GetOutputPort());
  this->PointsMapper->SetInputConnection(normals->GetOutputPort());
  colorByDisplacement(this->PointsMapper, colors);
  colorByDisplacement(this->Mapper, colors);
  this->Mapper->MapDataArrayToVertexAttribute(
    DeflectionShader::NormalAttribute, Normals, vtkDataObject::FIELD_ASSOCIATION_POINTS);
  this->Actor->SetMapper(this->Mapper);
}

BodyDisplay::~BodyDisplay() = default;

void BodyDisplay::setBody(vtkPolyData* body)
{
  this->Body = body;
  this->Shown.cell = -1; // a contact with the body before
  this->BodyTime = 0;
  this->refresh();
}

void BodyDisplay::setTool(vtkContactTool* tool)
{
  this->Tool = tool;
  this->refresh();
}

void BodyDisplay::setPoissonRatio(double ratio)
{
  this->PoissonRatio = ratio;
  this->refresh();
}

void BodyDisplay::setResponseName(const std::string& name)
{
  this->ResponseName = name;
  this->BodyTime = 0; // other modes, or none
  this->refresh();
}

void BodyDisplay::setFieldRadius(double radius)
{
  this->FieldRadius = radius;
  this->refresh();
}

void BodyDisplay::setExaggeration(double factor)
{
  this->Warp->SetScaleFactor(factor);
  this->refresh();
}

double BodyDisplay::exaggeration() const
{
  return this->Warp->GetScaleFactor();
}

void BodyDisplay::setByShader(bool on)
{
  if (this->ByShader == on)
  {
    return;
  }
  this->ByShader = on;
  this->BodyTime = 0;
  if (on)
  {
    this->Actor->SetMapper(this->Mapper);
  }
  else
  {
    this->Actor->SetMapper(this->PointsMapper);
    this->Shader.remove();
  }
  this->refresh();
}

void BodyDisplay::show(const ShownContact& contact)
{
  this->Shown = contact;
  this->refresh();
}

void BodyDisplay::refresh()
{
  if (!this->Body)
  {
    return;
  }
  if (this->ByShader)
  {
    this->showByShader();
  }
  else
  {
    this->showByPoints();
  }
}

void BodyDisplay::takeBody()
{
  this->BodyTime = this->Body->GetMTime();
  this->HasField = this->Body->GetNumberOfPoints() > 0;
  const auto modes = globalModeArrays(this->Body, this->ResponseName);
  const auto times = timesOf(this->Body, modes);
  if (this->HasField && this->DrawnTimes == times)
  {
    this->installShader(modes.size());
    return; // the same surface, under other responses
  }
  this->DrawnTimes.clear();
  vtkNew<vtkPolyData> drawn;
  drawn->CopyStructure(this->Body);
  const std::string fault = this->HasField ? checkTriangles(this->Body) : std::string();
  this->complain(fault.empty() ? fault : "Wrong body: " + fault);
  if (!this->HasField || !fault.empty())
  {
    this->HasField = false;
    this->Shader.remove();
    this->Mapper->SetInputData(drawn);
    return;
  }
  const BodyMesh mesh = makeBodyMesh(this->Body);
  drawn->GetPointData()->SetNormals(normalsOf(mesh));
  vtkNew<vtkFloatArray> none; // without it the mapper would make no texture of the colours
  none->SetName(Displacement);
  none->SetNumberOfTuples(drawn->GetNumberOfPoints());
  none->Fill(0.0);
  drawn->GetPointData()->AddArray(none);
  this->ModeLength = longestOf(modes);
  addModeAttributes(mesh, modes, drawn, this->Mapper);
  this->Mapper->SetInputData(drawn);
  this->installShader(modes.size());
  this->DrawnTimes = times;
}

void BodyDisplay::installShader(std::size_t modes)
{
  this->Shader.install(static_cast<int>(std::min(modes, MostModes)),
    this->Body->GetPointData()->HasArray(NearFieldArray) != 0);
}

ContactField BodyDisplay::makeField(const FieldContact& contact)
{
  std::string fault;
  this->CircleRadius = 0.0;
  this->CircleDepth = 0.0;
  this->Edge = 1.0;
  if (contact.cell < 0 || !this->HasField || this->Body->GetNumberOfPoints() == 0)
  {
    return {};
  }
  this->PressedTool = findTool(this->Tool, this->Body, this->ResponseName, fault);
  const AxisymmetricTool* law = this->PressedTool ? this->PressedTool->GetKernel() : nullptr;
  if (fault.empty() && !isPoissonsRatio(this->PoissonRatio))
  {
    fault = "PoissonRatio must lie between 0 and 0.5";
  }
  if (fault.empty() && !isTriangle(this->Body, static_cast<vtkIdType>(contact.cell)))
  {
    fault = "The cell of the contact is not a triangle of the body";
  }
  if (!law || !fault.empty())
  {
    this->complain(fault);
    return {};
  }
  const FieldTriangle triangle =
    fieldTriangle(this->Body, static_cast<vtkIdType>(contact.cell), this->ResponseName);
  ContactField field(
    triangle, *law, contact, { this->PoissonRatio, this->FieldRadius }, this->Kernel);
  this->complain(field.fault());
  if (!field.isEmpty())
  {
    this->Edge = edgeOf(triangle.corners);
    this->CircleRadius = field.contactRadius();
    this->CircleDepth =
      contact.deflection - field.localDeflection() + field.local(this->CircleRadius).normal;
  }
  return field;
}

void BodyDisplay::complain(const std::string& fault)
{
  if (!fault.empty() && fault != this->Fault)
  {
    vtkErrorWithObjectMacro(this->Actor, << fault << ".");
  }
  this->Fault = fault;
}

void BodyDisplay::showByShader()
{
  if (this->BodyTime != this->Body->GetMTime())
  {
    this->takeBody();
  }
  const FieldContact contact = fieldContact(this->Shown);
  const ContactField field = this->makeField(contact);
  this->Shader.show(field, contact, this->Edge, this->exaggeration());
  double around = 0.0;
  for (const double weight : field.modeWeights())
  {
    around += std::abs(weight) * this->ModeLength;
  }
  const NearField& near = field.nearField();
  around += std::abs(near.depth) + std::abs(field.nearDepth()) + near.slope.norm() * near.radius +
    near.bend.norm() * near.radius * near.radius;
  const Vector3 deepest =
    contact.point - this->exaggeration() * contact.deflection * contact.normal;
  this->Mapper->setDent(deepest.data(), contact.cell < 0 ? -1.0 : this->exaggeration() * around);
}

void BodyDisplay::showByPoints()
{
  const FieldContact contact = fieldContact(this->Shown);
  const bool isNew = this->BodyTime != this->Body->GetMTime();
  if (!this->Shown.touches() && !this->IsDented && !isNew)
  {
    return; // no dent before, none now: the body need not be drawn anew
  }
  this->BodyTime = this->Body->GetMTime();
  this->HasField = this->Body->GetNumberOfPoints() > 0;
  std::string fault = this->HasField ? checkBody(this->Body, this->ResponseName) : std::string();
  this->Displaced->Initialize();
  if (!this->HasField || !fault.empty())
  {
    this->HasField = false;
    this->complain(fault.empty() ? fault : "Wrong body: " + fault);
    return;
  }
  const ContactField field = this->makeField(contact);
  this->IsDented = !field.isEmpty() || !field.modeWeights().empty();
  this->Displaced->ShallowCopy(this->Body);
  vtkNew<vtkFloatArray> displacement;
  fault = this->Field.displace(Ranks(), this->Body, this->IsDented ? contact : FieldContact(), 0,
    { this->PressedTool ? this->PressedTool->GetKernel() : nullptr, this->ResponseName,
      { this->PoissonRatio, DeflectionShader::reachOf(field) } },
    displacement);
  if (!fault.empty())
  {
    this->complain(fault);
  }
  for (const std::string& warning : this->Field.warnings())
  {
    vtkWarningWithObjectMacro(this->Actor, << warning << ".");
  }
  this->Displaced->GetPointData()->AddArray(displacement);
}

void BodyDisplay::bounds(double bounds[6])
{
  this->Body->GetBounds(bounds);
}
} // namespace palpate

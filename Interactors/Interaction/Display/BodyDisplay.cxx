// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/BodyDisplay.h"

#include "Mechanics/Checked.h"
#include "Response/BodyConversion.h"
#include "Response/BodyField.h"
#include "Response/Pieces/Ranks.h"
#include "Interaction/Display/DeflectionShader.h"
#include "Interaction/Display/DrawnSurface.h"
#include "Mechanics/ReducedModulus.h"
#include "Response/ResponseTool.h"
#include "vtkContactTool.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkTriangleMeshPointNormals.h"
#include "vtkWarpVector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace palpate
{
namespace
{
constexpr const char* Displacement = DrawnSurface::Displacement;

void colorByDisplacement(vtkMapper* mapper, vtkLookupTable* colors)
{
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray(Displacement);
  mapper->SetLookupTable(colors);
  mapper->UseLookupTableScalarRangeOn();
  mapper->InterpolateScalarsBeforeMappingOn();
}

std::string firstOf(const std::vector<std::string>& faults)
{
  const auto first = std::find_if(
    faults.begin(), faults.end(), [](const std::string& fault) { return !fault.empty(); });
  return first == faults.end() ? std::string() : *first;
}

FieldContact fieldContact(const ShownContact& shown)
{
  const Contact& felt = shown.tick.contact;
  FieldContact contact{ shown.cell, felt.deflection,
    (shown.tick.idealForce - felt.friction).dot(felt.normal), felt.contactPoint, felt.normal };
  if (shown.isLowered())
  {
    contact.depth = shown.tipDepth();
  }
  return contact;
}
} // namespace

struct BodyDisplay::Dent
{
  FieldContact contact;
  double circleRadius = 0.0;
  double circleDepth = 0.0;
  double edge = 1.0; ///< mean edge length of the triangle in contact, mm
  /// Tool of the last field. It is kept because the field refers to it.
  vtkSmartPointer<vtkContactTool> tool;
  std::shared_ptr<const LayerKernel> kernel;
  std::unique_ptr<BodyField> byPoints = std::make_unique<BodyField>();
};

BodyDisplay::BodyDisplay(vtkLookupTable* colors)
  : Actor(vtkSmartPointer<vtkActor>::New())
  , Dents(1)
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
  this->Mapper->MapDataArrayToVertexAttribute(DeflectionShader::NormalAttribute,
    DrawnSurface::Normals, vtkDataObject::FIELD_ASSOCIATION_POINTS);
  this->Actor->SetMapper(this->Mapper);
}

BodyDisplay::~BodyDisplay() = default;

void BodyDisplay::setBody(vtkPolyData* body)
{
  this->Body = body;
  for (Dent& dent : this->Dents)
  {
    dent.contact.cell = -1; // no contact, because the old contact was on the old body
  }
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
  this->BodyTime = 0; // the body must be read again, because another response may have other modes
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

void BodyDisplay::show(const std::vector<ShownContact>& contacts)
{
  const std::size_t count = std::max<std::size_t>(contacts.size(), 1);
  if (count != this->Dents.size())
  {
    this->Dents.resize(count);
    this->BodyTime = 0; // the shader code depends on the number of contacts
  }
  this->Dents.front().contact.cell = -1;
  for (std::size_t i = 0; i < contacts.size(); ++i)
  {
    this->Dents[i].contact = fieldContact(contacts[i]);
  }
  this->refresh();
}

double BodyDisplay::contactRadius(std::size_t contact) const
{
  return contact < this->Dents.size() ? this->Dents[contact].circleRadius : 0.0;
}

double BodyDisplay::circleDepth(std::size_t contact) const
{
  return contact < this->Dents.size() ? this->Dents[contact].circleDepth : 0.0;
}

bool BodyDisplay::touches() const
{
  return std::any_of(this->Dents.begin(), this->Dents.end(),
    [](const Dent& dent) { return dent.contact.cell >= 0; });
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
  const auto times = DrawnSurface::timesOf(this->Body, modes);
  if (this->HasField && this->DrawnTimes == times)
  {
    this->installShader(modes.size());
    return; // the surface is unchanged; only the responses have changed
  }
  this->DrawnTimes.clear();
  const std::string fault = this->HasField ? checkTriangles(this->Body) : std::string();
  this->complain(prefixed("Wrong body: ", fault));
  if (!this->HasField || !fault.empty())
  {
    this->HasField = false;
    this->Shader.remove();
    vtkNew<vtkPolyData> bare;
    bare->CopyStructure(this->Body);
    this->Mapper->SetInputData(bare);
    return;
  }
  this->ModeLength = DrawnSurface::longestOf(modes);
  DrawnSurface::give(this->Body, modes, this->Mapper);
  this->installShader(modes.size());
  this->DrawnTimes = times;
}

void BodyDisplay::installShader(std::size_t modes)
{
  this->Shader.install({ static_cast<int>(std::min(modes, MostModes)),
    this->Body->GetPointData()->HasArray(NearFieldArray) != 0,
    static_cast<int>(this->Dents.size()) });
}

ContactField BodyDisplay::makeField(Dent& dent, std::string& fault)
{
  const FieldContact& contact = dent.contact;
  dent.circleRadius = 0.0;
  dent.circleDepth = 0.0;
  dent.edge = 1.0;
  if (contact.cell < 0 || !this->HasField || this->Body->GetNumberOfPoints() == 0)
  {
    return {};
  }
  dent.tool = findTool(this->Tool, this->Body, this->ResponseName, fault);
  const AxisymmetricTool* law = dent.tool ? dent.tool->GetKernel() : nullptr;
  if (fault.empty() && !isPoissonsRatio(this->PoissonRatio))
  {
    fault = "Poisson's Ratio must lie between 0 and 0.5";
  }
  if (fault.empty() && !isTriangle(this->Body, static_cast<vtkIdType>(contact.cell)))
  {
    fault = "The cell of the contact is not a triangle of the body";
  }
  if (!law || !fault.empty())
  {
    return {};
  }
  const FieldTriangle triangle =
    fieldTriangle(this->Body, static_cast<vtkIdType>(contact.cell), this->ResponseName);
  ContactField field(
    triangle, *law, contact, { this->PoissonRatio, this->FieldRadius }, dent.kernel);
  fault = field.fault();
  if (!field.isEmpty())
  {
    dent.edge = DrawnSurface::edgeOf(triangle.corners);
    dent.circleRadius = field.contactRadius();
    const double depth = std::isfinite(contact.depth) ? contact.depth : contact.deflection;
    dent.circleDepth = depth - field.localDeflection() + field.local(dent.circleRadius).normal;
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
  std::vector<DrawnDent> drawn;
  std::vector<std::string> faults(this->Dents.size());
  double around = 0.0;
  Vector3 deepest = this->Dents.front().contact.point;
  double most = -1.0;
  for (Dent& dent : this->Dents)
  {
    const ContactField field = this->makeField(dent, faults[drawn.size()]);
    drawn.push_back({ field, dent.contact, dent.edge });
    for (const double weight : field.modeWeights())
    {
      around += std::abs(weight) * this->ModeLength;
    }
    const NearField& near = field.nearField();
    around += std::abs(near.depth) + std::abs(field.nearDepth()) + near.slope.norm() * near.radius +
      near.bend.norm() * near.radius * near.radius;
    if (dent.contact.cell >= 0 && dent.contact.deflection > most)
    {
      most = dent.contact.deflection;
      deepest = dent.contact.point - this->exaggeration() * most * dent.contact.normal;
    }
  }
  this->complain(firstOf(faults));
  this->Shader.show(drawn, this->exaggeration());
  this->Mapper->setDent(deepest.data(), most < 0.0 ? -1.0 : this->exaggeration() * around);
}

void BodyDisplay::showByPoints()
{
  const bool isNew = this->BodyTime != this->Body->GetMTime();
  if (!this->touches() && !this->IsDented && !isNew)
  {
    return; // nothing is drawn again, because there was no dent and there is still none
  }
  this->BodyTime = this->Body->GetMTime();
  this->HasField = this->Body->GetNumberOfPoints() > 0;
  const std::string wrong =
    this->HasField ? checkBody(this->Body, this->ResponseName) : std::string();
  this->Displaced->Initialize();
  if (!this->HasField || !wrong.empty())
  {
    this->HasField = false;
    this->complain(prefixed("Wrong body: ", wrong));
    return;
  }
  this->IsDented = false;
  this->Displaced->ShallowCopy(this->Body);
  std::vector<std::string> faults;
  vtkSmartPointer<vtkFloatArray> sum;
  for (Dent& dent : this->Dents)
  {
    const auto displacement = this->displaceByPoints(dent, faults.emplace_back());
    if (sum)
    {
      addDisplacements(displacement, sum);
    }
    else
    {
      sum = displacement;
    }
  }
  this->complain(firstOf(faults));
  this->Displaced->GetPointData()->AddArray(sum);
}

vtkSmartPointer<vtkFloatArray> BodyDisplay::displaceByPoints(Dent& dent, std::string& fault)
{
  const ContactField field = this->makeField(dent, fault);
  const bool isDented = !field.isEmpty() || !field.modeWeights().empty();
  this->IsDented = this->IsDented || isDented;
  auto displacement = vtkSmartPointer<vtkFloatArray>::New();
  const std::string wrong =
    dent.byPoints->displace(Ranks(), this->Body, isDented ? dent.contact : FieldContact(), 0,
      { dent.tool ? dent.tool->GetKernel() : nullptr, this->ResponseName,
        { this->PoissonRatio, DeflectionShader::reachOf(field) } },
      displacement);
  if (fault.empty())
  {
    fault = wrong;
  }
  for (const std::string& warning : dent.byPoints->warnings())
  {
    vtkWarningWithObjectMacro(this->Actor, << warning << ".");
  }
  return displacement;
}

void BodyDisplay::bounds(double bounds[6])
{
  this->Body->GetBounds(bounds);
}
} // namespace palpate

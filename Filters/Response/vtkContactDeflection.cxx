// SPDX-License-Identifier: BSD-3-Clause
#include "vtkContactDeflection.h"

#include "Response/BodyConversion.h"
#include "Response/Pieces/BodySeam.h"
#include "Response/Pieces/ChosenTip.h"
#include "Response/ContactField.h"
#include "Response/Pieces/OwnPiece.h"
#include "Response/Pieces/Ranks.h"
#include "Mechanics/ReducedModulus.h"
#include "Response/ResponseTool.h"
#include "Response/Pieces/SeamNormals.h"
#include "Response/Touch/SurfacePatch.h"
#include "Response/Touch/TipTimes.h"
#include "vtkContactTool.h"

#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <sstream>
#include <vector>

namespace
{
/// Adds what the global modes move. Whether all of it is finite.
bool addGlobalPart(const std::vector<vtkDataArray*>& modes, const palpate::ContactField& field,
  vtkFloatArray* displacement)
{
  std::atomic<bool> isFinite{ true };
  for (std::size_t k = 0; k < field.modeWeights().size(); ++k)
  {
    const double weight = field.modeWeights()[k];
    vtkSMPTools::For(0, displacement->GetNumberOfTuples(),
      [mode = modes[k], weight, displacement, &isFinite](vtkIdType begin, vtkIdType end)
      {
        bool isPartFinite = true;
        for (vtkIdType i = begin; i < end; ++i)
        {
          palpate::Vector3 phi;
          mode->GetTuple(i, phi.data());
          Eigen::Map<Eigen::Vector3f> u(displacement->GetPointer(3 * i));
          u += (weight * phi).cast<float>();
          isPartFinite = isPartFinite && u.allFinite();
        }
        if (!isPartFinite)
        {
          isFinite = false;
        }
      });
  }
  return isFinite;
}

/// The triangle of a contact as a body of its own, with what a field reads from it.
vtkSmartPointer<vtkPolyData> contactTriangle(
  vtkPolyData* body, vtkIdType triangle, const std::string& name)
{
  auto part = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkIdList> corners;
  body->GetPolys()->GetCellAtId(triangle, corners);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType k = 0; k < 3; ++k)
  {
    points->InsertNextPoint(body->GetPoint(corners->GetId(k)));
  }
  part->SetPoints(points);
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 2 });
  part->SetPolys(polys);
  std::vector<vtkDataArray*> read = palpate::globalModeArrays(body, name);
  if (vtkDataArray* layers = body->GetPointData()->GetArray((name + "LayerThickness").c_str()))
  {
    read.push_back(layers);
  }
  for (vtkDataArray* array : read)
  {
    auto here = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
    here->SetName(array->GetName());
    here->SetNumberOfComponents(array->GetNumberOfComponents());
    here->SetNumberOfTuples(3);
    array->GetTuples(corners, here);
    part->GetPointData()->AddArray(here);
  }
  for (const std::string& field :
    { name + "LayerBase", name + "Model", std::string("GlobalModeSign") })
  {
    if (vtkAbstractArray* array = body->GetFieldData()->GetAbstractArray(field.c_str()))
    {
      part->GetFieldData()->AddArray(array);
    }
  }
  return part;
}
} // namespace

vtkStandardNewMacro(vtkContactDeflection);

/// The linked mesh of the own piece, where it meets the others, and of which state it is.
class vtkContactDeflection::LinkedPiece
{
public:
  LinkedPiece(const palpate::Ranks& ranks, vtkPolyData* body)
    : Mesh(palpate::makeBodyMesh(body))
    , Seam(ranks, body)
    , SeamNormals(palpate::seamNormals(this->Mesh, this->Seam))
    , PointsTime(body->GetPoints()->GetMTime())
    , PolysTime(body->GetPolys()->GetMTime())
  {
  }
  // Modification times are unique, so the two name this pair.
  bool isOf(vtkPolyData* body) const
  {
    return this->PointsTime == body->GetPoints()->GetMTime() &&
      this->PolysTime == body->GetPolys()->GetMTime();
  }

  const palpate::BodyMesh Mesh;
  const palpate::BodySeam Seam;
  const std::vector<palpate::Vector3> SeamNormals;

private:
  vtkMTimeType PointsTime;
  vtkMTimeType PolysTime;
};

vtkContactDeflection::vtkContactDeflection()
  : Controller(vtkMultiProcessController::GetGlobalController())
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

void vtkContactDeflection::SetController(vtkMultiProcessController* controller)
{
  if (this->Controller != controller)
  {
    this->Controller = controller;
    this->Piece.reset();
    this->Modified();
  }
}

vtkMultiProcessController* vtkContactDeflection::GetController()
{
  return this->Controller;
}

vtkMTimeType vtkContactDeflection::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Tool ? std::max(own, this->Tool->GetMTime()) : own;
}

int vtkContactDeflection::FillInputPortInformation(int, vtkInformation* info)
{
  // Anything: RequestData says what to make of what it cannot take.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

void vtkContactDeflection::PrepareMesh(const palpate::Ranks& ranks, vtkPolyData* body)
{
  if (ranks.any(!this->Piece || !this->Piece->isOf(body)))
  {
    this->Piece = std::make_unique<const LinkedPiece>(ranks, body);
  }
}

std::string vtkContactDeflection::FindTool(vtkPolyData* body, vtkSmartPointer<vtkContactTool>& tool)
{
  std::string fault = palpate::checkTriangles(body);
  fault = fault.empty() ? palpate::checkFieldArrays(body, this->ResponseName) : fault;
  if (!fault.empty())
  {
    return "Wrong body: " + fault;
  }
  if (!palpate::isPoissonsRatio(this->PoissonRatio))
  {
    std::ostringstream text;
    text << "PoissonRatio must lie between 0 and 0.5, but is " << this->PoissonRatio;
    return text.str();
  }
  tool = palpate::findTool(this->Tool, body, this->ResponseName, fault);
  return fault.empty() && !tool->GetKernel() ? "The Tool is invalid" : fault;
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
  const palpate::ResponseModel model = palpate::responseModel(body, this->ResponseName);
  if (model.isInSeries() && field.modeWeights().empty() && model.text != this->WarnedOfModel)
  {
    vtkWarningMacro(<< "The response has a global compliance, but the body no GlobalMode0...; the "
                       "field shows the local part alone, at the whole deflection.");
    this->WarnedOfModel = model.text; // a live display asks for the field many times a second
  }
  return field;
}

int vtkContactDeflection::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  palpate::passTimes(inputVector, outputVector->GetInformationObject(0));
  return 1;
}

int vtkContactDeflection::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const palpate::Ranks ranks(this->Controller);
  std::string fault = palpate::checkType(inputVector[0]->GetInformationObject(0), "body");
  if (fault.empty())
  {
    fault = palpate::checkType(inputVector[1]->GetInformationObject(0), "tips");
  }
  const auto body = palpate::ownPiece(vtkPolyData::GetData(inputVector[0]), ranks);
  vtkPolyData* tips = vtkPolyData::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  palpate::passDataTime(body, tips, output);
  const bool hasPiece = body->GetNumberOfPoints() > 0;
  vtkSmartPointer<vtkContactTool> tool;
  if (fault.empty() && hasPiece)
  {
    fault = this->FindTool(body, tool);
  }
  fault = ranks.firstFault(fault);
  palpate::ChosenTip tip;
  if (fault.empty() && ranks.any(hasPiece))
  {
    fault = palpate::chooseTip(ranks, tips, this->TipIndex, tip);
  }
  const palpate::FieldContact& contact = tip.contact;
  const vtkIdType firstPoly = body->GetNumberOfVerts() + body->GetNumberOfLines();
  const bool isHere = contact.cell >= 0 && tip.rank == ranks.own();
  if (fault.empty())
  {
    const bool isTriangle =
      contact.cell >= firstPoly && contact.cell < firstPoly + body->GetNumberOfPolys();
    fault = ranks.firstFault(isHere && !isTriangle ? "ContactCell " + std::to_string(contact.cell) +
          " is not a triangle of the body: were the tips probed on another body?"
                                                   : std::string());
  }
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << (fault.back() == '?' ? "" : "."));
    return 0;
  }

  vtkNew<vtkFloatArray> displacement;
  displacement->SetName("ContactDisplacement");
  displacement->SetNumberOfComponents(3);
  displacement->SetNumberOfTuples(body->GetNumberOfPoints());
  displacement->Fill(0.0);
  if (contact.cell >= 0 && contact.deflection > 0.0)
  {
    const vtkIdType triangle = isHere ? contact.cell - firstPoly : -1;
    // Only one rank has the triangle; all need the field.
    vtkSmartPointer<vtkPolyData> under = body;
    palpate::FieldContact onIt = contact;
    if (!ranks.areAlone())
    {
      under = isHere ? contactTriangle(body, triangle, this->ResponseName)
                     : vtkSmartPointer<vtkPolyData>::New();
      ranks.spread(under, tip.rank);
      onIt.cell = 0;
    }
    palpate::ContactField field;
    bool isBent = true;
    if (hasPiece)
    {
      field = this->MakeField(under, *tool->GetKernel(), onIt);
      isBent =
        addGlobalPart(palpate::globalModeArrays(body, this->ResponseName), field, displacement);
    }
    fault = ranks.firstFault(isBent
        ? std::string()
        : "The global modes are too large: they displace the body to infinity");
    if (!fault.empty())
    {
      vtkErrorMacro(<< fault << ".");
      return 0;
    }
    this->PrepareMesh(ranks, body);
    this->Dent(field, contact, triangle, displacement);
  }
  if (hasPiece)
  {
    output->ShallowCopy(body);
    palpate::passDataTime(body, tips, output);
    output->GetPointData()->AddArray(displacement);
  }
  return 1;
}

void vtkContactDeflection::Dent(const palpate::ContactField& field,
  const palpate::FieldContact& contact, vtkIdType triangle, vtkFloatArray* displacement)
{
  const palpate::BodyMesh& mesh = this->Piece->Mesh;
  const palpate::BodySeam& seam = this->Piece->Seam;
  palpate::SurfacePatch patch(mesh, contact.point, contact.normal, this->MaximumDistance);
  for (std::size_t i = 0; i < seam.places().size(); ++i)
  {
    patch.setNormal(seam.places()[i].point, this->Piece->SeamNormals[i]);
  }
  if (triangle >= 0)
  {
    for (const std::int32_t corner : mesh.corners(static_cast<std::int32_t>(triangle)))
    {
      patch.enter(corner);
    }
  }
  const auto move = [&](std::int32_t id, double distance, const palpate::Vector3& away,
                      const palpate::Vector3& normal)
  {
    const palpate::SurfaceDisplacement u = field.local(distance);
    const double share = field.fade(distance, normal.dot(contact.normal));
    float* vector = displacement->GetPointer(3 * static_cast<vtkIdType>(id));
    Eigen::Map<Eigen::Vector3f>(vector) +=
      (share * (u.radial * away - u.normal * contact.normal)).cast<float>();
  };
  // Where the patch has come to a seam, it goes on from there on the other side.
  do
  {
    patch.visit(move);
    std::vector<char> reached;
    for (const palpate::BodySeam::Place& place : seam.places())
    {
      reached.push_back(patch.has(place.point) ? 1 : 0);
    }
    reached = seam.combined(reached, char{ 0 }, [](char a, char b) { return std::max(a, b); });
    for (std::size_t i = 0; i < reached.size(); ++i)
    {
      if (reached[i])
      {
        patch.enter(seam.places()[i].point);
      }
    }
  } while (seam.ranks().any(patch.isPending()));
}

void vtkContactDeflection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller.Get() << "\n";
  os << indent << "Tool: " << this->Tool.Get() << "\n";
  os << indent << "TipIndex: " << this->TipIndex << "\n";
  os << indent << "PoissonRatio: " << this->PoissonRatio << "\n";
  os << indent << "MaximumDistance: " << this->MaximumDistance << " mm\n";
  os << indent << "ResponseName: " << this->ResponseName << "\n";
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Response/BodyField.h"

#include "Response/Bodies/SoundBody.h"
#include "Response/BodyConversion.h"
#include "Response/FilterThreads.h"
#include "Response/Pieces/LoadedPieces.h"
#include "Response/Pieces/Ranks.h"
#include "Response/Pieces/SeamNormals.h"
#include "Response/Pieces/TriangleNumbers.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <functional>

namespace palpate
{
namespace
{
bool hasShape(vtkDataArray* array, int components, vtkIdType tuples)
{
  return array->GetNumberOfComponents() == components && array->GetNumberOfTuples() == tuples;
}

vtkIdType firstTriangle(vtkPolyData* body)
{
  return body->GetNumberOfVerts() + body->GetNumberOfLines();
}

/// Copies a triangle to all ranks from the rank that has it.
FieldTriangle spread(const Ranks& ranks, bool isHere, const FieldTriangle& own)
{
  if (ranks.areAlone())
  {
    return own;
  }
  std::vector<double> numbers;
  for (const auto& each : ranks.gather(isHere ? triangleNumbersOf(own) : std::vector<double>()))
  {
    numbers = each.empty() ? numbers : each;
  }
  return numbers.empty() ? own : triangleOf(numbers);
}

/// Returns views of the modes. Modes of other types are converted to arrays in `kept`.
std::vector<ModeSpan> viewModes(
  const std::vector<vtkDataArray*>& modes, std::vector<vtkSmartPointer<vtkDataArray>>& kept)
{
  std::vector<ModeSpan> spans;
  for (vtkDataArray* mode : modes)
  {
    if (auto* floats = vtkFloatArray::SafeDownCast(mode))
    {
      spans.emplace_back(floats->GetPointer(0));
      continue;
    }
    auto* doubles = vtkDoubleArray::SafeDownCast(mode);
    if (!doubles)
    {
      const auto copy = vtkSmartPointer<vtkDoubleArray>::New();
      copy->DeepCopy(mode);
      kept.push_back(copy);
      doubles = copy;
    }
    spans.emplace_back(doubles->GetPointer(0));
  }
  return spans;
}
} // namespace

std::vector<vtkDataArray*> globalModeArrays(vtkPolyData* body, const std::string& name)
{
  std::vector<vtkDataArray*> modes;
  vtkDataArray* signs = body->GetFieldData()->GetArray(GlobalModeSignArray);
  const ResponseModel model = responseModel(body, name);
  const bool bends =
    signs && signs->GetNumberOfComponents() == 1 && (model.isInSeries() || model.isTrueShape());
  const vtkIdType count = bends ? signs->GetNumberOfTuples() : 0;
  for (vtkIdType k = 0; k < count; ++k)
  {
    vtkDataArray* mode =
      body->GetPointData()->GetArray(globalModeName(static_cast<std::size_t>(k)).c_str());
    if (!mode || !hasShape(mode, 3, body->GetNumberOfPoints()))
    {
      break;
    }
    modes.push_back(mode);
  }
  return modes;
}

std::string checkBody(vtkPolyData* body, const std::string& name)
{
  const std::string fault = checkTriangles(body);
  if (!fault.empty())
  {
    return fault;
  }
  const vtkIdType points = body->GetNumberOfPoints();
  const auto describe = [points](vtkDataArray* array, int components)
  {
    return std::string("array '") + array->GetName() + "' must have " + std::to_string(components) +
      " components and " + std::to_string(points) + " tuples, but has " +
      std::to_string(array->GetNumberOfComponents()) + " and " +
      std::to_string(array->GetNumberOfTuples());
  };
  vtkDataArray* layers =
    body->GetPointData()->GetArray(arrayName(name, ResponseArray::LayerThickness).c_str());
  if (layers && !hasShape(layers, 1, points))
  {
    return describe(layers, 1);
  }
  vtkDataArray* near = body->GetPointData()->GetArray(NearFieldArray);
  if (near && !hasShape(near, NearField::Numbers, points))
  {
    return describe(near, NearField::Numbers);
  }
  for (vtkIdType k = 0;; ++k)
  {
    vtkDataArray* mode =
      body->GetPointData()->GetArray(globalModeName(static_cast<std::size_t>(k)).c_str());
    if (!mode || !hasShape(mode, 3, points))
    {
      return mode ? describe(mode, 3) : std::string();
    }
  }
}

void addDisplacements(vtkFloatArray* other, vtkFloatArray* sum)
{
  const vtkIdType count = std::min(other->GetNumberOfValues(), sum->GetNumberOfValues());
  std::transform(other->GetPointer(0), other->GetPointer(0) + count, sum->GetPointer(0),
    sum->GetPointer(0), std::plus<>());
}

bool isTriangle(vtkPolyData* body, vtkIdType cell)
{
  const vtkIdType first = firstTriangle(body);
  return cell >= first && cell < first + body->GetNumberOfPolys();
}

namespace
{
/// Reads the layer stack from the arrays of the body. If the arrays are missing or invalid, the
/// stack has no layers.
void readStack(
  vtkPolyData* body, const std::string& name, vtkIdList* corners, FieldTriangle& triangle)
{
  vtkDataArray* layers =
    body->GetFieldData()->GetArray(arrayName(name, ResponseArray::LayerStack).c_str());
  vtkDataArray* second =
    body->GetPointData()->GetArray(arrayName(name, ResponseArray::SecondThickness).c_str());
  if (!layers || layers->GetNumberOfComponents() != 4 || !(triangle.thickness[0] > 0.0))
  {
    return;
  }
  std::vector<double> numbers(static_cast<std::size_t>(layers->GetNumberOfValues()));
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    const auto index = static_cast<vtkIdType>(i);
    numbers[i] = layers->GetComponent(index / 4, static_cast<int>(index % 4));
  }
  LayerStack stack = stackOf(numbers, triangle.base);
  if (!stack.layers.empty())
  {
    stack.layers.front().thickness = triangle.thickness[0];
  }
  const bool hasSecond = second && hasShape(second, 1, body->GetNumberOfPoints());
  for (vtkIdType i = 0; hasSecond && i < 3; ++i)
  {
    triangle.second[static_cast<std::size_t>(i)] = second->GetTuple1(corners->GetId(i));
  }
  if (stack.layers.size() > 1 && triangle.second[0] > 0.0)
  {
    stack.layers[1].thickness = triangle.second[0];
  }
  if (checkStack(stack).empty())
  {
    triangle.stack = stack;
  }
}
} // namespace

FieldTriangle fieldTriangle(vtkPolyData* body, vtkIdType cell, const std::string& name)
{
  FieldTriangle triangle;
  vtkNew<vtkIdList> corners;
  body->GetPolys()->GetCellAtId(cell - firstTriangle(body), corners);
  vtkDataArray* layers =
    body->GetPointData()->GetArray(arrayName(name, ResponseArray::LayerThickness).c_str());
  const bool hasLayers = layers && hasShape(layers, 1, body->GetNumberOfPoints());
  vtkDataArray* near = body->GetPointData()->GetArray(NearFieldArray);
  const bool hasNear = near && hasShape(near, NearField::Numbers, body->GetNumberOfPoints()) &&
    responseModel(body, name).isTrueShape();
  const std::vector<vtkDataArray*> modes = globalModeArrays(body, name);
  vtkDataArray* signs = body->GetFieldData()->GetArray(GlobalModeSignArray);
  triangle.modes.resize(modes.size());
  for (std::size_t k = 0; k < modes.size(); ++k)
  {
    triangle.modes[k].sign = signs->GetTuple1(static_cast<vtkIdType>(k));
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    const vtkIdType corner = corners->GetId(static_cast<vtkIdType>(i));
    body->GetPoint(corner, triangle.corners[i].data());
    triangle.thickness[i] = hasLayers ? layers->GetTuple1(corner) : 0.0;
    if (hasNear)
    {
      std::array<double, NearField::Numbers> numbers{};
      near->GetTuple(corner, numbers.data());
      triangle.near[i] = nearFieldOf(numbers);
    }
    for (std::size_t k = 0; k < modes.size(); ++k)
    {
      modes[k]->GetTuple(corner, triangle.modes[k].vectors[i].data());
    }
  }
  vtkDataArray* base =
    body->GetFieldData()->GetArray(arrayName(name, ResponseArray::LayerBase).c_str());
  const bool slips = base && base->GetNumberOfValues() == 1 && base->GetTuple1(0) == 1.0;
  triangle.base = slips ? LayerBase::Slip : LayerBase::Bonded;
  readStack(body, name, corners, triangle);
  return triangle;
}

/// The mesh of this rank's piece with its neighbours, the seam of the piece, and the modification
/// times of the body from which they were made.
class BodyField::LinkedPiece
{
public:
  LinkedPiece(const Ranks& ranks, vtkPolyData* body)
    : Sound(body, extentOn(ranks))
    , Mesh(makeBodyMesh(this->Sound.body() ? this->Sound.body() : body))
    , Seam(ranks, body)
    , SeamNormals(seamNormals(this->Mesh, this->Seam))
    , PointsTime(body->GetPoints()->GetMTime())
    , PolysTime(body->GetPolys()->GetMTime())
  {
  }
  // Modification times are unique. Therefore these two times identify points and triangles.
  bool isOf(vtkPolyData* body) const
  {
    return this->PointsTime == body->GetPoints()->GetMTime() &&
      this->PolysTime == body->GetPolys()->GetMTime();
  }

  /// The repaired body. It is null if the input has a fault. The field then ends at the defects of
  /// the mesh.
  const SoundBody Sound;
  const BodyMesh Mesh;
  const BodySeam Seam;
  const std::vector<Vector3> SeamNormals;

private:
  vtkMTimeType PointsTime;
  vtkMTimeType PolysTime;
};

BodyField::BodyField() = default;
BodyField::~BodyField() = default;

std::string BodyField::displace(const Ranks& ranks, vtkPolyData* body, const FieldContact& contact,
  int rank, const Request& request, vtkFloatArray* displacement)
{
  this->Warnings.clear();
  displacement->SetName("ContactDisplacement");
  displacement->SetNumberOfComponents(3);
  displacement->SetNumberOfTuples(body->GetNumberOfPoints());
  displacement->Fill(0.0);
  if (contact.cell < 0 || !(contact.deflection > 0.0))
  {
    return {};
  }
  const std::string fault = missingPieces(ranks);
  if (!fault.empty())
  {
    return fault;
  }
  const bool isHere = rank == ranks.own();
  const std::string& name = request.responseName;
  // Only one rank has the triangle, but all ranks need the field.
  const FieldTriangle triangle =
    spread(ranks, isHere, isHere ? fieldTriangle(body, contact.cell, name) : FieldTriangle());
  ContactField field;
  if (body->GetNumberOfPoints() > 0)
  {
    field = ContactField(triangle, *request.tool, contact, request.settings, this->Kernel);
    if (!field.fault().empty())
    {
      this->Warnings.push_back(field.fault());
    }
    const ResponseModel model = responseModel(body, name);
    if (model.isInSeries() && field.modeWeights().empty() && model.text != this->ReportedModel)
    {
      this->Warnings.emplace_back("The response has a global compliance, but the body no "
                                  "GlobalMode0...; the field shows the local part alone, at the "
                                  "whole deflection");
      // The warning is issued once, because a live display computes the field often.
      this->ReportedModel = model.text;
    }
  }
  if (ranks.any(!this->Piece || !this->Piece->isOf(body)))
  {
    this->Piece = std::make_unique<const LinkedPiece>(ranks, body);
  }
  const BodyMesh& mesh = this->Piece->Mesh;
  const BodySeam& seam = this->Piece->Seam;
  const SoundBody& sound = this->Piece->Sound;
  SurfacePatch patch(mesh, contact.point, contact.normal, request.settings.reach);
  for (std::size_t i = 0; i < seam.places().size(); ++i)
  {
    patch.setNormal(seam.places()[i].point, this->Piece->SeamNormals[i]);
  }
  if (isHere)
  {
    vtkNew<vtkIdList> corners;
    body->GetPolys()->GetCellAtId(contact.cell - firstTriangle(body), corners);
    for (const vtkIdType corner : *corners)
    {
      patch.enter(static_cast<std::int32_t>(sound.firstAt(corner)));
    }
  }
  const auto cross = [&ranks, &seam](SurfacePatch& pending)
  {
    std::vector<char> reached;
    for (const BodySeam::Place& place : seam.places())
    {
      reached.push_back(pending.has(place.point) ? 1 : 0);
    }
    reached = seam.combined(reached, char{ 0 }, [](char a, char b) { return std::max(a, b); });
    for (std::size_t i = 0; i < reached.size(); ++i)
    {
      if (reached[i])
      {
        pending.enter(seam.places()[i].point);
      }
    }
    return ranks.any(pending.isPending());
  };
  std::vector<vtkSmartPointer<vtkDataArray>> kept;
  const auto modes = viewModes(globalModeArrays(body, name), kept);
  const FilterThreads threads;
  const bool isFinite = contactField(
    field, contact.normal, modes, patch, mesh.pointCount(), displacement->GetPointer(0), cross);
  for (vtkIdType i = 0; sound.joinedPoints() > 0 && i < displacement->GetNumberOfTuples(); ++i)
  {
    displacement->SetTuple(i, sound.firstAt(i), displacement);
  }
  return ranks.firstFault(isFinite
      ? std::string()
      : "The global modes are too large: they displace the body to infinity");
}
} // namespace palpate

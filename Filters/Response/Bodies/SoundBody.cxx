// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Bodies/SoundBody.h"

#include "Mechanics/RecentValues.h"
#include "Response/Bodies/BodyContent.h"
#include "Response/BodyConversion.h"
#include "Response/FilterThreads.h"
#include "Response/Pieces/Ranks.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>

namespace palpate
{
namespace
{
SoundMesh soundMesh(const BodyContent& surface, SoundBody::Extent extent)
{
  const FilterThreads threads;
  return SoundMesh(surface.points.data(), surface.points.size() / 3, surface.triangles.data(),
    surface.triangles.size() / 3, extent == SoundBody::Extent::Piece);
}

/// The defects of the last surfaces that needed no repair, by their content.
using SoundKey = std::pair<std::array<std::size_t, 2>, SoundBody::Extent>;

RecentValues<SoundKey, MeshDefects>& soundSurfaces()
{
  constexpr std::size_t most = 16;
  static RecentValues<SoundKey, MeshDefects> recent(most, most * sizeof(MeshDefects));
  return recent;
}

/// Returns a surface that has the triangles `triangles`, with their cell arrays. `firstOf` replaces
/// each corner by the first point at the same position.
template <class First>
vtkSmartPointer<vtkPolyData> withTriangles(
  vtkPolyData* surface, const std::vector<TriangleCorners>& triangles, const First& firstOf)
{
  const vtkIdType before = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  auto made = vtkSmartPointer<vtkPolyData>::New();
  made->GetCellData()->CopyAllocate(
    surface->GetCellData(), static_cast<vtkIdType>(triangles.size()));
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(
    static_cast<vtkIdType>(triangles.size()), 3 * static_cast<vtkIdType>(triangles.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const TriangleCorners& corners = triangles[t];
    if (corners[0] >= 0)
    {
      made->GetCellData()->CopyData(
        surface->GetCellData(), before + static_cast<vtkIdType>(t), cells->GetNumberOfCells());
      cells->InsertNextCell({ static_cast<vtkIdType>(firstOf(corners[0])),
        static_cast<vtkIdType>(firstOf(corners[1])), static_cast<vtkIdType>(firstOf(corners[2])) });
    }
  }
  made->SetPoints(surface->GetPoints());
  made->SetPolys(cells);
  made->GetPointData()->ShallowCopy(surface->GetPointData());
  made->SetFieldData(surface->GetFieldData());
  return made;
}

/// Returns whether triangles of the input are left out or reversed.
bool changesTriangles(const MeshDefects& found)
{
  return found.turnedTriangles + found.repeatedTriangles + found.hiddenTriangles + found.notFinite >
    0;
}
} // namespace

BodyContent::BodyContent(vtkPolyData* body)
  : BodyContent(copyPoints(body), copyTriangles(body))
{
}

SoundBody::SoundBody(vtkPolyData* input, Extent extent, std::shared_ptr<const BodyContent>* content)
  : Input(input)
{
  const auto give = [content](std::shared_ptr<const BodyContent> found)
  {
    if (content)
    {
      *content = std::move(found);
    }
  };
  give(nullptr);
  if (input->GetNumberOfPoints() == 0)
  {
    this->Body = input;
    give(std::make_shared<const BodyContent>(input));
    return;
  }
  this->Fault = checkTriangles(input);
  if (!this->Fault.empty())
  {
    return;
  }
  auto surface = std::make_shared<const BodyContent>(input);
  const SoundKey key{ surface->hash, extent };
  if (const std::shared_ptr<const MeshDefects> known = soundSurfaces().find(key))
  {
    this->Found = *known;
    this->Body = input;
    give(std::move(surface));
    return;
  }
  const SoundMesh mesh = soundMesh(*surface, extent);
  this->Fault = mesh.fault();
  this->Found = mesh.defects();
  if (!this->Fault.empty())
  {
    return;
  }
  if (!mesh.hasJoinedPoints() && !changesTriangles(this->Found))
  {
    this->Body = input;
    soundSurfaces().keep(
      key, std::make_shared<const MeshDefects>(this->Found), sizeof(MeshDefects));
    give(std::move(surface));
    return;
  }
  if (mesh.hasJoinedPoints())
  {
    const auto count = static_cast<std::int32_t>(input->GetNumberOfPoints());
    for (std::int32_t i = 0; i < count; ++i)
    {
      this->First.push_back(mesh.firstAt(i));
    }
  }
  this->Body = withTriangles(
    input, mesh.triangles(), [&mesh](std::int32_t point) { return mesh.firstAt(point); });
  if (content)
  {
    give(std::make_shared<const BodyContent>(this->Body));
  }
}

void SoundBody::giveBack(vtkPolyData* output) const
{
  if (this->Body == this->Input || output->GetNumberOfPoints() == 0)
  {
    return;
  }
  output->SetVerts(this->Input->GetVerts());
  output->SetLines(this->Input->GetLines());
  output->SetPolys(this->Input->GetPolys());
  output->GetCellData()->ShallowCopy(this->Input->GetCellData());
  vtkPointData* made = output->GetPointData();
  vtkPointData* given = this->Input->GetPointData();
  for (int k = 0; k < made->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* array = made->GetAbstractArray(k);
    const char* name = array->GetName();
    if (name && given->GetAbstractArray(name) == array)
    {
      continue;
    }
    for (std::size_t i = 0; i < this->First.size(); ++i)
    {
      const auto first = static_cast<vtkIdType>(this->First[i]);
      if (first != static_cast<vtkIdType>(i))
      {
        array->SetTuple(static_cast<vtkIdType>(i), first, array);
      }
    }
  }
}

SoundBody::Extent extentOn(const Ranks& ranks)
{
  return ranks.areAlone() ? SoundBody::Extent::Whole : SoundBody::Extent::Piece;
}

std::string orientSurface(
  vtkSmartPointer<vtkPolyData>& surface, SoundBody::Extent extent, MeshDefects& found)
{
  const SoundMesh mesh = soundMesh(BodyContent(surface), extent);
  found = mesh.defects();
  if (mesh.fault().empty() && changesTriangles(found))
  {
    surface = withTriangles(surface, mesh.triangles(), [](std::int32_t point) { return point; });
  }
  return mesh.fault();
}

std::string describeDefects(const MeshDefects& found)
{
  std::string text;
  const auto add = [&text](std::size_t count, const char* one, const char* many, const char* fate)
  {
    if (count > 0)
    {
      text += (text.empty() ? "" : "; ") + std::to_string(count) + ' ' + (count == 1 ? one : many) +
        ": " + fate;
    }
  };
  add(found.turnedTriangles, "triangle wound inward or against its neighbours",
    "triangles wound inward or against their neighbours", "turned over");
  add(found.repeatedTriangles, "triangle that occurs twice, or with its reverse",
    "triangles that occur twice, or with their reverse", "left out");
  add(found.hiddenTriangles, "triangle of a sheet inside the body",
    "triangles of sheets inside the body", "left out");
  add(found.degenerate, "triangle without area", "triangles without area", "left out");
  add(found.notFinite, "triangle with a coordinate that is not finite or beyond 1e14 mm",
    "triangles with a coordinate that is not finite or beyond 1e14 mm", "left out");
  add(found.nonManifoldEdges,
    "edge of more than two triangles or of two that cannot wind consistently",
    "edges of more than two triangles or of two that cannot wind consistently",
    "treated as open borders");
  return text;
}
} // namespace palpate

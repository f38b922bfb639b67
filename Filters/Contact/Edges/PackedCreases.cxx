// SPDX-License-Identifier: BSD-3-Clause
// The part of PackedMesh::Builder that cuts a mesh along its creases and marks the cuts.
#include "Contact/PackedMeshBuilder.h"

#include "Contact/Edges/CreaseCut.h"

#include <map>
#include <utility>

namespace palpate
{
void PackedMesh::Builder::findCreases()
{
  const CreaseCut creases(
    this->joined(), this->Usable, this->Coordinates, *this->Links, this->Creases.leastTurn);
  this->Mesh.Folded = creases.folded(this->Creases.areCut);
  if (this->Creases.areCut && !creases.sides().empty())
  {
    this->cut(creases);
  }
}

void PackedMesh::Builder::cut(const CreaseCut& creases)
{
  const std::size_t before = this->PointCount;
  std::map<std::pair<std::int32_t, int>, std::int32_t> numbers;
  const auto partOf = [&](std::int32_t point, int part)
  {
    const auto [found, isNew] =
      numbers.try_emplace({ point, part }, static_cast<std::int32_t>(this->PointCount));
    if (isNew)
    {
      const auto from = static_cast<std::size_t>(point);
      this->Mesh.InputPoints.push_back(this->Mesh.InputPoints[from]);
      for (std::size_t k = 0; k < 3; ++k)
      {
        this->Coordinates.push_back(this->Coordinates[3 * from + k]);
      }
      ++this->PointCount;
    }
    return found->second;
  };
  const bool hasTwins = !this->Joined.empty();
  this->Twins.resize(hasTwins ? before : 0);
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const int part = creases.part(t, k);
      if (part == 0)
      {
        continue;
      }
      std::int32_t& point = this->Triangles[t][k];
      if (hasTwins)
      {
        std::int32_t& first = this->Joined[t][k];
        first = partOf(first, part); // the index of `first` is lower than that of its twin
        point = partOf(point, part);
        this->Twins.resize(this->PointCount, -1);
        this->Twins[static_cast<std::size_t>(point)] = first;
      }
      else
      {
        point = partOf(point, part);
      }
    }
  }
  for (std::size_t i = before; i < this->Twins.size(); ++i)
  {
    this->Twins[i] = this->Twins[i] < 0 ? static_cast<std::int32_t>(i) : this->Twins[i];
  }
  this->Mesh.Creases = creases.sides();
  this->Links = std::make_unique<TriangleLinks>(this->joined(), this->PointCount);
}

/// Marks edges that have no neighbour because of a cut, and subtracts them from the number of
/// border edges.
void PackedMesh::Builder::markCreases()
{
  this->Mesh.Found.borderEdges -= this->Mesh.Creases.size();
  for (const CreaseSide& side : this->Mesh.Creases)
  {
    this->Mesh.Records[static_cast<std::size_t>(side.triangle)]
      .neighbours[static_cast<std::size_t>(side.edge)] = Crease;
  }
  for (const CreaseSide& side : this->Mesh.Creases)
  {
    for (const int k : { side.edge, (side.edge + 1) % 3 })
    {
      const std::int32_t point =
        this->joined()[static_cast<std::size_t>(side.triangle)][static_cast<std::size_t>(k)];
      bool isOnBorder = false;
      this->Mesh.visitAround(point,
        [&](std::int32_t around)
        {
          const auto t = static_cast<std::size_t>(around);
          const TriangleCorners& corners = this->joined()[t];
          for (std::size_t e = 0; e < 3; ++e)
          {
            const bool endsHere = corners[e] == point || corners[(e + 1) % 3] == point;
            isOnBorder = isOnBorder || (endsHere && this->Mesh.Records[t].neighbours[e] == Border);
          }
        });
      std::uint32_t& ring = this->Mesh.Vertices[static_cast<std::size_t>(point)].ring;
      ring = (ring & ~BorderFlag) | CreaseFlag | (isOnBorder ? BorderFlag : 0U);
    }
  }
  for (std::size_t point = 0; point < this->PointCount; ++point)
  {
    this->Mesh.Vertices[point].ring = this->Mesh.Vertices[this->twinOf(point)].ring;
  }
}

void PackedMesh::Builder::computeCornerNormals()
{
  // Sums of normals, with the index of the uncut point as the key.
  std::map<std::int32_t, Vector3> sums;
  const auto visitParts = [this](const auto& visit)
  {
    for (std::size_t point = 0; !this->Mesh.Creases.empty() && point < this->PointCount; ++point)
    {
      if (this->Mesh.isOnCrease(static_cast<std::int32_t>(point)))
      {
        visit(point, this->Mesh.InputPoints[this->twinOf(point)]);
      }
    }
  };
  visitParts(
    [&](std::size_t point, std::int32_t uncut)
    {
      if (this->twinOf(point) == point)
      {
        sums.try_emplace(uncut, Vector3::Zero()).first->second += this->sumOfNormals(point);
      }
    });
  visitParts(
    [&](std::size_t point, std::int32_t uncut) {
      this->Mesh.CornerNormals.push_back({ static_cast<std::int32_t>(point), sums[uncut] });
    });
}
} // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "PenetratingVertices.h"

#include <algorithm>
#include <cmath>

namespace palpate::testing
{
namespace
{
/// ∫ (δ - f(r))⁺ 2πr dr, mm³: the force of springs of 1 N/mm³ over the contact area.
double volumeWithin(const AxisymmetricTool& tool, double depth)
{
  constexpr double pi = 3.14159265358979323846;
  constexpr double step = 1e-3;
  double volume = 0.0;
  for (double r = 0.5 * step; depth > tool.profile(r); r += step)
  {
    volume += 2.0 * pi * r * step * (depth - tool.profile(r));
  }
  return volume;
}
} // namespace

PenetratingVertices::PenetratingVertices(const std::string& name, const StudyBody& body,
  const StudyLaw& known, std::shared_ptr<const AxisymmetricTool> tool)
  : TrackedMethod(name, body)
  , Tool(std::move(tool))
  , Vertices(body.pointCount())
  , SeenAt(body.pointCount(), 0)
{
  const double depth = 0.5 * known.tool().range;
  const double perArea =
    known.evaluate(body.spots().front(), depth).force / volumeWithin(*known.tool().shape, depth);
  const PackedMesh& mesh = body.packed();
  std::vector<double> area(body.pointCount(), 0.0);
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
  {
    const auto triangle = static_cast<std::int32_t>(t);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto vertex = static_cast<std::size_t>(mesh.corners(triangle)[k]);
      area[vertex] += mesh.areaNormal(triangle).norm() / 6.0;
      this->Vertices[vertex].position = mesh.corner(triangle, static_cast<int>(k)).cast<float>();
    }
  }
  for (std::size_t i = 0; i < area.size(); ++i)
  {
    this->Vertices[i].stiffness = static_cast<float>(perArea * area[i]);
  }
  this->Queue.reserve(body.pointCount());
}

void PenetratingVertices::visit(std::int32_t vertex)
{
  std::uint32_t& seen = this->SeenAt[static_cast<std::size_t>(vertex)];
  if (seen != this->Tick)
  {
    seen = this->Tick;
    this->Queue.push_back(vertex);
  }
}

double PenetratingVertices::magnitude(const TouchedPlace& place)
{
  ++this->Tick;
  this->Queue.clear();
  for (const std::int32_t corner : place.corners)
  {
    this->visit(corner);
  }
  const PackedMesh& mesh = this->Body.packed();
  const Vector3 foot = mesh.toLocal(place.point);
  const double edge = this->Body.meanEdge();
  double force = 0.0;
  for (std::size_t i = 0; i < this->Queue.size(); ++i)
  {
    const Vertex& vertex = this->Vertices[static_cast<std::size_t>(this->Queue[i])];
    const Vector3 away = vertex.position.cast<double>() - foot;
    const double above = away.dot(place.normal); // above the plane through the contact
    const double r = (away - above * place.normal).norm();
    force += static_cast<double>(vertex.stiffness) *
      std::max(0.0, this->penetration(r, place.depth + above));
    // The search continues from this vertex if a vertex one edge nearer could be inside the tool.
    if (this->penetration(std::max(0.0, r - 1.5 * edge), place.depth + above) > 0.0)
    {
      mesh.visitAround(this->Queue[i],
        [&](std::int32_t triangle)
        {
          for (const std::int32_t corner : mesh.corners(triangle))
          {
            this->visit(corner);
          }
        });
    }
  }
  return force;
}

std::size_t PenetratingVertices::modelBytes() const
{
  return this->Vertices.size() * (sizeof(Vertex) + sizeof this->SeenAt.front());
}
} // namespace palpate::testing

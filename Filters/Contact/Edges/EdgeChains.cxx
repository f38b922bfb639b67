// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/Edges/EdgeChains.h"

#include "Contact/Edges/EdgeLaw.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <tuple>
#include <utility>

namespace palpate
{
namespace
{
constexpr double CornerCosine = 0.8660254037844386; // cosine of 30°
constexpr std::size_t MostSteps = 32; // largest number of steps of a search along a chain
constexpr int MostAround = 64;        // largest number of triangles around a point

Vector3 centroid(const PackedMesh& mesh, std::int32_t triangle)
{
  return (mesh.corner(triangle, 0) + mesh.corner(triangle, 1) + mesh.corner(triangle, 2)) / 3.0;
}

/// Returns the crease side that follows a given side on the border of the same face; { -1, 0 } if
/// the next side is not a crease.
std::pair<std::int32_t, int> following(const PackedMesh& mesh, std::int32_t triangle, int edge)
{
  edge = (edge + 1) % 3;
  for (int step = 0; step < MostAround; ++step)
  {
    const std::int32_t across = mesh.neighbour(triangle, edge);
    if (across < 0)
    {
      return across == PackedMesh::Crease ? std::make_pair(triangle, edge)
                                          : std::make_pair(std::int32_t{ -1 }, 0);
    }
    int back = 0;
    while (back < 2 && mesh.neighbour(across, back) != triangle)
    {
      ++back;
    }
    triangle = across;
    edge = (back + 1) % 3;
  }
  return { -1, 0 };
}

/// Returns the index of the face of each triangle. A face is a set of connected triangles.
std::vector<std::int32_t> facesOf(const PackedMesh& mesh)
{
  std::vector<std::int32_t> faces(mesh.triangleCount(), EdgeChains::None);
  std::vector<std::int32_t> open;
  std::int32_t count = 0;
  for (std::size_t start = 0; start < faces.size(); ++start)
  {
    if (faces[start] != EdgeChains::None)
    {
      continue;
    }
    faces[start] = count;
    open.push_back(static_cast<std::int32_t>(start));
    while (!open.empty())
    {
      const std::int32_t triangle = open.back();
      open.pop_back();
      for (int edge = 0; edge < 3; ++edge)
      {
        const std::int32_t across = mesh.neighbour(triangle, edge);
        if (across >= 0 && faces[static_cast<std::size_t>(across)] == EdgeChains::None)
        {
          faces[static_cast<std::size_t>(across)] = count;
          open.push_back(across);
        }
      }
    }
    ++count;
  }
  return faces;
}
} // namespace

EdgeChains::EdgeChains(const PackedMesh& mesh, double poissonRatio, const Reach& reach)
  : Limits(reach)
  , Sides(mesh.creases())
{
  if (this->Sides.empty())
  {
    return;
  }
  this->makeSegments(mesh, poissonRatio);
  this->linkSegments(mesh);
  this->roundEnds();
  const std::vector<std::int32_t> faces = facesOf(mesh);
  for (std::size_t i = 0; i < this->Segments.size(); ++i)
  {
    this->Segments[i].face = faces[static_cast<std::size_t>(this->Sides[i].triangle)];
    this->Segments[i].other = faces[static_cast<std::size_t>(this->Sides[i].across)];
  }
  this->findNear(mesh);
  this->Sides = {};
}

std::int32_t EdgeChains::segmentAt(std::int32_t triangle, int edge) const
{
  const auto before = [](const PackedMesh::CreaseSide& side, const std::pair<int, int>& other)
  { return std::make_pair(side.triangle, side.edge) < other; };
  const auto found = std::lower_bound(
    this->Sides.begin(), this->Sides.end(), std::make_pair(triangle, edge), before);
  return found != this->Sides.end() && found->triangle == triangle && found->edge == edge
    ? static_cast<std::int32_t>(found - this->Sides.begin())
    : None;
}

void EdgeChains::makeSegments(const PackedMesh& mesh, double poissonRatio)
{
  for (const PackedMesh::CreaseSide& side : this->Sides)
  {
    Segment segment;
    segment.start = mesh.corner(side.triangle, side.edge);
    const Vector3 way = mesh.corner(side.triangle, (side.edge + 1) % 3) - segment.start;
    segment.length = way.norm();
    segment.along = way / segment.length;
    segment.normal = mesh.faceNormal(side.triangle);
    segment.outward = segment.along.cross(segment.normal);
    segment.across = side.across;
    const double turn{ side.turn };
    segment.isBlunt = turn < PackedMesh::BluntTurn;
    segment.sharpness.fill(edgeSharpness(poissonRatio, turn));
    segment.otherNormal.fill(mesh.faceNormal(side.across));
    this->Segments.push_back(segment);
  }
}

void EdgeChains::linkSegments(const PackedMesh& mesh)
{
  for (std::size_t i = 0; i < this->Segments.size(); ++i)
  {
    const auto [triangle, edge] = following(mesh, this->Sides[i].triangle, this->Sides[i].edge);
    const std::int32_t next = triangle < 0 ? None : this->segmentAt(triangle, edge);
    if (next < 0 || next == static_cast<std::int32_t>(i))
    {
      continue;
    }
    Segment& one = this->Segments[i];
    Segment& other = this->Segments[static_cast<std::size_t>(next)];
    const bool turnsLeft = one.outward.dot(other.along) < 0.0;
    if (turnsLeft && one.along.dot(other.along) < CornerCosine)
    {
      one.goesOnBehind = true;
      other.goesOnBefore = true;
    }
    else if (one.isBlunt == other.isBlunt)
    {
      one.next = next;
      one.turnsLeft = turnsLeft;
      other.previous = static_cast<std::int32_t>(i);
    }
  }
  std::int32_t chains = 0;
  for (std::size_t i = 0; i < this->Segments.size(); ++i)
  {
    if (this->Segments[i].chain != None)
    {
      continue;
    }
    for (const auto step : { &Segment::next, &Segment::previous })
    {
      auto at = static_cast<std::int32_t>(i);
      while (at != None &&
        (at == static_cast<std::int32_t>(i) ||
          this->Segments[static_cast<std::size_t>(at)].chain == None))
      {
        Segment& segment = this->Segments[static_cast<std::size_t>(at)];
        segment.chain = chains;
        at = segment.*step;
        if (at == static_cast<std::int32_t>(i))
        {
          break; // the chain is a closed loop
        }
      }
    }
    ++chains;
  }
}

/// Averages the values of consecutive segments of a chain where the segments meet.
void EdgeChains::roundEnds()
{
  const std::vector<Segment> before = this->Segments;
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    if (before[i].next == None)
    {
      continue;
    }
    const auto next = static_cast<std::size_t>(before[i].next);
    const double sharpness = 0.5 * (before[i].sharpness[1] + before[next].sharpness[0]);
    const Vector3 sum = before[i].otherNormal[1] + before[next].otherNormal[0];
    const Vector3 normal = sum.norm() > 0.0 ? sum.normalized() : before[i].otherNormal[1];
    this->Segments[i].sharpness[1] = this->Segments[next].sharpness[0] = sharpness;
    this->Segments[i].otherNormal[1] = this->Segments[next].otherNormal[0] = normal;
  }
}

/// Visits the triangles from the creases outwards. Each triangle stores the nearest chains that are
/// within their reach of the triangle.
void EdgeChains::findNear(const PackedMesh& mesh)
{
  struct Candidate
  {
    double distance;
    std::int32_t triangle;
    std::int32_t segment;
    bool operator>(const Candidate& other) const
    {
      return std::tie(this->distance, this->triangle, this->segment) >
        std::tie(other.distance, other.triangle, other.segment);
    }
  };
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> open;
  this->NearPlaces.assign(mesh.triangleCount(), None);
  const auto hasRoomFor = [this](std::int32_t triangle, std::int32_t chain)
  {
    const Near* near = this->near(triangle);
    return !near ||
      (near->back() == None &&
        std::none_of(near->begin(), near->end(),
          [&](std::int32_t s) { return s != None && this->segment(s).chain == chain; }));
  };
  const auto addCandidate = [&](std::int32_t triangle, std::int32_t segment)
  {
    if (!hasRoomFor(triangle, this->segment(segment).chain))
    {
      return;
    }
    const Vector3 middle = centroid(mesh, triangle);
    const Place place = this->closest(middle, segment, this->Segments.size());
    const double distance = std::abs(place.distance);
    double size = 0.0; // a large triangle extends closer to the edge than its centroid
    for (int k = 0; k < 3; ++k)
    {
      size = std::max(size, (mesh.corner(triangle, k) - middle).norm());
    }
    if (distance - size <=
      (this->segment(segment).isBlunt ? this->Limits.blunt : this->Limits.sharp))
    {
      open.push({ distance, triangle, place.segment });
    }
  };
  for (std::size_t i = 0; i < this->Segments.size(); ++i)
  {
    const std::int32_t triangle = this->Sides[i].triangle;
    const Vector3 from = centroid(mesh, triangle);
    open.push({ std::abs(this->closest(from, static_cast<std::int32_t>(i), 1).distance), triangle,
      static_cast<std::int32_t>(i) });
  }
  while (!open.empty())
  {
    const Candidate candidate = open.top();
    open.pop();
    if (!hasRoomFor(candidate.triangle, this->segment(candidate.segment).chain))
    {
      continue;
    }
    std::int32_t& place = this->NearPlaces[static_cast<std::size_t>(candidate.triangle)];
    if (place == None)
    {
      place = static_cast<std::int32_t>(this->NearLists.size());
      this->NearLists.emplace_back().fill(None);
    }
    Near& near = this->NearLists[static_cast<std::size_t>(place)];
    *std::find(near.begin(), near.end(), None) = candidate.segment;
    for (int edge = 0; edge < 3; ++edge)
    {
      const std::int32_t across = mesh.neighbour(candidate.triangle, edge);
      if (across >= 0)
      {
        addCandidate(across, candidate.segment);
      }
    }
  }
}

EdgeChains::Place EdgeChains::closest(const Vector3& place, std::int32_t segment) const noexcept
{
  return this->closest(place, segment, MostSteps);
}

EdgeChains::Place EdgeChains::closest(
  const Vector3& place, std::int32_t segment, std::size_t mostSteps) const noexcept
{
  const auto along = [&place](const Segment& at) { return at.along.dot(place - at.start); };
  const auto onwardFrom = [](const Segment& at, double way) {
    return way < 0.0 ? at.previous : way > at.length ? at.next : None;
  };
  std::int32_t from = None;
  std::int32_t onward = onwardFrom(this->segment(segment), along(this->segment(segment)));
  for (std::size_t step = 0; step < mostSteps && onward != None && onward != from; ++step)
  {
    from = segment;
    segment = onward;
    onward = onwardFrom(this->segment(segment), along(this->segment(segment)));
  }
  const Segment& at = this->segment(segment);
  const double way = along(at);
  const bool isBefore = way < 0.0;
  const bool isBeyond = isBefore || way > at.length;
  const bool goesOn = isBefore ? at.goesOnBefore : at.goesOnBehind;
  const double clamped = std::clamp(way, 0.0, at.length);
  Place found;
  found.segment = segment;
  found.part = clamped / at.length;
  found.point = at.start + (isBeyond && goesOn ? way : clamped) * at.along;
  Vector3 offset = place - found.point;
  // A curved face deviates from the plane of the segment.
  offset -= at.normal.dot(offset) * at.normal;
  bool isInside = offset.dot(at.outward) <= 0.0;
  if (isBeyond && !goesOn)
  {
    // The closest point is between two segments, or at the end of the crease.
    isInside = onward == None || !(isBefore ? this->segment(onward) : at).turnsLeft;
  }
  const double length = offset.norm();
  found.distance = isInside ? length : -length;
  found.gradient = length > 0.0 ? Vector3(1.0 / found.distance * offset) : Vector3(-at.outward);
  return found;
}

std::size_t EdgeChains::memory() const noexcept
{
  return this->Segments.size() * sizeof(Segment) + this->NearPlaces.size() * sizeof(std::int32_t) +
    this->NearLists.size() * sizeof(Near);
}
} // namespace palpate

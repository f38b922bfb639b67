// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Curves/BodyShape.h"

#include "Laws/FaceSurface.h"
#include "Mechanics/RecentValues.h"
#include "Response/Bodies/BodyContent.h"
#include "Response/Pieces/BodySeam.h"
#include "Response/Pieces/Ranks.h"

#include "vtkMath.h"
#include "vtkPolyData.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <future>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
/// All pieces as one surface, joined at their seams. `own` contains, for each point of this rank's
/// piece, its index in this surface.
struct WholeSurface
{
  std::shared_ptr<const BodyContent> content;
  std::vector<float> normals;
  std::vector<std::int32_t> own;

  std::size_t pointCount() const { return this->content->points.size() / 3; }
  TriangleSpans spans() const
  {
    const BodyContent& surface = *this->content;
    return { surface.points.data(), this->pointCount(), surface.triangles.data(),
      surface.triangles.size() / 3 };
  }
};

WholeSurface gatherSurface(const BodySeam& seam, const WholeSurface& piece)
{
  std::vector<std::int32_t> seamOf(piece.pointCount(), -1);
  for (const BodySeam::Place& place : seam.places())
  {
    seamOf[static_cast<std::size_t>(place.point)] = place.seam;
  }
  const Ranks& ranks = seam.ranks();
  const auto allPoints = ranks.gather(piece.content->points);
  const auto allNormals = ranks.gather(piece.normals);
  const auto allTriangles = ranks.gather(piece.content->triangles);
  const auto allSeams = ranks.gather(seamOf);
  WholeSurface whole;
  std::vector<double> points;
  std::vector<std::int32_t> triangles;
  std::map<std::int32_t, std::int32_t> joined;
  for (std::size_t rank = 0; rank < allPoints.size(); ++rank)
  {
    std::vector<std::int32_t> place;
    for (std::size_t i = 0; i < allSeams[rank].size(); ++i)
    {
      const auto next = static_cast<std::int32_t>(points.size() / 3);
      const std::int32_t number = allSeams[rank][i];
      place.push_back(number < 0 ? next : joined.try_emplace(number, next).first->second);
      if (place.back() == next)
      {
        const double* from = allPoints[rank].data() + 3 * i;
        points.insert(points.end(), from, from + 3);
        const float* normal = allNormals[rank].data() + 3 * i;
        whole.normals.insert(whole.normals.end(), normal, normal + 3);
      }
    }
    for (const std::int32_t corner : allTriangles[rank])
    {
      triangles.push_back(place[static_cast<std::size_t>(corner)]);
    }
    if (static_cast<int>(rank) == ranks.own())
    {
      whole.own = std::move(place);
    }
  }
  whole.content = std::make_shared<const BodyContent>(std::move(points), std::move(triangles));
  return whole;
}

/// Key of the cache of shapes. It describes the input from which a shape is computed.
struct ShapeKey
{
  std::array<std::size_t, 3> surface; ///< hashes that identify this rank's piece
  double radius;
  bool hasEdges;
  bool isOfFaces; ///< whether the curvature is computed from the faces, without sharp edges

  bool operator==(const ShapeKey& other) const
  {
    return this->surface == other.surface && this->radius == other.radius &&
      this->hasEdges == other.hasEdges && this->isOfFaces == other.isOfFaces;
  }
};

/// A surface, and the data of the surface that do not depend on the contact radius. The data are
/// computed when they are first used.
class SharedSurface
{
public:
  explicit SharedSurface(WholeSurface&& whole)
    : Whole(std::move(whole))
  {
  }

  const WholeSurface& whole() const { return this->Whole; }
  const SurfaceForms& forms() const
  {
    std::call_once(this->FormsMade,
      [this] {
        this->Forms =
          std::make_unique<SurfaceForms>(this->Whole.spans(), this->Whole.normals.data());
      });
    return *this->Forms;
  }
  const FaceForms& faces() const
  {
    std::call_once(this->FacesMade,
      [this] {
        this->Faces = std::make_unique<FaceForms>(this->Whole.spans(), this->Whole.normals.data());
      });
    return *this->Faces;
  }
  const EdgeSurface& edges() const
  {
    std::call_once(this->EdgesMade,
      [this] { this->Edges = std::make_unique<EdgeSurface>(this->Whole.spans()); });
    return *this->Edges;
  }

  /// Returns an upper limit of the memory in bytes, if all data are computed.
  std::size_t bytes() const
  {
    // This includes the copies of points and normals for the curvature of the faces.
    constexpr std::size_t perPoint = 310;
    constexpr std::size_t perTriangle = 145;
    const TriangleSpans spans = this->Whole.spans();
    return perPoint * spans.pointCount + perTriangle * spans.triangleCount;
  }

private:
  WholeSurface Whole;
  mutable std::once_flag FormsMade;
  mutable std::once_flag FacesMade;
  mutable std::once_flag EdgesMade;
  mutable std::unique_ptr<SurfaceForms> Forms;
  mutable std::unique_ptr<FaceForms> Faces;
  mutable std::unique_ptr<EdgeSurface> Edges;
};

constexpr std::size_t MostShapes = 16;
constexpr std::size_t MostBytesOfShapes = std::size_t{ 128 } << 20;
constexpr std::size_t MostSurfaces = 2;
constexpr std::size_t MostBytesOfSurfaces = std::size_t{ 512 } << 20;
} // namespace

std::shared_ptr<const BodyShape> findShape(const std::shared_ptr<const BodyContent>& piece,
  const BodySeam& seam, const float* normals, double a, const LawTerms& terms)
{
  const bool wantsEdges = terms.errorTolerance > 0.0;
  if (!terms.curvature && !wantsEdges)
  {
    return std::make_shared<const BodyShape>();
  }
  const Ranks& ranks = seam.ranks();
  const std::size_t count = piece->points.size();
  const ShapeKey key{ { piece->hash[0], piece->hash[1], hashOf(normals, count) }, a, wantsEdges,
    terms.edges };
  static RecentValues<ShapeKey, BodyShape> recent(MostShapes, MostBytesOfShapes);
  std::shared_ptr<const BodyShape> known = recent.find(key);
  if (!ranks.any(known == nullptr))
  {
    return known;
  }
  const auto share = [&]
  {
    WholeSurface own{ piece, { normals, normals + count }, {} };
    auto surface = std::make_shared<const SharedSurface>(
      ranks.areAlone() ? std::move(own) : gatherSurface(seam, own));
    const std::size_t bytes = surface->bytes();
    return std::make_pair(std::shared_ptr<const SharedSurface>(std::move(surface)), bytes);
  };
  static RecentValues<std::array<std::size_t, 3>, SharedSurface> surfaces(
    MostSurfaces, MostBytesOfSurfaces);
  const std::shared_ptr<const SharedSurface> shared =
    ranks.areAlone() ? surfaces.get(key.surface, share) : share().first;
  auto made = std::make_shared<BodyShape>();
  made->inWhole = shared->whole().own;
  auto curvature = std::async(std::launch::async,
    [&]
    {
      return std::make_unique<SurfaceCurvature>(
        terms.edges ? shared->faces().curvature(a) : SurfaceCurvature(shared->forms(), a));
    });
  if (wantsEdges)
  {
    // Largest distance of an edge, in contact radii. An edge at this distance reduces the force by
    // 2 %.
    constexpr double reach = 40.0;
    made->edges = std::make_unique<EdgeDistance>(shared->edges(), a, reach * a);
  }
  made->curvature = curvature.get();
  recent.keep(key, made, 28 * shared->whole().pointCount());
  return made;
}

BodyLengths lengthsOf(vtkPolyData* body, const Ranks& ranks)
{
  std::array<double, 6> bounds{};
  body->GetCellsBounds(bounds.data());
  const bool hasBounds = vtkMath::AreBoundsInitialized(bounds.data()) != 0;
  constexpr double none = std::numeric_limits<double>::infinity();
  std::array<double, 3> length{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    length[axis] = ranks.largest(hasBounds ? bounds[2 * axis + 1] : -none) -
      ranks.smallest(hasBounds ? bounds[2 * axis] : none);
  }
  std::sort(length.begin(), length.end());
  return { length[0], length[1] };
}
} // namespace palpate

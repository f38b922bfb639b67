// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactBody_h
#define palpate_ContactBody_h

#include "Contact/Coupled/BodyCoupling.h"
#include "Contact/Edges/BodyEdges.h"
#include "Contact/PackedMesh.h"
#include "Contact/Relaxation/BodyRelaxation.h"
#include "Contact/ResponseField.h"
#include "Contact/Tilt/BodyTilt.h"
#include "Contact/TriangleTree.h"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace palpate
{
/// All data of a body that a tick needs: the surface, the search tree for the surface, and the
/// response at the points. Immutable; any number of ToolContacts can share it. It keeps no
/// reference to its input data.
struct ContactBody
{
  /// `points` has x, y, z of each point, `triangles` three point indices per triangle. `responses`
  /// has one response per point, in the order of the points.
  ContactBody(const double* points, std::size_t pointCount, const std::int32_t* triangles,
    std::size_t triangleCount, const ResponseArrays& responses, const BuildProgress& progress = {})
    : Shared(std::make_shared<const Shape>(
        points, pointCount, triangles, triangleCount, progress, creasesOf(responses)))
    , surface(Shared->surface)
    , tree(Shared->tree)
    , response(responses, &surface)
    , edges(edgesOf(surface, responses))
    , relaxation(relaxationOf(surface, response, responses))
    , coupling(couplingOf(surface, response, responses))
    , tilt(tiltOf(surface, responses))
  {
    if (progress)
    {
      progress(1.0);
    }
  }
  /// Creates a body that shares the surface of `same` and has other responses. Sharp edges must
  /// have an effect in both bodies or in neither.
  ContactBody(const ContactBody& same, const ResponseArrays& responses)
    : Shared(same.Shared)
    , surface(Shared->surface)
    , tree(Shared->tree)
    , response(responses, &surface)
    , edges(edgesOf(surface, responses))
    , relaxation(relaxationOf(surface, response, responses))
    , coupling(couplingOf(surface, response, responses))
    , tilt(tiltOf(surface, responses))
  {
  }
  ContactBody(const ContactBody&) = delete;
  ContactBody& operator=(const ContactBody&) = delete;

private:
  /// Surface and search tree. Bodies with different responses can share them.
  struct Shape
  {
    Shape(const double* points, std::size_t pointCount, const std::int32_t* triangles,
      std::size_t triangleCount, const BuildProgress& progress,
      const PackedMesh::CreaseRule& creases)
      : surface(points, pointCount, triangles, triangleCount, progress, creases)
      , tree(surface)
    {
    }

    const PackedMesh surface;
    const TriangleTree tree;
  };
  const std::shared_ptr<const Shape> Shared;

public:
  const PackedMesh& surface;
  const TriangleTree& tree;
  const ResponseField response;
  const std::unique_ptr<const BodyEdges> edges;           ///< null if edges have no effect
  const std::unique_ptr<const BodyRelaxation> relaxation; ///< null if the body does not relax
  const std::unique_ptr<const BodyCoupling> coupling;     ///< null if contacts are not coupled
  const std::unique_ptr<const BodyTilt> tilt; ///< null if the tilt of the tool has no effect

  /// Prefetches the responses at the corners of a triangle.
  void prefetchResponses(std::int32_t triangle) const noexcept
  {
    for (const std::int32_t corner : this->surface.corners(triangle))
    {
      this->response.prefetch(corner);
    }
  }
  /// Prefetches all data that a tick reads for a triangle and its neighbours.
  void prefetchAround(std::int32_t triangle) const noexcept
  {
    this->prefetch(triangle);
    for (int edge = 0; edge < 3; ++edge)
    {
      const std::int32_t across = this->surface.neighbour(triangle, edge);
      if (across >= 0)
      {
        this->prefetch(across);
      }
    }
    // If the triangle is not certainly the nearest one, the tick checks the triangles around its
    // corners.
    for (const std::int32_t corner : this->surface.corners(triangle))
    {
      this->surface.visitAround(
        corner, [this](std::int32_t near) { this->surface.prefetch(near); });
    }
  }

private:
  void prefetch(std::int32_t triangle) const noexcept
  {
    this->surface.prefetchInput(triangle);
    if (this->edges)
    {
      this->edges->prefetch(triangle);
    }
    this->prefetchResponses(triangle);
  }
  static PackedMesh::CreaseRule creasesOf(const ResponseArrays& responses)
  {
    return { BodyEdges::LeastTurn, responses.edges.areFelt() };
  }
  static std::unique_ptr<const BodyEdges> edgesOf(
    const PackedMesh& surface, const ResponseArrays& responses)
  {
    return responses.edges.areFelt()
      ? std::make_unique<const BodyEdges>(surface, responses.edges, responses.longestRange())
      : nullptr;
  }
  static std::unique_ptr<const BodyRelaxation> relaxationOf(
    const PackedMesh& surface, const ResponseField& response, const ResponseArrays& responses)
  {
    return responses.relaxation.areFelt()
      ? std::make_unique<const BodyRelaxation>(surface, response, responses)
      : nullptr;
  }
  static std::unique_ptr<const BodyCoupling> couplingOf(
    const PackedMesh& surface, const ResponseField& response, const ResponseArrays& responses)
  {
    return responses.coupling.areFelt()
      ? std::make_unique<const BodyCoupling>(surface, response, responses.coupling)
      : nullptr;
  }
  static std::unique_ptr<const BodyTilt> tiltOf(
    const PackedMesh& surface, const ResponseArrays& responses)
  {
    return responses.tilt.areFelt() ? std::make_unique<const BodyTilt>(surface, responses.tilt)
                                    : nullptr;
  }
};
} // namespace palpate

#endif

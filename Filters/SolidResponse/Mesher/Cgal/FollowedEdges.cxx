// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Mesher/Cgal/FollowedEdges.h"

#include "SolidResponse/Mesher/Cgal/SeparateLines.h"

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/split_graph_into_polylines.h>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace palpate
{
namespace
{
/// Smallest length of a line that counts as an edge of the body, in spacings.
constexpr double OwnEdge = 3.0;
/// Points of lines within this distance of each other become one node, in spacings.
constexpr double SameNode = 1e-6;

using Edges = std::vector<CgalSurface::Edge_index>;

/// Returns the edges whose dihedral angle exceeds `angle` (degrees), except the edges in `besides`.
Edges sharpEdges(const CgalSurface& surface, double angle, const Edges& besides)
{
  const double least = std::cos(angle * CGAL_PI / 180.0);
  const auto normalOf = [&surface](CgalSurface::Halfedge_index h)
  {
    return CGAL::unit_normal(surface.point(surface.source(h)), surface.point(surface.target(h)),
      surface.point(surface.target(surface.next(h))));
  };
  Edges found;
  for (const CgalSurface::Edge_index edge : surface.edges())
  {
    const CgalSurface::Halfedge_index h = surface.halfedge(edge);
    if (!std::binary_search(besides.begin(), besides.end(), edge) &&
      normalOf(h) * normalOf(surface.opposite(h)) < least)
    {
      found.push_back(edge);
    }
  }
  return found;
}

/// Returns whether the sharp edges of a surface are edges of the body. Edges of a body form lines
/// that are several spacings long, whereas the noise of a scan gives many short lines.
bool areOwnEdges(const CgalSurface& surface, const Edges& sharp, const MeshedSurface& wanted)
{
  std::vector<CgalSurface::Vertex_index> root(surface.vertices().begin(), surface.vertices().end());
  const auto rootOf = [&root](CgalSurface::Vertex_index v)
  {
    while (root[v.idx()] != v)
    {
      v = root[v.idx()] = root[root[v.idx()].idx()];
    }
    return v;
  };
  for (const CgalSurface::Edge_index edge : sharp)
  {
    root[rootOf(surface.vertex(edge, 0)).idx()] = rootOf(surface.vertex(edge, 1));
  }
  std::map<CgalSurface::Vertex_index, double> lengths;
  for (const CgalSurface::Edge_index edge : sharp)
  {
    lengths[rootOf(surface.vertex(edge, 0))] += std::sqrt(CGAL::squared_distance(
      surface.point(surface.vertex(edge, 0)), surface.point(surface.vertex(edge, 1))));
  }
  const double enough = OwnEdge * wanted.spacing.front();
  const auto own = std::count_if(
    lengths.begin(), lengths.end(), [enough](const auto& line) { return line.second >= enough; });
  return 2 * static_cast<std::size_t>(own) > lengths.size();
}

/// Returns the edges on the rims, in ascending order.
Edges rimsOf(const CgalSurface& surface, const MeshedSurface& wanted)
{
  Edges found;
  for (const auto& [from, to] : wanted.rims)
  {
    const CgalSurface::Halfedge_index h =
      surface.halfedge(CgalSurface::Vertex_index(static_cast<CgalSurface::size_type>(from)),
        CgalSurface::Vertex_index(static_cast<CgalSurface::size_type>(to)));
    found.push_back(surface.edge(h));
  }
  std::sort(found.begin(), found.end());
  return found;
}

using LineGraph = boost::adjacency_list<boost::setS, boost::vecS, boost::undirectedS, CgalPoint>;

/// Collects lines. Each line either goes from corner to corner or is closed.
class LineVisitor
{
public:
  explicit LineVisitor(const LineGraph& graph)
    : Graph(graph)
  {
  }
  void start_new_polyline() { this->Lines.emplace_back(); }
  void add_node(LineGraph::vertex_descriptor v)
  {
    const CgalPoint& at = this->Graph[v];
    this->Lines.back().emplace_back(at.x(), at.y(), at.z());
  }
  void end_polyline() {}

  std::vector<Line> Lines;

private:
  const LineGraph& Graph;
};

/// Returns whether a line bends by more than 90° at a point.
struct IsCorner
{
  bool operator()(LineGraph::vertex_descriptor v, const LineGraph& graph) const
  {
    std::vector<CgalPoint> ends;
    for (const auto& next : CGAL::make_range(boost::adjacent_vertices(v, graph)))
    {
      ends.push_back(graph[next]);
    }
    return ends.size() == 2 && CGAL::angle(ends[0], graph[v], ends[1]) == CGAL::ACUTE;
  }
};

/// The nodes of lines. Points that differ only by rounding become one node. At the intersection of
/// two cuts, a surface may have several such points, and a line between them would have no length.
class LineNodes
{
public:
  LineNodes(LineGraph& graph, double tolerance)
    : Graph(graph)
    , Tolerance(tolerance)
  {
  }

  LineGraph::vertex_descriptor at(const CgalPoint& point)
  {
    const Cell cell = { std::llround(point.x() / this->Tolerance),
      std::llround(point.y() / this->Tolerance), std::llround(point.z() / this->Tolerance) };
    for (const long long x : { -1, 0, 1 })
    {
      for (const long long y : { -1, 0, 1 })
      {
        for (const long long z : { -1, 0, 1 })
        {
          const auto known = this->Known.find({ cell[0] + x, cell[1] + y, cell[2] + z });
          if (known != this->Known.end())
          {
            return known->second;
          }
        }
      }
    }
    return this->Known[cell] = boost::add_vertex(point, this->Graph);
  }

private:
  using Cell = std::array<long long, 3>;

  LineGraph& Graph;
  double Tolerance; ///< largest distance of points that are one node, mm
  std::map<Cell, LineGraph::vertex_descriptor> Known;
};

std::vector<Line> linesOf(const CgalSurface& surface, const Edges& edges, double spacing)
{
  LineGraph graph;
  LineNodes nodes(graph, SameNode * spacing);
  for (const CgalSurface::Edge_index edge : edges)
  {
    const LineGraph::vertex_descriptor from = nodes.at(surface.point(surface.vertex(edge, 0)));
    const LineGraph::vertex_descriptor to = nodes.at(surface.point(surface.vertex(edge, 1)));
    if (from != to)
    {
      boost::add_edge(from, to, graph);
    }
  }
  LineVisitor visitor(graph);
  CGAL::split_graph_into_polylines(graph, visitor, IsCorner());
  return visitor.Lines;
}
} // namespace

FollowedEdges followedEdges(const CgalSurface& surface, const MeshedSurface& wanted)
{
  FollowedEdges made;
  Edges followed = rimsOf(surface, wanted);
  const Edges sharp = sharpEdges(surface, wanted.sharpAngle, followed);
  const bool areOwn = areOwnEdges(surface, sharp, wanted);
  made.areDetected = areOwn && followed.empty();
  if (areOwn && !followed.empty())
  {
    followed.insert(followed.end(), sharp.begin(), sharp.end());
  }
  std::vector<Line> lines = linesOf(surface, followed, wanted.spacing.front());
  if (!areOwn)
  {
    // The rims of a scan are as rough as the surface of the scan.
    lines = separateLines(lines, wanted.spacing.front());
  }
  for (const Line& line : lines)
  {
    made.lines.emplace_back();
    for (const Eigen::Vector3d& at : line)
    {
      made.lines.back().emplace_back(at.x(), at.y(), at.z());
    }
  }
  return made;
}
} // namespace palpate

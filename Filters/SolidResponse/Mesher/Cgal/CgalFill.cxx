// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Mesher/Cgal/CgalMesher.h"

#include "Mechanics/JoinedText.h"
#include "SolidResponse/Mesher/Cgal/CgalSurface.h"
#include "SolidResponse/Mesher/Cgal/FollowedEdges.h"

#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/perturb_mesh_3.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iterator>
#include <map>
#include <utility>

namespace palpate
{
namespace
{
using Kernel = CgalKernel;
using Point = CgalPoint;
using Surface = CgalSurface;
using Domain = CGAL::Polyhedral_mesh_domain_with_features_3<Kernel, Surface>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain, CGAL::Default, CGAL::Sequential_tag>::type;
using Complex =
  CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, Domain::Corner_index, Domain::Curve_index>;
} // namespace
} // namespace palpate

/// By default, CGAL writes a surface that it cannot fill to files in the working directory. This
/// specialization writes no files. CGAL 6 passes one more argument than CGAL 5.
template <>
struct CGAL::Dump_c3t3<palpate::Complex>
{
  template <class... Options>
  void dump_c3t3(const palpate::Complex&, const std::string&, const Options&...) const
  {
  }
};

namespace palpate
{
namespace
{
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

// The criteria of CGAL limit radii. The resulting edge lengths were measured on balls. On average
// they are 0.95 to 1.05 times the spacing, both on the surface and inside.

/// Largest radius of a facet's circumscribed circle, in spacings.
constexpr double FacetRadius = 0.72;
/// Largest radius of a cell's circumscribed sphere, in spacings.
constexpr double CellRadius = 0.80;
constexpr double FacetAngle = 25.0; ///< smallest angle of a facet, degrees; CGAL allows at most 30
/// Largest ratio of the radius of a cell's circumscribed sphere to the cell's shortest edge.
constexpr double RadiusEdge = 2.0;
constexpr double SliverAngle = 10.0; ///< target for the smallest dihedral angle, degrees
constexpr double LookupsPerCell = 6.0;
constexpr std::size_t LookupsPerReport = 4096;
constexpr std::size_t SeedsPerPart = 12;
/// Fraction of the work for the refinement; the rest is the removal of slivers.
constexpr double RefinedShare = 0.9;

/// Largest ratio of the number of cells that the deviation requires to the expected number.
constexpr double LargestExcess = 5.0;

struct Stopped
{
};
struct TooRough
{
};

/// Returns the spacing at a point, and calls the observer once per LookupsPerReport calls.
class SpacingField
{
public:
  SpacingField(const MeshedSurface& surface, double cells, const WorkObserver& observer)
    : Grid(surface)
    , Expected(LookupsPerCell * std::max(cells, 1.0))
    , Observer(observer)
  {
  }

  double at(const Point& place)
  {
    if (++this->Lookups % LookupsPerReport == 0)
    {
      const double done = static_cast<double>(this->Lookups) / this->Expected;
      if (done > LargestExcess)
      {
        throw TooRough();
      }
      if (this->Observer && !this->Observer(RefinedShare * (1.0 - std::exp(-done))))
      {
        throw Stopped();
      }
    }
    return this->Grid.at({ place.x(), place.y(), place.z() });
  }

private:
  SpacingGrid Grid;
  double Expected;
  const WorkObserver& Observer;
  std::size_t Lookups = 0;
};

/// A field for the criteria, which is a multiple of the spacing.
struct RadiusField
{
  using FT = Kernel::FT;
  using Point_3 = Point;
  using Index = Domain::Index;

  SpacingField* spacing;
  double factor;

  FT operator()(const Point_3& place, int, const Index&) const
  {
    return this->factor * this->spacing->at(place);
  }
};

/// A domain with initial points on all of its parts. They are needed because rays from the centre
/// miss small parts.
class SeededDomain : public Domain
{
public:
  SeededDomain(const Surface& surface, std::vector<Point> seeds)
    : Domain(surface)
    , Seeds(std::move(seeds))
  {
  }

  struct Construct_initial_points
  {
    const SeededDomain& domain;

    template <class Output>
    Output operator()(Output points, int = 0) const
    {
      for (const Point& seed : this->domain.Seeds)
      {
        const auto [at, face] = this->domain.aabb_tree().closest_point_and_primitive(seed);
        *points++ = std::make_pair(
          at, this->domain.index_from_surface_patch_index(this->domain.make_surface_index(face)));
      }
      return points;
    }
  };

  Construct_initial_points construct_initial_points_object() const { return { *this }; }

private:
  std::vector<Point> Seeds;
};

/// Returns the centres of triangles that are spread over each part of the surface.
std::vector<Point> spreadSeeds(Surface& surface)
{
  auto part = surface.add_property_map<Surface::Face_index, std::size_t>("f:part", 0).first;
  const std::size_t count = CGAL::Polygon_mesh_processing::connected_components(surface, part);
  std::vector<std::vector<Point>> middles(count);
  for (const Surface::Face_index face : surface.faces())
  {
    Kernel::Vector_3 sum(0.0, 0.0, 0.0);
    for (const Surface::Vertex_index v : surface.vertices_around_face(surface.halfedge(face)))
    {
      sum += surface.point(v) - CGAL::ORIGIN;
    }
    middles[part[face]].push_back(CGAL::ORIGIN + sum / 3.0);
  }
  std::vector<Point> seeds;
  for (const auto& own : middles)
  {
    const std::size_t wanted = std::min(SeedsPerPart, own.size());
    for (std::size_t i = 0; i < wanted; ++i)
    {
      seeds.push_back(own[i * own.size() / wanted]);
    }
  }
  return seeds;
}

void extract(const Complex& complex, TetrahedralMesh& mesh)
{
  std::map<Complex::Vertex_handle, std::int32_t> number;
  std::vector<Point> places;
  for (auto cell = complex.cells_in_complex_begin(); cell != complex.cells_in_complex_end(); ++cell)
  {
    std::array<std::int32_t, 4> ids{};
    for (int i = 0; i < 4; ++i)
    {
      const auto [at, isNew] =
        number.try_emplace(cell->vertex(i), static_cast<std::int32_t>(places.size()));
      if (isNew)
      {
        places.push_back(cell->vertex(i)->point().point());
      }
      ids[static_cast<std::size_t>(i)] = at->second;
    }
    mesh.cells.push_back(ids);
  }
  mesh.nodes.resize(3, static_cast<Eigen::Index>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    mesh.nodes.col(static_cast<Eigen::Index>(i)) << places[i].x(), places[i].y(), places[i].z();
  }
  for (auto edge = complex.edges_in_complex_begin(); edge != complex.edges_in_complex_end(); ++edge)
  {
    const auto from = number.find(edge->first->vertex(edge->second));
    const auto to = number.find(edge->first->vertex(edge->third));
    if (from != number.end() && to != number.end())
    {
      const auto [low, high] = std::minmax(from->second, to->second);
      mesh.sharpEdges.push_back({ low, high });
    }
  }
  std::sort(mesh.sharpEdges.begin(), mesh.sharpEdges.end());
}
} // namespace

std::string fillByCgal(
  const MeshedSurface& wanted, double cells, const WorkObserver& observer, TetrahedralMesh& mesh)
{
  mesh = {};
  Surface surface;
  const std::string fault = toCgal(wanted, surface);
  if (!fault.empty())
  {
    return fault;
  }
  try
  {
    SeededDomain domain(surface, spreadSeeds(surface));
    const FollowedEdges followed = followedEdges(surface, wanted);
    if (followed.areDetected)
    {
      domain.detect_features(wanted.sharpAngle);
    }
    domain.add_features(followed.lines.begin(), followed.lines.end());
    SpacingField spacing(wanted, cells, observer);
    const Criteria criteria(Criteria::Edge_criteria(RadiusField{ &spacing, 1.0 }),
      Criteria::Facet_criteria(FacetAngle, RadiusField{ &spacing, FacetRadius }, wanted.deviation),
      Criteria::Cell_criteria(RadiusEdge, RadiusField{ &spacing, CellRadius }));
    const auto outside =
      wanted.isManifold ? CGAL::parameters::manifold() : CGAL::parameters::non_manifold();
    auto complex = CGAL::make_mesh_3<Complex>(
      domain, criteria, outside, CGAL::parameters::no_perturb(), CGAL::parameters::no_exude());
    if (observer && !observer(RefinedShare))
    {
      return {};
    }
#if CGAL_VERSION_NR >= 1050600000
    CGAL::perturb_mesh_3(complex, domain, CGAL::parameters::sliver_bound(SliverAngle));
#else
    CGAL::perturb_mesh_3(complex, domain, CGAL::parameters::sliver_bound = SliverAngle);
#endif
    extract(complex, mesh);
  }
  catch (const TooRough&)
  {
    mesh = {};
    mesh.isTooRough = true;
  }
  catch (const Stopped&)
  {
    mesh = {};
  }
  catch (const std::exception& failed)
  {
    mesh = {};
    return joined("CGAL cannot fill it: ", failed.what());
  }
  return {};
}
} // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/FiniteElements/PatchCut.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

namespace palpate
{
namespace
{
using Numbers = std::unordered_map<std::int32_t, std::int32_t>;

/// Returns the elements around a node within the distance `reach`, which are found from neighbour
/// to neighbour.
std::vector<std::int32_t> elementsAround(
  const VolumeMesh& mesh, const MeshTopology& topology, std::int32_t node, double reach)
{
  const Eigen::Vector3d centre = mesh.nodes.col(node);
  std::vector<std::int32_t> found(topology.elementsBegin(node), topology.elementsEnd(node));
  std::unordered_set<std::int32_t> seen(found.begin(), found.end());
  for (std::size_t next = 0; next < found.size(); ++next)
  {
    const ElementKind kind = mesh.elements[static_cast<std::size_t>(found[next])].kind;
    for (int f = 0; f < faceCount(kind); ++f)
    {
      const std::int32_t other = topology.across(found[next], f);
      if (other >= 0 && seen.insert(other).second &&
        (elementMiddle(mesh, mesh.elements[static_cast<std::size_t>(other)]) - centre).norm() <=
          reach)
      {
        found.push_back(other);
      }
    }
  }
  return found;
}

using Place = std::array<long long, 3>;

/// Returns a position as integers in units of `grain`, for sorting and comparing.
Place wholePlace(const Eigen::Vector3d& x, double grain)
{
  return { std::llround(x[0] / grain), std::llround(x[1] / grain), std::llround(x[2] / grain) };
}

/// Sorts the indices `things` by the positions that `placeOf` returns for them.
template <class PlaceOf>
void sortByPlace(std::vector<std::int32_t>& things, const PlaceOf& placeOf)
{
  std::vector<std::pair<Place, std::int32_t>> placed;
  placed.reserve(things.size());
  for (const std::int32_t thing : things)
  {
    placed.emplace_back(placeOf(thing), thing);
  }
  std::sort(placed.begin(), placed.end());
  for (std::size_t i = 0; i < placed.size(); ++i)
  {
    things[i] = placed[i].second;
  }
}

/// Returns the boundary faces of the given elements that are connected to a point by triangles
/// whose normals are within 30° of the point's normal.
std::vector<std::int32_t> facesOnTop(const MeshTopology& topology, const BodySurface& surface,
  std::int32_t point, const std::unordered_set<std::int32_t>& elements)
{
  const Eigen::Vector3d& normal = surface.normal(point);
  std::vector<std::int32_t> faces;
  std::unordered_set<std::int32_t> seenFaces;
  std::unordered_set<std::int32_t> seenPoints = { point };
  std::vector<std::int32_t> points = { point };
  for (std::size_t next = 0; next < points.size(); ++next)
  {
    const std::int32_t from = points[next];
    for (const std::int32_t* t = surface.trianglesBegin(from); t != surface.trianglesEnd(from); ++t)
    {
      const std::int32_t face = surface.faceOfTriangle(*t);
      const std::int32_t element = topology.boundary()[static_cast<std::size_t>(face)].element;
      if (!seenFaces.insert(face).second || elements.find(element) == elements.end())
      {
        continue;
      }
      bool flat = true;
      for (std::int32_t k = surface.firstTriangle(face); k < surface.firstTriangle(face + 1); ++k)
      {
        flat = flat && surface.triangleNormal(k).dot(normal) >= PatchTurn;
      }
      if (!flat)
      {
        continue;
      }
      faces.push_back(face);
      for (std::int32_t k = surface.firstTriangle(face); k < surface.firstTriangle(face + 1); ++k)
      {
        for (const std::int32_t corner : surface.triangle(k))
        {
          if (seenPoints.insert(corner).second)
          {
            points.push_back(corner);
          }
        }
      }
    }
  }
  return faces;
}

/// Depth of the surface below the tangent plane, as a quadratic function of the position in the
/// tangent plane.
struct QuadraticSheet
{
  Eigen::Matrix<double, 5, 1> coefficient = Eigen::Matrix<double, 5, 1>::Zero();

  static Eigen::Matrix<double, 1, 5> terms(double x, double y)
  {
    return { x, y, x * x, x * y, y * y };
  }
  double operator()(double x, double y) const { return terms(x, y) * this->coefficient; }
};

/// Shifts the nodes along z such that the surface becomes the plane z = 0.
void flatten(VolumeMesh& mesh, const std::vector<unsigned char>& onTop, double spacing)
{
  std::vector<Eigen::Index> top;
  double deviation = 0.0;
  for (Eigen::Index i = 0; i < mesh.nodes.cols(); ++i)
  {
    if (onTop[static_cast<std::size_t>(i)])
    {
      top.push_back(i);
      deviation = std::max(deviation, std::abs(mesh.nodes(2, i)));
    }
  }
  if (deviation > 1e-9 * spacing && top.size() >= 5)
  {
    Eigen::MatrixXd terms(static_cast<Eigen::Index>(top.size()), 5);
    Eigen::VectorXd depth(terms.rows());
    for (Eigen::Index i = 0; i < terms.rows(); ++i)
    {
      const auto node = mesh.nodes.col(top[static_cast<std::size_t>(i)]);
      terms.row(i) = QuadraticSheet::terms(node[0] / spacing, node[1] / spacing);
      depth[i] = node[2];
    }
    QuadraticSheet sheet;
    sheet.coefficient = terms.colPivHouseholderQr().solve(depth);
    for (Eigen::Index i = 0; i < mesh.nodes.cols(); ++i)
    {
      mesh.nodes(2, i) -= sheet(mesh.nodes(0, i) / spacing, mesh.nodes(1, i) / spacing);
    }
  }
  for (const Eigen::Index i : top)
  {
    mesh.nodes(2, i) = 0.0;
  }
}

/// Returns the role of each node in a cut that consists of the elements `kept`. Nodes are
/// prescribed on all faces at which the cut ends, except on the free surface.
std::vector<CutNode> markNodes(const LocalPatch& patch, const MeshTopology& topology,
  const std::unordered_set<std::int32_t>& topFaces, const std::unordered_set<std::int32_t>& kept,
  std::size_t nodeTotal)
{
  std::vector<CutNode> marks(nodeTotal, CutNode::Outside);
  // The roles are set in two passes. The second pass sets Prescribed, which has priority.
  for (const bool prescribing : { false, true })
  {
    for (std::size_t i = 0; i < patch.elements.size(); ++i)
    {
      if (kept.find(patch.elements[i]) == kept.end())
      {
        continue;
      }
      const VolumeElement& element = patch.mesh.elements[i];
      for (int k = 0; k < nodeCount(element.kind) && !prescribing; ++k)
      {
        marks[static_cast<std::size_t>(element.nodes[static_cast<std::size_t>(k)])] = CutNode::Free;
      }
      for (int f = 0; f < faceCount(element.kind) && prescribing; ++f)
      {
        const std::int32_t other = topology.across(patch.elements[i], f);
        const bool goesOn =
          other >= 0 ? kept.find(other) != kept.end() : topFaces.find(-1 - other) != topFaces.end();
        const ElementFace& face = elementFace(element.kind, f);
        for (std::size_t k = 0; k < static_cast<std::size_t>(face.nodes) && !goesOn; ++k)
        {
          marks[static_cast<std::size_t>(element.nodes[static_cast<std::size_t>(face.node[k])])] =
            CutNode::Prescribed;
        }
      }
    }
  }
  return marks;
}

/// An FNV-1a hash in two streams of 64 bits.
class KeyStream
{
public:
  void add(std::uint64_t word)
  {
    this->Key[0] = (this->Key[0] ^ word) * 0x100000001b3U;
    this->Key[0] ^= this->Key[0] >> 29U;
    this->Key[1] = (this->Key[1] ^ (word * 0x9e3779b97f4a7c15U)) * 0xd6e8feb86659fd93U;
    this->Key[1] ^= this->Key[1] >> 32U;
  }
  void add(long long number) { this->add(static_cast<std::uint64_t>(number)); }
  const PatchKey& key() const { return this->Key; }

private:
  PatchKey Key = { 0xcbf29ce484222325U, 0x84222325cbf29ce4U };
};
} // namespace

LocalPatch cutOut(const VolumeMesh& mesh, const MeshTopology& topology, const BodySurface& surface,
  std::int32_t point, const std::array<PatchLoad, 2>& loads, const std::array<double, 2>& reach,
  double poissonRatio)
{
  LocalPatch patch;
  patch.poissonRatio = poissonRatio;
  patch.spacing = surface.spacing(point);
  const std::int32_t centre = surface.node(point);
  const Eigen::Matrix3d frame = tangentFrame(surface.normal(point));
  const auto toFrame = [&](const Eigen::Vector3d& x) -> Eigen::Vector3d
  { return frame.transpose() * (x - mesh.nodes.col(centre)); };

  patch.elements = elementsAround(mesh, topology, centre, reach[1]);
  const double coarse = 1e-4 * patch.spacing;
  sortByPlace(patch.elements,
    [&](std::int32_t e)
    {
      return wholePlace(
        toFrame(elementMiddle(mesh, mesh.elements[static_cast<std::size_t>(e)])), coarse);
    });
  const std::vector<std::int32_t>& elements = patch.elements;
  const std::unordered_set<std::int32_t> taken(elements.begin(), elements.end());
  std::vector<std::int32_t> nodes;
  for (const std::int32_t e : elements)
  {
    const VolumeElement& element = mesh.elements[static_cast<std::size_t>(e)];
    nodes.insert(
      nodes.end(), element.nodes.begin(), element.nodes.begin() + nodeCount(element.kind));
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  sortByPlace(
    nodes, [&](std::int32_t i) { return wholePlace(toFrame(mesh.nodes.col(i)), coarse); });
  Numbers number;
  patch.mesh.nodes.resize(3, static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    number.emplace(nodes[i], static_cast<std::int32_t>(i));
    patch.mesh.nodes.col(static_cast<Eigen::Index>(i)) = toFrame(mesh.nodes.col(nodes[i]));
  }
  for (const std::int32_t e : elements)
  {
    VolumeElement element = mesh.elements[static_cast<std::size_t>(e)];
    for (int i = 0; i < nodeCount(element.kind); ++i)
    {
      std::int32_t& node = element.nodes[static_cast<std::size_t>(i)];
      node = number.at(node);
    }
    patch.mesh.elements.push_back(element);
  }

  std::vector<unsigned char> onTop(nodes.size(), 0);
  std::unordered_set<std::int32_t> topFaces;
  for (const std::int32_t face : facesOnTop(topology, surface, point, taken))
  {
    topFaces.insert(face);
    for (std::int32_t t = surface.firstTriangle(face); t < surface.firstTriangle(face + 1); ++t)
    {
      for (const std::int32_t corner : surface.triangle(t))
      {
        onTop[static_cast<std::size_t>(number.at(surface.node(corner)))] = 1;
      }
    }
  }
  const Eigen::Vector3d origin = mesh.nodes.col(centre);
  std::unordered_set<std::int32_t> within; // the elements of the inner cut
  for (const std::int32_t e : elements)
  {
    const VolumeElement& element = mesh.elements[static_cast<std::size_t>(e)];
    const bool isInner = (elementMiddle(mesh, element) - origin).norm() <= reach[0] ||
      std::find(topology.elementsBegin(centre), topology.elementsEnd(centre), e) !=
        topology.elementsEnd(centre);
    patch.inner.push_back(isInner ? 1 : 0);
    if (isInner)
    {
      within.insert(e);
    }
  }
  for (std::size_t cut = 0; cut < 2; ++cut)
  {
    patch.nodes[cut] =
      markNodes(patch, topology, topFaces, cut == 0 ? within : taken, nodes.size());
  }
  flatten(patch.mesh, onTop, patch.spacing);

  for (std::size_t k = 0; k < 2; ++k)
  {
    patch.loads[k].complete = loads[k].complete;
    for (const auto& [node, weight] : loads[k].nodes)
    {
      const auto at = number.find(node);
      if (at == number.end())
      {
        patch.loads[k].complete = false;
        continue;
      }
      patch.loads[k].nodes.emplace_back(at->second, weight);
    }
    std::sort(patch.loads[k].nodes.begin(), patch.loads[k].nodes.end());
    for (std::size_t q = 0; q < DiscRule::Count; ++q)
    {
      patch.loads[k].places[q] = toFrame(loads[k].places[q]);
      patch.loads[k].places[q][2] = 0.0;
    }
  }
  return patch;
}

PatchKey patchKey(const LocalPatch& patch)
{
  const double grain = 1e-7 * patch.spacing;
  KeyStream stream;
  stream.add(std::llround(patch.poissonRatio * 1e15));
  stream.add(std::llround(patch.spacing * 1e9));
  for (Eigen::Index i = 0; i < patch.mesh.nodes.cols(); ++i)
  {
    for (const long long number : wholePlace(patch.mesh.nodes.col(i), grain))
    {
      stream.add(number);
    }
    for (const auto& marks : patch.nodes)
    {
      stream.add(static_cast<long long>(marks[static_cast<std::size_t>(i)]));
    }
  }
  for (const VolumeElement& element : patch.mesh.elements)
  {
    // The nodes are sorted, because the numbering of equal elements may start at different corners.
    auto nodes = element.nodes;
    const int count = nodeCount(element.kind);
    std::sort(nodes.begin(), nodes.begin() + count);
    stream.add(static_cast<long long>(element.kind));
    for (int i = 0; i < count; ++i)
    {
      stream.add(static_cast<long long>(nodes[static_cast<std::size_t>(i)]));
    }
  }
  for (const PatchLoad& load : patch.loads)
  {
    for (const auto& [node, weight] : load.nodes)
    {
      stream.add(static_cast<long long>(node));
      stream.add(std::llround(weight * 1e9));
    }
  }
  return stream.key();
}
} // namespace palpate

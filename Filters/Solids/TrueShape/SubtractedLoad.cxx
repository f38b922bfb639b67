// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/SubtractedLoad.h"

#include "Solids/FiniteElements/PatchLoad.h"
#include "Solids/TrueShape/FaceRule.h"
#include "Solids/TrueShape/InclusionLoad.h"

#include <algorithm>

namespace palpate
{
SingularSource::SingularSource(const ElasticBody& body, std::int32_t surfacePoint)
  : point(surfacePoint)
  , frame(tangentFrame(body.surface().normal(surfacePoint)))
  , origin(body.surface().position(surfacePoint))
  , material(body.materialAt(body.surface().node(surfacePoint)))
{
}

/// Forces on all nodes, and the positions of the nodes, in the frame of one source.
struct SubtractedLoad::Work
{
  explicit Work(const ElasticBody& body, const SingularSource& from)
    : source(from)
    , field(from.material)
    , nodes(from.frame.transpose() * (body.mesh().nodes.colwise() - from.origin))
    , forces(Eigen::Matrix3Xd::Zero(3, this->nodes.cols()))
    , own(body.surface().node(from.point))
    , under(static_cast<std::size_t>(this->nodes.cols()))
  {
    for (std::int32_t node = 0; node < body.mesh().nodeTotal(); ++node)
    {
      const bool isUnder = node == this->own || SingularSource::isUnder(this->nodes.col(node));
      this->under[static_cast<std::size_t>(node)] = isUnder ? 1 : 0;
      this->overhangs = this->overhangs || !isUnder;
    }
  }

  bool isUnder(std::int32_t node) const { return this->under[static_cast<std::size_t>(node)] != 0; }
  /// Returns the number of the element's nodes at which the singular field is used.
  int nodesUnder(const VolumeElement& element) const
  {
    int count = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(nodeCount(element.kind)); ++i)
    {
      count += this->under[static_cast<std::size_t>(element.nodes[i])];
    }
    return count;
  }
  bool isWhole(const VolumeElement& element) const
  {
    return !this->overhangs || this->nodesUnder(element) == nodeCount(element.kind);
  }
  ElementNodes nodesOf(const VolumeElement& element) const
  {
    ElementNodes found(3, nodeCount(element.kind));
    for (Eigen::Index i = 0; i < found.cols(); ++i)
    {
      found.col(i) = this->nodes.col(element.nodes[static_cast<std::size_t>(i)]);
    }
    return found;
  }

  const SingularSource& source;
  BoussinesqField field;
  Eigen::Matrix3Xd nodes;
  Eigen::Matrix3Xd forces;
  std::int32_t own; ///< surface node at X
  /// For each node: 1 if the singular field is used at the node, else 0.
  std::vector<unsigned char> under;
  /// Whether there are nodes at which the singular field is not used.
  bool overhangs = false;
  std::vector<FacePoint> points;
};

SubtractedLoad::SubtractedLoad(const ElasticBody& body)
  : Body(body)
  , Uniform(body.isUniform())
{
  const VolumeMesh& mesh = body.mesh();
  const std::vector<BoundaryFace>& boundary = body.topology().boundary();
  for (std::size_t f = 0; f < boundary.size(); ++f)
  {
    const VolumeElement& element = mesh.elements[static_cast<std::size_t>(boundary[f].element)];
    const ElementFace& face = elementFace(element.kind, boundary[f].face);
    bool held = true;
    for (std::size_t i = 0; i < static_cast<std::size_t>(face.nodes); ++i)
    {
      held = held && body.isHeld(element.nodes[static_cast<std::size_t>(face.node[i])]);
    }
    if (!held)
    {
      this->LoadedFaces.push_back(static_cast<std::int32_t>(f));
    }
  }
  this->couple();
}

/// Computes the stiffness between unknowns and held directions.
void SubtractedLoad::couple()
{
  const VolumeMesh& mesh = this->Body.mesh();
  const auto place = [](std::int32_t node, int axis)
  { return 3 * static_cast<std::size_t>(node) + static_cast<std::size_t>(axis); };
  std::vector<int> column(3 * static_cast<std::size_t>(mesh.nodeTotal()), -1);
  for (std::int32_t node = 0; node < mesh.nodeTotal(); ++node)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (this->Body.unknown(node, axis) < 0)
      {
        column[place(node, axis)] = static_cast<int>(this->Held.size());
        this->Held.emplace_back(node, axis);
      }
    }
  }
  std::vector<Eigen::Triplet<double>> entries;
  ElementMatrix k;
  for (std::int32_t e = 0; e < mesh.elementTotal(); ++e)
  {
    const VolumeElement& element = mesh.elements[static_cast<std::size_t>(e)];
    const auto node = [&element](int i) { return element.nodes[static_cast<std::size_t>(i / 3)]; };
    const int size = 3 * nodeCount(element.kind);
    bool touches = false;
    for (int i = 0; i < size; ++i)
    {
      touches = touches || this->Body.unknown(node(i), i % 3) < 0;
    }
    if (!touches ||
      !elementStiffness(element.kind, elementNodes(mesh, element), this->Body.material(e), k))
    {
      continue;
    }
    for (int j = 0; j < size; ++j)
    {
      const int held = column[place(node(j), j % 3)];
      for (int i = 0; held >= 0 && i < size; ++i)
      {
        const int row = this->Body.unknown(node(i), i % 3);
        if (row >= 0)
        {
          entries.emplace_back(row, held, k(i, j));
        }
      }
    }
  }
  this->Coupling.resize(this->Body.unknowns(), static_cast<Eigen::Index>(this->Held.size()));
  this->Coupling.setFromTriplets(entries.begin(), entries.end());
}

void SubtractedLoad::addFace(std::int32_t element, int face, Work& work) const
{
  const VolumeElement& cell = this->Body.mesh().elements[static_cast<std::size_t>(element)];
  const ElementFace& side = elementFace(cell.kind, face);
  LocalFace local;
  local.count = side.nodes;
  std::array<std::int32_t, 6> node{};
  for (int i = 0; i < side.nodes; ++i)
  {
    const auto at = static_cast<std::size_t>(i);
    node[at] = cell.nodes[static_cast<std::size_t>(side.node[at])];
    local.nodes.col(i) = work.nodes.col(node[at]);
    local.own = node[at] == work.own ? i : local.own;
  }
  facePoints(local, work.points);
  for (const FacePoint& point : work.points)
  {
    const Eigen::Vector3d traction = work.field.stress(point.at) * point.area;
    for (std::size_t i = 0; i < static_cast<std::size_t>(side.nodes); ++i)
    {
      work.forces.col(node[i]) -= point.shape[i] * traction;
    }
  }
}

void SubtractedLoad::addOuterFaces(Work& work) const
{
  const double flat = 1e-9 * work.nodes.colwise().norm().maxCoeff();
  for (const std::int32_t f : this->LoadedFaces)
  {
    const BoundaryFace& boundary = this->Body.topology().boundary()[static_cast<std::size_t>(f)];
    const VolumeElement& cell =
      this->Body.mesh().elements[static_cast<std::size_t>(boundary.element)];
    const ElementFace& side = elementFace(cell.kind, boundary.face);
    double away = 0.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(side.nodes); ++i)
    {
      const std::int32_t node = cell.nodes[static_cast<std::size_t>(side.node[i])];
      away = std::max(away, std::abs(work.nodes(2, node)));
    }
    if (away > flat && work.isWhole(cell))
    {
      this->addFace(boundary.element, boundary.face, work);
    }
  }
}

void SubtractedLoad::addInclusions(Work& work) const
{
  for (std::int32_t e = 0; e < this->Body.mesh().elementTotal(); ++e)
  {
    const VolumeElement& cell = this->Body.mesh().elements[static_cast<std::size_t>(e)];
    const ElasticMaterial& material = this->Body.material(e);
    if (isAlike(material, work.source.material) || !work.isWhole(cell))
    {
      continue;
    }
    const ElementNodes forces =
      inclusionLoad(cell.kind, work.nodesOf(cell), material, work.source.material, work.field);
    for (Eigen::Index i = 0; i < forces.cols(); ++i)
    {
      work.forces.col(cell.nodes[static_cast<std::size_t>(i)]) += forces.col(i);
    }
  }
}

/// Adds the loads of the elements that cross the cone, and of the faces outside the cone that
/// adjoin these elements.
void SubtractedLoad::addOverhang(Work& work) const
{
  ElementMatrix k;
  for (std::int32_t e = 0; e < this->Body.mesh().elementTotal(); ++e)
  {
    const VolumeElement& cell = this->Body.mesh().elements[static_cast<std::size_t>(e)];
    const int under = work.nodesUnder(cell);
    if (under == nodeCount(cell.kind))
    {
      for (int face = 0; face < faceCount(cell.kind); ++face)
      {
        const std::int32_t other = this->Body.topology().across(e, face);
        if (other >= 0 &&
          !work.isWhole(this->Body.mesh().elements[static_cast<std::size_t>(other)]))
        {
          this->addFace(e, face, work);
        }
      }
      continue;
    }
    if (under == 0 || !elementStiffness(cell.kind, work.nodesOf(cell), this->Body.material(e), k))
    {
      continue;
    }
    Eigen::VectorXd moved = Eigen::VectorXd::Zero(k.rows());
    for (int i = 0; i < nodeCount(cell.kind); ++i)
    {
      const std::int32_t node = cell.nodes[static_cast<std::size_t>(i)];
      if (work.isUnder(node) && node != work.own)
      {
        moved.segment<3>(3 * i) = work.field.displacement(work.nodes.col(node));
      }
    }
    const Eigen::VectorXd forces = k * moved;
    for (int i = 0; i < nodeCount(cell.kind); ++i)
    {
      work.forces.col(cell.nodes[static_cast<std::size_t>(i)]) -= forces.segment<3>(3 * i);
    }
  }
}

Eigen::VectorXd SubtractedLoad::load(const SingularSource& source) const
{
  Work work(this->Body, source);
  this->addOuterFaces(work);
  if (!this->Uniform)
  {
    this->addInclusions(work);
  }
  if (work.overhangs)
  {
    this->addOverhang(work);
  }
  Eigen::VectorXd load = Eigen::VectorXd::Zero(this->Body.unknowns());
  for (std::int32_t i = 0; i < this->Body.mesh().nodeTotal(); ++i)
  {
    const Eigen::Vector3d force = source.frame * work.forces.col(i);
    for (int axis = 0; axis < 3; ++axis)
    {
      const int unknown = this->Body.unknown(i, axis);
      if (unknown >= 0)
      {
        load[unknown] = force[axis];
      }
    }
  }
  Eigen::VectorXd held(static_cast<Eigen::Index>(this->Held.size()));
  for (Eigen::Index i = 0; i < held.size(); ++i)
  {
    const auto& [node, axis] = this->Held[static_cast<std::size_t>(i)];
    held[i] = work.isUnder(node) && node != work.own
      ? -source.frame.row(axis).dot(work.field.displacement(work.nodes.col(node)))
      : 0.0;
  }
  load -= this->Coupling * held;
  return load;
}

Eigen::Matrix3Xd regularDisplacement(
  const ElasticBody& body, const SingularSource& source, const Eigen::VectorXd& smooth)
{
  const BoussinesqField field(source.material);
  Eigen::Matrix3Xd moved(3, body.mesh().nodeTotal());
  for (std::int32_t node = 0; node < body.mesh().nodeTotal(); ++node)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const int unknown = body.unknown(node, axis);
      moved(axis, node) = unknown >= 0 ? smooth[unknown]
                                       : -source.frame.row(axis).dot(field.displacement(
                                           source.inFrame(body.mesh().nodes.col(node))));
    }
  }
  return moved;
}
} // namespace palpate

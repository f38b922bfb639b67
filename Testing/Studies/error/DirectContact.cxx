// SPDX-License-Identifier: BSD-3-Clause
#include "DirectContact.h"

#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/SharedWork.h"
#include "UnilateralContact.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

namespace palpate::testing
{
namespace
{
/// What may touch: no farther from the tool, pressed in, than this part of its depth.
constexpr double TouchMargin = 0.1;
constexpr int Divisions = 5; ///< of a facet's sides
constexpr std::size_t CornersAtATime = 32;
/// Cosine between the tool's axis and what it is pressed on.
constexpr double LeastFacing = 0.1;
constexpr double NearWall = 0.995; ///< of a round tool, which is vertical there
constexpr double NearTool = 1.1;
/// How often the mean is told anew, from the axis on.
constexpr int Turns = 2;
/// A corner of which the tool covers less is left out.
constexpr double LeastPart = 0.02;

/// A facet's shapes at a place in it: of its nodes, and of its corners.
struct FacetShapes
{
  Eigen::VectorXd nodes;
  Eigen::VectorXd corners;
};

FacetShapes triangleShapes(double s, double t, int nodes)
{
  FacetShapes made;
  const Eigen::Vector3d l(1.0 - s - t, s, t);
  made.corners = l;
  made.nodes = l;
  if (nodes == 6)
  {
    made.nodes.resize(6);
    made.nodes << l.array() * (2.0 * l.array() - 1.0), 4.0 * l[0] * l[1], 4.0 * l[1] * l[2],
      4.0 * l[2] * l[0];
  }
  return made;
}

FacetShapes squareShapes(double s, double t)
{
  FacetShapes made;
  made.corners = Eigen::Vector4d((1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t);
  made.nodes = made.corners;
  return made;
}

/// Calls visit(shapes) in the middle of equal parts of a facet; returns how many there are.
template <class Visit>
void visitParts(int corners, int nodes, const Visit& visit)
{
  constexpr double step = 1.0 / Divisions;
  for (int i = 0; i < Divisions; ++i)
  {
    for (int j = 0; j < Divisions; ++j)
    {
      const double s = step * i;
      const double t = step * j;
      if (corners == 4)
      {
        visit(squareShapes(s + 0.5 * step, t + 0.5 * step));
        continue;
      }
      if (i + j < Divisions)
      {
        visit(triangleShapes(s + step / 3.0, t + step / 3.0, nodes));
      }
      if (i + j < Divisions - 1)
      {
        visit(triangleShapes(s + 2.0 * step / 3.0, t + 2.0 * step / 3.0, nodes));
      }
    }
  }
}

Eigen::Matrix3d frameAlong(const Eigen::Vector3d& inward)
{
  Eigen::Matrix3d frame;
  frame.col(0) = inward.unitOrthogonal();
  frame.col(1) = inward.cross(frame.col(0));
  frame.col(2) = inward;
  return frame;
}

/// Corners by their compliance along the directions in which they are pushed.
class PushedCorners : public CompliantNodes
{
public:
  explicit PushedCorners(const Eigen::MatrixXd& compliance)
    : Compliance(compliance)
  {
  }

  void press(
    const std::vector<int>& active, const Eigen::VectorXd& wanted, Eigen::VectorXd& forces) override
  {
    forces.setZero(wanted.size());
    if (active.empty())
    {
      return;
    }
    const Eigen::MatrixXd some = this->Compliance(active, active);
    const Eigen::VectorXd right = wanted(active);
    const Eigen::VectorXd found = some.ldlt().solve(right);
    forces(active) = found;
  }

  void move(const std::vector<int>&, const Eigen::VectorXd& forces, Eigen::VectorXd& moved) override
  {
    moved = this->Compliance * forces;
  }

private:
  const Eigen::MatrixXd& Compliance;
};
} // namespace

DirectContact::DirectContact(const ElasticBody& body, const AxisymmetricTool& tool,
  const DirectPlace& at, double deepest, Pushed pushed)
  : Tool(tool)
  , At(at)
  , Frame(frameAlong(at.inward))
  , Wall(tool.largestContactRadius())
{
  for (double r = 1e3; r > 1e-3 && this->Wall == Infinity; r *= 0.99)
  {
    this->Wall = std::isfinite(tool.profile(r)) ? r : this->Wall;
  }
  this->takeCorners(this->facetsUnder(body, deepest));
  for (Corner& corner : this->Corners)
  {
    corner.push = pushed == Pushed::EachAlongItsOwn ? corner.normal : Eigen::Vector3d::UnitZ();
  }
  this->findCompliance(body);
  for (int turn = 0; turn < Turns && pushed == Pushed::TogetherAlongTheMean; ++turn)
  {
    const Eigen::VectorXd forces = this->forces(deepest);
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < forces.size(); ++i)
    {
      mean += forces[i] / forces.sum() * this->Corners[static_cast<std::size_t>(i)].normal;
    }
    if (mean.allFinite() && mean[2] > 0.0)
    {
      for (Corner& corner : this->Corners)
      {
        corner.push = mean;
      }
      this->findCompliance(body);
    }
  }
}

/// Of the body's surface: facets that the tool, pressed in, reaches into from outside, and that
/// hang together with the place where it is pressed.
std::vector<DirectContact::Facet> DirectContact::facetsUnder(
  const ElasticBody& body, double deepest) const
{
  std::vector<Facet> facets;
  std::map<std::int32_t, std::vector<std::size_t>> around;
  double nearest = Infinity;
  std::size_t first = 0;
  for (const BoundaryFace& boundary : body.topology().boundary())
  {
    Facet facet = this->facet(body.mesh(), boundary);
    if (!this->mayTouch(facet, deepest))
    {
      continue;
    }
    for (int i = 0; i < facet.corners; ++i)
    {
      around[facet.nodes[static_cast<std::size_t>(i)]].push_back(facets.size());
      const double away = facet.places.col(i).norm();
      first = away < nearest ? facets.size() : first;
      nearest = std::min(nearest, away);
    }
    facets.push_back(std::move(facet));
  }
  std::vector<Facet> near;
  std::vector<bool> isTaken(facets.size(), false);
  std::vector<std::size_t> front;
  const auto take = [&](std::size_t next)
  {
    if (!isTaken[next])
    {
      isTaken[next] = true;
      front.push_back(next);
      near.push_back(facets[next]);
    }
  };
  if (!facets.empty())
  {
    take(first);
  }
  while (!front.empty())
  {
    const Facet facet = facets[front.back()];
    front.pop_back();
    for (int i = 0; i < facet.corners; ++i)
    {
      const std::vector<std::size_t>& beside = around[facet.nodes[static_cast<std::size_t>(i)]];
      std::for_each(beside.begin(), beside.end(), take);
    }
  }
  return near;
}

DirectContact::Facet DirectContact::facet(
  const VolumeMesh& mesh, const BoundaryFace& boundary) const
{
  const VolumeElement& element = mesh.elements[static_cast<std::size_t>(boundary.element)];
  const ElementFace& face = elementFace(element.kind, boundary.face);
  Facet made;
  made.corners = face.corners;
  made.places.resize(3, face.nodes);
  for (int i = 0; i < face.nodes; ++i)
  {
    const auto node = static_cast<std::size_t>(face.node[static_cast<std::size_t>(i)]);
    made.nodes.push_back(element.nodes[node]);
    made.places.col(i) =
      this->Frame.transpose() * (mesh.nodes.col(made.nodes.back()) - this->At.place);
  }
  const Eigen::Vector3d along = made.places.col(1) - made.places.col(0);
  const Eigen::Vector3d across = made.places.col(made.corners - 1) - made.places.col(0);
  made.area = along.cross(across) * (made.corners == 3 ? 0.5 : 1.0);
  return made;
}

bool DirectContact::mayTouch(const Facet& facet, double deepest) const
{
  bool isIn = false;
  for (Eigen::Index i = 0; i < facet.places.cols(); ++i)
  {
    const double r = facet.places.col(i).head<2>().norm();
    const double tool = deepest - this->Tool.profile(std::min(r, NearWall * this->Wall));
    isIn = isIn || (r < NearTool * this->Wall && facet.places(2, i) < tool + TouchMargin * deepest);
  }
  return isIn && -facet.area[2] > LeastFacing * facet.area.norm();
}

void DirectContact::takeCorners(const std::vector<Facet>& facets)
{
  struct Part
  {
    Corner corner;
    std::map<std::int32_t, double> nodes;
    double weight = 0.0;
  };
  std::map<std::int32_t, Part> parts;
  const bool isFlat = this->Tool.smallestContactRadius() > 0.0;
  double sum = 0.0;
  for (const Facet& facet : facets)
  {
    const double area = -facet.area[2] / (Divisions * Divisions);
    const Eigen::Vector3d normal = facet.area / facet.area[2];
    visitParts(facet.corners, static_cast<int>(facet.nodes.size()),
      [&](const FacetShapes& shapes)
      {
        const Eigen::Vector3d place = facet.places * shapes.nodes;
        const double r = place.head<2>().norm();
        if (!(r < (isFlat ? 1.0 : NearWall) * this->Wall))
        {
          return;
        }
        for (int i = 0; i < facet.corners; ++i)
        {
          Part& part = parts[facet.nodes[static_cast<std::size_t>(i)]];
          const double weight = shapes.corners[i] * area;
          part.corner.pieces.push_back({ place[2], r, weight });
          part.corner.normal += weight * normal;
          part.weight += weight;
          sum += weight;
          for (std::size_t n = 0; n < facet.nodes.size(); ++n)
          {
            part.nodes[facet.nodes[n]] += weight * shapes.nodes[static_cast<Eigen::Index>(n)];
          }
        }
      });
  }
  for (auto& [node, part] : parts)
  {
    if (part.weight * static_cast<double>(parts.size()) < LeastPart * sum)
    {
      continue;
    }
    part.corner.normal /= part.weight;
    for (Piece& piece : part.corner.pieces)
    {
      piece.weight /= part.weight;
    }
    for (const auto& [of, share] : part.nodes)
    {
      part.corner.nodes.emplace_back(of, share / part.weight);
    }
    this->Corners.push_back(std::move(part.corner));
  }
}

void DirectContact::findCompliance(const ElasticBody& body)
{
  const std::size_t count = this->Corners.size();
  const auto size = static_cast<Eigen::Index>(count);
  this->Compliance.resize(size, size);
  const auto visit = [&](std::size_t i, const auto& add)
  {
    const Eigen::Vector3d push = this->Frame * this->Corners[i].push;
    for (const auto& [node, share] : this->Corners[i].nodes)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        const int unknown = body.unknown(node, axis);
        if (unknown >= 0)
        {
          add(unknown, share * push[axis]);
        }
      }
    }
  };
  const auto solve = [&](std::size_t block)
  {
    const std::size_t first = block * CornersAtATime;
    const std::size_t last = std::min(count, first + CornersAtATime);
    Eigen::MatrixXd loads =
      Eigen::MatrixXd::Zero(body.unknowns(), static_cast<Eigen::Index>(last - first));
    for (std::size_t i = first; i < last; ++i)
    {
      const auto column = static_cast<Eigen::Index>(i - first);
      visit(i, [&](int unknown, double share) { loads(unknown, column) += share; });
    }
    const Eigen::MatrixXd moved = body.factor().solveAll(loads);
    for (std::size_t j = 0; j < count; ++j)
    {
      Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(moved.cols());
      visit(j, [&](int unknown, double share) { sum += share * moved.row(unknown); });
      this->Compliance.block(
        static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(first), 1, sum.size()) = sum;
    }
  };
  shareWork((count + CornersAtATime - 1) / CornersAtATime, solve);
}

Eigen::VectorXd DirectContact::forces(double deflection) const
{
  const auto count = static_cast<Eigen::Index>(this->Corners.size());
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    for (const Piece& piece : this->Corners[static_cast<std::size_t>(i)].pieces)
    {
      const double r = std::min(piece.away, NearWall * this->Wall);
      wanted[i] += piece.weight * (deflection - this->Tool.profile(r) - piece.depth);
    }
  }
  PushedCorners corners(this->Compliance);
  UnilateralContact contact;
  std::vector<int> active;
  Eigen::VectorXd found;
  const bool isSettled = contact.solve(corners, wanted, active, found);
  return isSettled ? found : Eigen::VectorXd::Constant(count, NotANumber);
}

double DirectContact::force(double deflection) const
{
  return this->forces(deflection).sum();
}

} // namespace palpate::testing

// SPDX-License-Identifier: BSD-3-Clause
#include "FiniteBody.h"

#include "Solids/FiniteElements/GlobalModes.h"
#include "GradedBlock.h"
#include "Solids/FiniteElements/PatchCompliance.h"
#include "Solids/FiniteElements/RegularField.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace palpate::testing
{
namespace
{
/// Distance of the nodes of the regular field, mm. The field varies over the thickness of the body.
constexpr double CoarseSpacing = 1.0;

bool always(double)
{
  return true;
}

void check(const std::string& error, const FiniteScene& scene)
{
  if (!error.empty())
  {
    throw std::runtime_error(scene.name + ": " + error);
  }
}
} // namespace

std::shared_ptr<const FiniteBody> FiniteBody::make(const FiniteScene& scene, const FiniteMesh& mesh)
{
  std::shared_ptr<FiniteBody> body(new FiniteBody);
  body->Scene = scene;
  body->Mesh = mesh;
  check(body->Elastic.assemble(gradedBlock(scene, mesh)), scene);
  check(body->Elastic.analyse(StiffnessFactor::Kind::Automatic), scene);
  check(body->Elastic.factorise(), scene);
  body->Side = 2 * static_cast<int>(std::lround(mesh.window / mesh.spacing)) + 1;
  body->Points.assign(static_cast<std::size_t>(body->windowNodes()), -1);
  const BodySurface& surface = body->Elastic.surface();
  for (std::int32_t point = 0; point < surface.pointTotal(); ++point)
  {
    const Eigen::Vector3d& at = surface.position(point);
    if (at.z() == 0.0 && at.head<2>().cwiseAbs().maxCoeff() < mesh.window + 0.5 * mesh.spacing)
    {
      const auto column = std::lround((at.x() + mesh.window) / mesh.spacing);
      const auto row = std::lround((at.y() + mesh.window) / mesh.spacing);
      body->Points[static_cast<std::size_t>(row * body->Side + column)] = point;
    }
  }
  if (std::count(body->Points.begin(), body->Points.end(), -1) > 0)
  {
    throw std::runtime_error(scene.name + ": the window is not covered by nodes");
  }
  return body;
}

int FiniteBody::symmetries() const
{
  const bool square = this->Scene.size.x() == this->Scene.size.y();
  return square && this->Scene.support == Support::Base ? 8 : 4;
}

int FiniteBody::image(int node, int symmetry) const
{
  const int last = this->Side - 1;
  int column = node % this->Side;
  int row = node / this->Side;
  column = (symmetry & 1) != 0 ? last - column : column;
  row = (symmetry & 2) != 0 ? last - row : row;
  return (symmetry & 4) != 0 ? column * this->Side + row : row * this->Side + column;
}

bool FiniteBody::isImage(int node) const
{
  const int half = this->Side / 2;
  const int column = node % this->Side;
  const int row = node / this->Side;
  return column < half || row < half || (this->symmetries() == 8 && column < row);
}

Eigen::VectorXd FiniteBody::solve(const Eigen::VectorXd& forces) const
{
  const BodySurface& surface = this->Elastic.surface();
  Eigen::Matrix3Xd loads = Eigen::Matrix3Xd::Zero(3, this->Elastic.mesh().nodes.cols());
  for (int i = 0; i < this->windowNodes(); ++i)
  {
    loads(2, surface.node(this->point(i))) = -forces[i];
  }
  const Eigen::Matrix3Xd moved = this->Elastic.displacement(loads);
  Eigen::VectorXd inward(this->windowNodes());
  for (int i = 0; i < this->windowNodes(); ++i)
  {
    inward[i] = -moved(2, surface.node(this->point(i)));
  }
  return inward;
}

const Eigen::MatrixXd& FiniteBody::compliance() const
{
  if (this->Compliance.size() > 0)
  {
    return this->Compliance;
  }
  const int nodes = this->windowNodes();
  Eigen::MatrixXd found(nodes, nodes);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(nodes);
  for (int at = 0; at < nodes; ++at)
  {
    if (this->isImage(at))
    {
      continue;
    }
    force[at] = 1.0;
    const Eigen::VectorXd moved = this->solve(force);
    force[at] = 0.0;
    for (int symmetry = 0; symmetry < this->symmetries(); ++symmetry)
    {
      for (int i = 0; i < nodes; ++i)
      {
        found(this->image(i, symmetry), this->image(at, symmetry)) = moved[i];
      }
    }
  }
  this->Asymmetry = (found - found.transpose()).norm() / (found + found.transpose()).norm();
  this->Compliance = 0.5 * (found + found.transpose());
  return this->Compliance;
}

const std::vector<double>& FiniteBody::globalCompliances() const
{
  if (this->Global.empty())
  {
    const PatchCompliances found = patchCompliances(this->Elastic, this->Points, 0.0, always);
    for (const std::int32_t point : this->Points)
    {
      this->Global.push_back(found.compliance[static_cast<std::size_t>(point)]);
    }
  }
  return this->Global;
}

double FiniteBody::globalCompliance(double x, double y) const
{
  return interpolateWindow(*this, this->globalCompliances(), x, y);
}

const std::vector<std::vector<double>>& FiniteBody::modes() const
{
  if (this->Modes.empty())
  {
    const auto total = static_cast<std::size_t>(this->Elastic.surface().pointTotal());
    PatchCompliances window;
    window.compliance.assign(total, std::numeric_limits<double>::quiet_NaN());
    window.status.assign(total, PatchStatus::Degenerate);
    for (int i = 0; i < this->windowNodes(); ++i)
    {
      const auto point = static_cast<std::size_t>(this->point(i));
      window.compliance[point] = this->globalCompliances()[static_cast<std::size_t>(i)];
      window.status[point] = PatchStatus::Valid;
    }
    const GlobalModes found = globalModes(this->Elastic, window, 0.0, MostGlobalModes, always);
    this->Signs = found.signs;
    for (const Eigen::Matrix3Xd& field : found.fields)
    {
      std::vector<double>& normal = this->Modes.emplace_back();
      for (const std::int32_t point : this->Points)
      {
        normal.push_back(field(2, point));
      }
    }
  }
  return this->Modes;
}

int FiniteBody::coarseStride() const
{
  const int half = this->Side / 2;
  int stride = std::max(1, static_cast<int>(std::lround(CoarseSpacing / this->Mesh.spacing)));
  while (half % stride != 0)
  {
    --stride;
  }
  return stride;
}

const Eigen::MatrixXd& FiniteBody::regular() const
{
  if (this->Regular.size() > 0)
  {
    return this->Regular;
  }
  const int stride = this->coarseStride();
  const int side = this->coarseSide();
  const auto node = [&](int coarse)
  { return (coarse / side) * stride * this->Side + (coarse % side) * stride; };
  const auto coarse = [&](int at)
  { return (at / this->Side) / stride * side + (at % this->Side) / stride; };
  const RegularField field(this->Elastic, 0.0);
  Eigen::MatrixXd found(side * side, side * side);
  for (int j = 0; j < side * side; ++j)
  {
    if (this->isImage(node(j)))
    {
      continue;
    }
    const Eigen::Matrix3Xd moved = field.at(this->point(node(j)));
    for (int symmetry = 0; symmetry < this->symmetries(); ++symmetry)
    {
      for (int i = 0; i < side * side; ++i)
      {
        found(coarse(this->image(node(i), symmetry)), coarse(this->image(node(j), symmetry))) =
          -moved(2, this->point(node(i)));
      }
    }
  }
  this->RegularAsymmetry = (found - found.transpose()).norm() / (found + found.transpose()).norm();
  this->Regular = 0.5 * (found + found.transpose());
  return this->Regular;
}

std::size_t FiniteBody::factorBytes() const
{
  return static_cast<std::size_t>(this->Elastic.memoryEstimate());
}

double interpolateWindow(
  const FiniteBody& body, const std::vector<double>& values, double x, double y)
{
  const double h = body.mesh().spacing;
  const double u = (x + body.mesh().window) / h;
  const double v = (y + body.mesh().window) / h;
  const int last = body.side() - 1;
  if (!(u >= 0.0 && v >= 0.0 && u <= last && v <= last))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const int i = std::min(static_cast<int>(u), last - 1);
  const int j = std::min(static_cast<int>(v), last - 1);
  const double s = u - i;
  const double t = v - j;
  const double* at = values.data() + j * body.side() + i;
  return (1.0 - t) * ((1.0 - s) * at[0] + s * at[1]) +
    t * ((1.0 - s) * at[body.side()] + s * at[body.side() + 1]);
}

WindowSurface windowSurface(const FiniteBody& body)
{
  WindowSurface surface;
  for (int i = 0; i < body.windowNodes(); ++i)
  {
    const Eigen::Vector2d at = body.position(i);
    surface.points.insert(surface.points.end(), { at.x(), at.y(), 0.0 });
  }
  for (int row = 0; row + 1 < body.side(); ++row)
  {
    for (int column = 0; column + 1 < body.side(); ++column)
    {
      const std::int32_t a = row * body.side() + column;
      const std::int32_t b = a + body.side();
      surface.triangles.insert(surface.triangles.end(), { a, a + 1, b + 1, a, b + 1, b });
    }
  }
  return surface;
}

} // namespace palpate::testing

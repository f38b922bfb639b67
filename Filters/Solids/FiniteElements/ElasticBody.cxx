// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/FiniteElements/ElasticBody.h"

#include "Mechanics/ReducedModulus.h"

#include <algorithm>
#include <sstream>
#include <utility>

namespace palpate
{
std::string ElasticBody::checkInput() const
{
  std::ostringstream text;
  if (this->Input.mesh.elements.empty())
  {
    return "the body has no cells";
  }
  for (std::size_t i = 0; i < this->Input.materials.size(); ++i)
  {
    const ElasticMaterial& material = this->Input.materials[i];
    if (!isYoungsModulus(material.youngsModulus))
    {
      text << "Young's modulus of cell " << i << " must be positive and finite (MPa), but is "
           << material.youngsModulus;
      return text.str();
    }
    if (!(material.poissonRatio >= 0.0 && material.poissonRatio <= LargestPoissonRatio))
    {
      text << "Poisson's ratio of cell " << i << " must lie between 0 and " << LargestPoissonRatio
           << " (finite elements need a compressible material), but is " << material.poissonRatio;
      return text.str();
    }
  }
  for (Eigen::Index i = 0; i < this->Input.mesh.nodes.cols(); ++i)
  {
    if (!this->Input.mesh.nodes.col(i).allFinite())
    {
      text << "point " << i << " is not finite: (" << this->Input.mesh.nodes.col(i).transpose()
           << ")";
      return text.str();
    }
  }
  return {};
}

std::string ElasticBody::take(ElasticBodyInput input)
{
  this->Input = std::move(input);
  std::string error = this->checkInput();
  if (error.empty())
  {
    error = this->Topology.build(this->Input.mesh);
  }
  if (error.empty())
  {
    error = findFloatingPart(this->Input.mesh, this->Topology, this->Input.fixed);
  }
  if (error.empty())
  {
    this->Surface = BodySurface(this->Input.mesh, this->Topology);
  }
  return error;
}

MemoryForecast ElasticBody::memoryForecast() const
{
  return forecastMemory(this->Input.mesh.nodeTotal(), this->Surface.pointTotal());
}

std::string ElasticBody::assemble()
{
  const std::string error = assembleStiffness(
    this->Input.mesh, this->Topology, this->Input.materials, this->Input.fixed, this->Stiffness);
  return error.empty() && this->unknowns() == 0 ? "every point of the body is fixed" : error;
}

std::string ElasticBody::assemble(ElasticBodyInput input)
{
  const std::string error = this->take(std::move(input));
  return error.empty() ? this->assemble() : error;
}

std::string ElasticBody::analyse(StiffnessFactor::Kind kind)
{
  this->Factor = StiffnessFactor::make(kind);
  if (!this->Factor)
  {
    return "the supernodal solver was not built: it needs CHOLMOD (SuiteSparse)";
  }
  return this->Factor->analyse(this->Stiffness.lower)
    ? std::string()
    : "the stiffness matrix of " + std::to_string(this->unknowns()) +
      " unknowns is too large: its factor does not fit the memory, or has more than 2^31 entries";
}

double ElasticBody::memoryEstimate() const
{
  return this->Factor->memoryEstimate();
}

std::string ElasticBody::factorise()
{
  return this->Factor->factorise(this->Stiffness.lower)
    ? std::string()
    : "the stiffness matrix is not positive definite, or does not fit the memory: are parts of the "
      "body connected only at a point or an edge, so that they can turn?";
}

bool ElasticBody::isUniform() const
{
  const std::vector<ElasticMaterial>& all = this->Input.materials;
  return std::all_of(all.begin(), all.end(),
    [&all](const ElasticMaterial& material) { return isAlike(material, all.front()); });
}

ElasticMaterial ElasticBody::materialAt(std::int32_t node) const
{
  if (this->Input.materials.size() == 1)
  {
    return this->Input.materials.front();
  }
  ElasticMaterial sum{ 0.0, 0.0 };
  const std::int32_t* begin = this->Topology.elementsBegin(node);
  const std::int32_t* end = this->Topology.elementsEnd(node);
  const auto count = static_cast<double>(end - begin);
  bool equal = true;
  for (const std::int32_t* e = begin; e != end; ++e)
  {
    const ElasticMaterial& material = this->Input.materials[static_cast<std::size_t>(*e)];
    sum.youngsModulus += material.youngsModulus / count;
    sum.poissonRatio += material.poissonRatio / count;
    equal = equal &&
      material.poissonRatio == this->Input.materials[static_cast<std::size_t>(*begin)].poissonRatio;
  }
  // The copy is bit-identical. This is necessary because the hashes of equal cut-outs must be
  // equal.
  if (equal && begin != end)
  {
    sum.poissonRatio = this->Input.materials[static_cast<std::size_t>(*begin)].poissonRatio;
  }
  return sum;
}

Eigen::Matrix3Xd ElasticBody::displacement(const Eigen::Matrix3Xd& forces) const
{
  Eigen::VectorXd load = Eigen::VectorXd::Zero(this->unknowns());
  const Eigen::Index nodes = this->Input.mesh.nodes.cols();
  for (Eigen::Index i = 0; i < 3 * nodes; ++i)
  {
    const int at = this->Stiffness.dof[static_cast<std::size_t>(i)];
    if (at >= 0)
    {
      load[at] = forces.data()[i];
    }
  }
  const Eigen::VectorXd solution = this->Factor->solve(load);
  Eigen::Matrix3Xd moved = Eigen::Matrix3Xd::Zero(3, nodes);
  for (Eigen::Index i = 0; i < 3 * nodes && solution.size() > 0; ++i)
  {
    const int at = this->Stiffness.dof[static_cast<std::size_t>(i)];
    moved.data()[i] = at >= 0 ? solution[at] : 0.0;
  }
  return moved;
}
} // namespace palpate

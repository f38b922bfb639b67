// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/FiniteElements/EnergyError.h"

#include "Solids/FiniteElements/ElasticElement.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
/// Elements whose moduli differ by at most this ratio are treated as one material. The stress of
/// one material is continuous at common nodes.
constexpr double SameModulus = 1.25;

/// Stress components xx, yy, zz, yz, xz, xy, at one point or at an element's nodes.
using Stress = Eigen::Matrix<double, 6, 1>;
using NodalStress = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, LargestNodeCount>;

using Places = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, LargestNodeCount>;

/// Returns the positions of an element's nodes in the element's own coordinates.
Places nodePlaces(ElementKind kind)
{
  Places places(3, nodeCount(kind));
  if (kind == ElementKind::Hexahedron)
  {
    places << -1, 1, 1, -1, -1, 1, 1, -1, //
      -1, -1, 1, 1, -1, -1, 1, 1,         //
      -1, -1, -1, -1, 1, 1, 1, 1;
    return places;
  }
  places.leftCols<4>() << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
  for (int i = 4; i < places.cols(); ++i)
  {
    const std::array<int, 2> ends = edgeOfMiddle(i);
    places.col(i) = 0.5 * (places.col(ends[0]) + places.col(ends[1]));
  }
  return places;
}

/// Quadrature points of equal weight. They are exact for polynomials of second degree.
struct Quadrature
{
  Places places;
  double weight;
};

Quadrature quadratureOf(ElementKind kind)
{
  if (kind == ElementKind::Hexahedron)
  {
    return { nodePlaces(kind) / std::sqrt(3.0), 1.0 };
  }
  const double a = (5.0 - std::sqrt(5.0)) / 20.0;
  Places places = Places::Constant(3, 4, a);
  places.rightCols<3>().diagonal().setConstant(1.0 - 3.0 * a);
  return { places, 1.0 / 24.0 };
}

using Gradient = Eigen::Matrix3d; ///< gradient of a displacement in space

/// Computes the stress of an element for any displacement.
class ElementStress
{
public:
  ElementStress(const ElasticBody& body, std::int32_t element)
    : Element(body.mesh().elements[static_cast<std::size_t>(element)])
    , Nodes(elementNodes(body.mesh(), this->Element))
    , Material(body.material(element))
  {
    if (this->Element.kind == ElementKind::Hexahedron)
    {
      this->Modes = modesOfNodes(this->Nodes, this->Material);
    }
  }

  ElementKind kind() const { return this->Element.kind; }

  /// Displacements of the element's nodes, followed by the amplitudes of its modes.
  using Motion = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 11>;
  Motion motion(const Eigen::Matrix3Xd& displacement) const
  {
    const bool hasModes = this->Element.kind == ElementKind::Hexahedron;
    Motion moved(3, this->Nodes.cols() + (hasModes ? 3 : 0));
    for (Eigen::Index i = 0; i < this->Nodes.cols(); ++i)
    {
      moved.col(i) = displacement.col(this->Element.nodes[static_cast<std::size_t>(i)]);
    }
    if (hasModes)
    {
      const Eigen::Map<const Eigen::Matrix<double, 24, 1>> ofNodes(moved.data());
      Eigen::Map<Eigen::Matrix<double, 9, 1>>(moved.data() + 24) = this->Modes * ofNodes;
    }
    return moved;
  }

  /// Computes the gradients of the shape functions and modes at a position. Returns the determinant
  /// of the Jacobian.
  double gradients(const Eigen::Vector3d& place, ElementGradients& found) const
  {
    return elementGradients(this->Element.kind, this->Nodes, place, found);
  }

  Stress stress(const Motion& moved, const ElementGradients& gradients) const
  {
    const Gradient gradient = moved * gradients.transpose();
    const double nu = this->Material.poissonRatio;
    const double shear = this->Material.youngsModulus / (2.0 * (1.0 + nu));
    const double dilation = 2.0 * shear * nu / (1.0 - 2.0 * nu) * gradient.trace();
    Stress stress;
    stress << dilation + 2.0 * shear * gradient(0, 0), dilation + 2.0 * shear * gradient(1, 1),
      dilation + 2.0 * shear * gradient(2, 2), shear * (gradient(1, 2) + gradient(2, 1)),
      shear * (gradient(0, 2) + gradient(2, 0)), shear * (gradient(0, 1) + gradient(1, 0));
    return stress;
  }

  /// Returns σ : D⁻¹ : σ, N/mm².
  double density(const Stress& stress) const
  {
    const double trace = stress.head<3>().sum();
    const double all = stress.head<3>().squaredNorm() + 2.0 * stress.tail<3>().squaredNorm();
    const double nu = this->Material.poissonRatio;
    return ((1.0 + nu) * all - nu * trace * trace) / this->Material.youngsModulus;
  }

private:
  const VolumeElement& Element;
  ElementNodes Nodes;
  ElasticMaterial Material;
  Eigen::Matrix<double, 9, 24> Modes;
};

/// Groups the elements with nearly equal moduli at each node, because stress is continuous within a
/// group. Stores the number of the group for each node of each element.
class SharedNodes
{
public:
  explicit SharedNodes(const ElasticBody& body)
    : Places(body.mesh().elements.size())
  {
    std::vector<std::vector<std::pair<double, std::int32_t>>> atNode(
      static_cast<std::size_t>(body.mesh().nodeTotal()));
    for (std::size_t e = 0; e < this->Places.size(); ++e)
    {
      const VolumeElement& element = body.mesh().elements[e];
      const double modulus = body.material(static_cast<std::int32_t>(e)).youngsModulus;
      for (std::size_t i = 0; i < static_cast<std::size_t>(nodeCount(element.kind)); ++i)
      {
        auto& here = atNode[static_cast<std::size_t>(element.nodes[i])];
        const auto same = std::find_if(here.begin(), here.end(),
          [modulus](const std::pair<double, std::int32_t>& place) {
            return std::max(place.first, modulus) <= SameModulus * std::min(place.first, modulus);
          });
        if (same == here.end())
        {
          here.emplace_back(modulus, this->Total);
          this->Places[e][i] = this->Total++;
        }
        else
        {
          this->Places[e][i] = same->second;
        }
      }
    }
  }

  Eigen::Index total() const { return this->Total; }
  Eigen::Index place(std::int32_t element, Eigen::Index node) const
  {
    return this->Places[static_cast<std::size_t>(element)][static_cast<std::size_t>(node)];
  }

private:
  std::vector<std::array<std::int32_t, LargestNodeCount>> Places;
  std::int32_t Total = 0;
};
} // namespace

std::vector<double> energyErrors(
  const ElasticBody& body, const std::vector<Eigen::Matrix3Xd>& displacements)
{
  const SharedNodes shared(body);
  const std::size_t count = displacements.size();
  std::vector<Eigen::Matrix<double, 6, Eigen::Dynamic>> means(
    count, Eigen::Matrix<double, 6, Eigen::Dynamic>::Zero(6, shared.total()));
  Eigen::VectorXd elementsAt = Eigen::VectorXd::Zero(shared.total());
  ElementGradients gradients;
  for (std::int32_t e = 0; e < body.mesh().elementTotal(); ++e)
  {
    const ElementStress element(body, e);
    const Places places = nodePlaces(element.kind());
    std::vector<ElementStress::Motion> motions;
    motions.reserve(count);
    for (const Eigen::Matrix3Xd& displacement : displacements)
    {
      motions.push_back(element.motion(displacement));
    }
    for (Eigen::Index i = 0; i < places.cols(); ++i)
    {
      element.gradients(places.col(i), gradients);
      elementsAt[shared.place(e, i)] += 1.0;
      for (std::size_t k = 0; k < count; ++k)
      {
        means[k].col(shared.place(e, i)) += element.stress(motions[k], gradients);
      }
    }
  }
  for (auto& mean : means)
  {
    mean.array().rowwise() /= elementsAt.transpose().array();
  }
  std::vector<double> sums(count, 0.0);
  for (std::int32_t e = 0; e < body.mesh().elementTotal(); ++e)
  {
    const ElementStress element(body, e);
    const Quadrature quadrature = quadratureOf(element.kind());
    for (std::size_t k = 0; k < count; ++k)
    {
      const ElementStress::Motion moved = element.motion(displacements[k]);
      NodalStress smooth(6, nodeCount(element.kind()));
      for (Eigen::Index i = 0; i < smooth.cols(); ++i)
      {
        smooth.col(i) = means[k].col(shared.place(e, i));
      }
      for (Eigen::Index q = 0; q < quadrature.places.cols(); ++q)
      {
        const Eigen::Vector3d place = quadrature.places.col(q);
        const double jacobian = element.gradients(place, gradients);
        const Stress step =
          smooth * elementShapes(element.kind(), place) - element.stress(moved, gradients);
        sums[k] += quadrature.weight * jacobian * element.density(step);
      }
    }
  }
  return sums;
}
} // namespace palpate

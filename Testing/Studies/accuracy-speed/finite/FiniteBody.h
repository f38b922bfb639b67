// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Solids/FiniteElements/ElasticBody.h"
#include "FiniteScene.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace palpate::testing
{

/**
 * A scene's body, meshed and factorised, and the nodes of its window: a square grid of
 * side() × side() nodes, node i at coordinate(i % side()), coordinate(i / side()).
 *
 * What costs time is made when first asked for (not thread-safe), and then shared by all methods.
 */
class FiniteBody
{
public:
  /// Throws std::runtime_error with what is wrong.
  static std::shared_ptr<const FiniteBody> make(const FiniteScene& scene, const FiniteMesh& mesh);

  const FiniteScene& scene() const { return this->Scene; }
  const FiniteMesh& mesh() const { return this->Mesh; }
  const ElasticBody& elastic() const { return this->Elastic; }

  int side() const { return this->Side; }
  int windowNodes() const { return this->Side * this->Side; }
  double coordinate(int i) const { return -this->Mesh.window + i * this->Mesh.spacing; }
  Eigen::Vector2d position(int node) const
  {
    return { this->coordinate(node % this->Side), this->coordinate(node / this->Side) };
  }
  /// The surface point of elastic() of a window node.
  std::int32_t point(int node) const { return this->Points[static_cast<std::size_t>(node)]; }
  /**
   * The symmetries of the body, as they map window nodes: bit 0 mirrors x, bit 1 mirrors y, bit 2
   * swaps x and y (square bodies on a base only). symmetries() is how many there are, 4 or 8.
   */
  int image(int node, int symmetry) const;
  int symmetries() const;

  /// How far from the axis, along x and y, a tip with contact radius a may go, mm.
  double reach(double contactRadius) const
  {
    return this->Mesh.window - contactRadius - this->Mesh.spacing;
  }

  /// Inward motion (mm) of the window nodes under inward forces (N) on them, by a full solution.
  Eigen::VectorXd solve(const Eigen::VectorXd& forces) const;

  /// Inward motion of window node i per force on j, mm/N; symmetric.
  const Eigen::MatrixXd& compliance() const;
  /// |C - Cᵀ| / |C + Cᵀ| of that matrix before it was made symmetric; Betti would have 0.
  double asymmetry() const { return this->Asymmetry; }

  /// C_g at each window node, mm/N (PatchCompliance).
  const std::vector<double>& globalCompliances() const;
  /// Between nodes bilinear; NaN outside the window.
  double globalCompliance(double x, double y) const;

  /// n·φ_k of each mode at each window node (GlobalModes), and their signs: C_g ≈ Σ s_k (n·φ_k)².
  const std::vector<std::vector<double>>& modes() const;
  const std::vector<int>& modeSigns() const { return this->Signs; }

  /**
   * The regular part H of the Green function: inward motion of coarse node i per inward force at j,
   * less the dent of a half-space (RegularField), mm/N, made symmetric. Coarse nodes are every
   * coarseStride()-th one of the window along x and y, about 1 mm apart.
   */
  const Eigen::MatrixXd& regular() const;
  int coarseStride() const;
  int coarseSide() const { return (this->Side - 1) / this->coarseStride() + 1; }
  /// |H - Hᵀ| / |H + Hᵀ| before that; Betti would have 0.
  double regularAsymmetry() const { return this->RegularAsymmetry; }

  /// Bytes of the factor and of what its making takes: an upper limit of what a solution reads.
  std::size_t factorBytes() const;

private:
  FiniteBody() = default;
  /// Whether what belongs to the node is found from another by symmetry.
  bool isImage(int node) const;

  FiniteScene Scene;
  FiniteMesh Mesh;
  ElasticBody Elastic;
  int Side = 0;
  std::vector<std::int32_t> Points;
  mutable Eigen::MatrixXd Compliance;
  mutable double Asymmetry = 0.0;
  mutable Eigen::MatrixXd Regular;
  mutable double RegularAsymmetry = 0.0;
  mutable std::vector<double> Global;
  mutable std::vector<std::vector<double>> Modes;
  mutable std::vector<int> Signs;
};

/// Bilinear in the window, one value per window node; NaN outside.
double interpolateWindow(
  const FiniteBody& body, const std::vector<double>& values, double x, double y);

/// The window as a surface, for the methods that need one: z = 0, normal +z.
struct WindowSurface
{
  std::vector<double> points;          ///< x, y, z by window node
  std::vector<std::int32_t> triangles; ///< counter-clockwise seen from outside
};
WindowSurface windowSurface(const FiniteBody& body);

} // namespace palpate::testing

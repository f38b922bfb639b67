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
 * A scene's body, meshed and factorised, and the nodes of its window: a square grid of side() ×
 * side() nodes, node i at coordinate(i % side()), coordinate(i / side()).
 * Expensive data are computed at the first use (not thread-safe) and then shared by all methods.
 */
class FiniteBody
{
public:
  /// Throws std::runtime_error with the reason.
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
  /// Number of a window node as a surface point of elastic().
  std::int32_t point(int node) const { return this->Points[static_cast<std::size_t>(node)]; }
  /**
   * The image of a window node under a symmetry of the body: bit 0 mirrors x, bit 1 mirrors y, bit
   * 2 swaps x and y (square bodies on a base only). symmetries() is their number, 4 or 8.
   */
  int image(int node, int symmetry) const;
  int symmetries() const;

  /// Largest distance from the axis, along x and y, for a tip with contact radius a, mm.
  double reach(double contactRadius) const
  {
    return this->Mesh.window - contactRadius - this->Mesh.spacing;
  }

  /// Inward motion (mm) of the window nodes under inward forces (N) on them. Solves the whole body.
  Eigen::VectorXd solve(const Eigen::VectorXd& forces) const;

  /// Inward motion of window node i per force on j, mm/N; symmetric.
  const Eigen::MatrixXd& compliance() const;
  /// |C - Cᵀ| / |C + Cᵀ| of that matrix before it was made symmetric; exactly 0 by Betti's theorem.
  double asymmetry() const { return this->Asymmetry; }

  /// C_g at each window node, mm/N (PatchCompliance).
  const std::vector<double>& globalCompliances() const;
  /// Bilinear interpolation between nodes; NaN outside the window.
  double globalCompliance(double x, double y) const;

  /// n·φ_k of each mode at each window node (GlobalModes), and their signs: C_g ≈ Σ s_k (n·φ_k)².
  const std::vector<std::vector<double>>& modes() const;
  const std::vector<int>& modeSigns() const { return this->Signs; }

  /**
   * The regular part H of the Green function: inward motion of coarse node i per inward force at j,
   * minus the dent of a half-space (RegularField), mm/N, made symmetric. Coarse nodes are every
   * coarseStride()-th one of the window along x and y, about 1 mm apart.
   */
  const Eigen::MatrixXd& regular() const;
  int coarseStride() const;
  int coarseSide() const { return (this->Side - 1) / this->coarseStride() + 1; }
  /// |H - Hᵀ| / |H + Hᵀ| before H was made symmetric; exactly 0 by Betti's theorem.
  double regularAsymmetry() const { return this->RegularAsymmetry; }

  /// Bytes of the factor and of its computation: an upper bound of the bytes that a solution reads.
  std::size_t factorBytes() const;

private:
  FiniteBody() = default;
  /// True if the data of the node follow from another node by symmetry.
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

/// Bilinear interpolation of one value per window node; NaN outside the window.
double interpolateWindow(
  const FiniteBody& body, const std::vector<double>& values, double x, double y);

/// The window as a surface, for methods that need one: z = 0, normal +z.
struct WindowSurface
{
  std::vector<double> points;          ///< x, y, z by window node
  std::vector<std::int32_t> triangles; ///< counter-clockwise seen from outside
};
WindowSurface windowSurface(const FiniteBody& body);

} // namespace palpate::testing

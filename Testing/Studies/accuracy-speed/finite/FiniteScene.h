// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <string>

namespace palpate::testing
{

/// Support of a block.
enum class Support
{
  Base, ///< the bottom face, bonded
  Edges ///< the end faces x = ±size/2, held along z only, free to rotate
};

/// A block about the z axis under z = 0, of one material; mm, MPa.
struct FiniteScene
{
  std::string name;
  Eigen::Vector3d size;
  Support support = Support::Base;
  double reducedModulus = 1.0; ///< E* = E/(1-ν²)
  double poissonRatio = 0.3;
  double growth =
    1.3; ///< size ratio of neighbouring elements away from the window and from the top

  double youngsModulus() const;
};

/// The paper's rubber (E* = 3.45 MPa, ν = 0.45 as in the CalculiX study) as a plate 60 × 40 × 6 mm
/// supported on its two short ends. Its global deflection is large.
FiniteScene finitePlate();
/// A block of this rubber, so deep and wide that it is a half-space for a tool of some mm.
FiniteScene finiteBlock();
/// A layer of this rubber on a rigid base.
FiniteScene finiteLayer(double thickness = 10.0);

/// Element sizes of a body, mm.
struct FiniteMesh
{
  double spacing = 0.5; ///< size of the elements in the window and on the top; divides the window
  double window = 8.0;  ///< a tool may press at |x|, |y| <= window
  double largest = 2.0; ///< largest element of a plate, which bends as a whole

  /// A coarse and small mesh, for tests.
  static FiniteMesh quick() { return { 1.0, 6.0, 2.0 }; }
  /// The mesh for finiteReference().
  static FiniteMesh reference() { return { 0.5, 8.0, 1.0 }; }
};

} // namespace palpate::testing

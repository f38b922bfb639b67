// SPDX-License-Identifier: BSD-3-Clause
#ifndef SteeredHand_h
#define SteeredHand_h

#include <array>

class vtkRenderer;

namespace palpate
{
/// The tilt of a tool steered by a mouse, relative to the picture.
class SteeredTilt
{
public:
  static constexpr double Largest = 60.0; ///< degrees
  static constexpr double PerNotch = 2.5; ///< of a wheel, or a key; degrees

  /// To the right and away from the viewer, degrees; no more than Largest either way.
  void set(double right, double away);
  void lean(double right, double away) { this->set(this->Right + right, this->Away + away); }
  double right() const { return this->Right; }
  double away() const { return this->Away; }

  /// Whether a tilt was ever set: until then the axis is the surface's normal.
  bool isTold() const { return this->IsTold; }
  /// The axis, unit, from the tip up the shaft, of a tool on a surface with this outward normal;
  /// without a renderer to the right of x and away along y.
  std::array<double, 3> axis(const double normal[3], vtkRenderer* renderer) const;

private:
  double Right = 0.0;
  double Away = 0.0;
  bool IsTold = false;
};

/// The state of a hand steered by a mouse, kept while the mouse steers another.
struct SteeredHand
{
  SteeredTilt tilt;
  double wheelDepth = 0.0;           ///< mm
  double tip[3] = { 0.0, 0.0, 0.0 }; ///< where it was steered to, mm
};
} // namespace palpate

#endif

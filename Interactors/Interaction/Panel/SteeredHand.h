// SPDX-License-Identifier: BSD-3-Clause
#ifndef SteeredHand_h
#define SteeredHand_h

#include <array>

class vtkRenderer;

namespace palpate
{
/// The tilt of a tool that is steered by the mouse, relative to the picture.
class SteeredTilt
{
public:
  static constexpr double Largest = 60.0; ///< degrees
  static constexpr double PerNotch = 2.5; ///< degrees per notch of the wheel and per key press

  /// Sets the tilt to the right and the tilt away from the viewer, degrees. Each is limited to
  /// ±Largest.
  void set(double right, double away);
  void lean(double right, double away) { this->set(this->Right + right, this->Away + away); }
  double right() const { return this->Right; }
  double away() const { return this->Away; }

  /// Whether a tilt has been set. If no tilt has been set, the axis is the normal of the surface.
  bool isSet() const { return this->IsSet; }
  /// Returns the axis of a tool on a surface with this outward normal: a unit vector from the tip
  /// towards the hand. Without a renderer, "right" is along x and "away" is along y.
  std::array<double, 3> axis(const double normal[3], vtkRenderer* renderer) const;

private:
  double Right = 0.0;
  double Away = 0.0;
  bool IsSet = false;
};

/// State of a hand that the mouse steers. The state is kept while the mouse steers another hand.
struct SteeredHand
{
  SteeredTilt tilt;
  double wheelDepth = 0.0;           ///< mm
  double tip[3] = { 0.0, 0.0, 0.0 }; ///< last point to which the tip was steered, mm

  /// Whether the tip was steered to a point on the surface. The following members give this point.
  bool touches = false;
  double point[3] = { 0.0, 0.0, 0.0 };
  double normal[3] = { 0.0, 0.0, 1.0 };
  double height = 0.0; ///< height of the tip above the point, mm
};
} // namespace palpate

#endif

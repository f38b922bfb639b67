// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TiltedSurface_h
#define palpate_TiltedSurface_h

namespace palpate
{
class AxisymmetricTool;

/// A rectangle of the body's surface, mm. x is perpendicular to the axis of tilt, from the tip
/// towards the lowered side; the rectangle is symmetric in y.
struct SurfaceBox
{
  double left;
  double right;
  double halfWidth;
};

/// The lower side of a tool tilted by θ about y, relative to the plane through its deepest point.
class TiltedSurface
{
public:
  /// `tool` must outlive the surface.
  TiltedSurface(const AxisymmetricTool& tool, double angle);

  /// Returns the height of the tool above the plane at (x, y), mm; +inf if it exceeds `limit`.
  double heightAt(double x, double y, double limit) const;
  /// Returns the smallest box found that contains all points at which the height is less than
  /// `limit`.
  SurfaceBox below(double limit) const;

private:
  double insideAt(double x, double y, double z) const;

  const AxisymmetricTool& Tool;
  double Sine;
  double Cosine;
  double Drop;
  double Deepest = 0.0; ///< distance of the deepest point from the axis
};
} // namespace palpate

#endif

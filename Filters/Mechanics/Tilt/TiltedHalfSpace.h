// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TiltedHalfSpace_h
#define palpate_TiltedHalfSpace_h

#include "Mechanics/PalpateExport.h"
#include "Mechanics/Tilt/CubicSpline.h"
#include "Mechanics/Tilt/TiltBody.h"
#include "Mechanics/Tilt/TiltGeometry.h"
#include "Mechanics/Tools/AxisymmetricTool.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace palpate
{
/**
 * One tool on a half-space, upright or tilted up to a largest tilt. The equivalent profiles of the
 * tool (TiltedTool.h) are also used for layers.
 *
 * The object stores τ = W(D, θ)/W(D, 0), whose derivatives determine force and contact radius. The
 * work is stored, because the work of boundary elements is smoother than their force. τ is 1 for
 * spheres and has a closed form for flat ends (TiltedFlat.h). For cones, which have no length, it
 * depends only on the angle. Other tools are solved (TiltedContact.h) at about thirteen depths and
 * angles; blunted cones only at depths at which more than the tip touches.
 *
 * Splines over θ and ln D interpolate τ^-1.2. For a sampled profile, whose facets touch the body
 * one after the other, they interpolate ln τ; for a tool with a flat end, τ divided by the τ of the
 * flat end. Compared with boundary elements between all nodes the error is 1e-3, for flat ends 3e-3
 * (TiltNodesTest.cxx).
 *
 * Cost: 1 to 4 s on all threads for a tool that is solved, otherwise negligible; 0.1 ms for
 * equivalent(). The result is bit for bit the same for any number of threads.
 */
class PALPATE_EXPORT TiltedHalfSpace
{
public:
  /// Solves from `depth`/256 to `depth` (mm, within the limit of the tool), up to a tilt `largest`
  /// (rad) for which checkTilt reports no fault. `tool` must outlive this object.
  TiltedHalfSpace(const AxisymmetricTool& tool, double depth, double largest);

  /// Returns the equivalent profile of the tilted tool, as a function of the depth of its deepest
  /// point. The result may be the tool itself. It is valid slightly beyond the largest tilt.
  std::shared_ptr<const AxisymmetricTool> equivalent(double angle) const;

  /// Returns the results on the half-space, without using an equivalent profile.
  TiltWork pressed(double depth, double angle) const;

  const AxisymmetricTool& tool() const { return this->Tool; }
  const ToolDrop& drop() const { return this->Drop; }
  /// κ, see TiltTerms::dropScale.
  double dropScale() const { return this->DropScale; }

private:
  enum class Kind
  {
    Sphere,
    Flat,
    ScaleFree, ///< one depth suffices
    Solved
  };
  struct Row
  {
    double depth;
    CubicSpline works; ///< splines over the tilt
  };

  /// The upright tool at one depth.
  struct Upright
  {
    double depth;
    TiltWork at;
  };

  void solveRows(double depth);
  CubicSpline over(double angle) const;
  TiltWork workOf(const Upright& upright, const CubicSpline& stored, double angle) const;
  double rimRatio(double depth, double angle) const;
  std::shared_ptr<const AxisymmetricTool> flat(double angle) const;
  std::shared_ptr<const AxisymmetricTool> fromRows(double angle) const;

  const AxisymmetricTool& Tool;
  ToolDrop Drop;
  double DropScale;
  Kind Is = Kind::Solved;
  bool IsFaceted = false; ///< the splines interpolate ln τ, not τ^-1.2
  std::vector<Row> Rows;
  std::vector<Upright> Uprights; ///< upright tool at each depth, the deepest first
};
} // namespace palpate

#endif

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
 * One tool on a half-space at any tilt up to a largest one, and so, by its equivalent profiles
 * (TiltedTool.h), on layers.
 *
 * Kept is τ = W(D, θ)/W(D, 0), whose derivatives have force and contact in them; boundary elements
 * have the work smoother than the force. Of spheres τ is 1, of flat ends closed (TiltedFlat.h), of
 * cones, which have no length, a function of the angle; all others are solved for (TiltedContact.h)
 * at some thirteen depths and angles, of blunted cones where the tip does not touch alone. Splined
 * over θ and over ln D is τ^-1.2, of a sampled profile, whose facets lie on the body one after the
 * other, ln τ, of a tool with a flat end τ over that of the flat end. Against
 * boundary elements between all nodes: 1e-3, flat ends 3e-3 (TiltNodesTest.cxx).
 *
 * Cost: 1 to 4 s of a tool that is solved for, on all threads, else nothing to speak of; of
 * equivalent() 0.1 ms. Same bits whatever the threads.
 */
class PALPATE_EXPORT TiltedHalfSpace
{
public:
  /// From `depth`/256 to `depth` (mm, within the tool's own limit), up to a tilt (rad) that
  /// checkTilt finds nothing wrong with. `tool` must outlive this.
  TiltedHalfSpace(const AxisymmetricTool& tool, double depth, double largest);

  /// What a half-space takes the tilted tool for, pressed D of its deepest point. May be the tool
  /// itself. Up to a little more than the largest tilt.
  std::shared_ptr<const AxisymmetricTool> equivalent(double angle) const;

  /// The half-space itself, without the detour over a profile.
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
    ScaleFree, ///< one depth tells all
    Solved
  };
  struct Row
  {
    double depth;
    CubicSpline works; ///< over the tilt
  };

  /// The tool upright at one depth.
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
  bool IsFaceted = false; ///< so that ln τ is splined, not τ^-1.2
  std::vector<Row> Rows;
  std::vector<Upright> Uprights; ///< from the deepest on
};
} // namespace palpate

#endif

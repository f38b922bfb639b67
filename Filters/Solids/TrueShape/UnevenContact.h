// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_UnevenContact_h
#define palpate_UnevenContact_h

#include "Mechanics/PalpateExport.h"
#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Solids/TrueShape/SurfaceGap.h"

namespace palpate
{
/**
 * Contacts of an axisymmetric tool with a half-space whose surface has any shape around the axis.
 * The pressure is uniform on square cells (Love 1929). For a given force, it is computed by
 * conjugate gradients on the cells in contact (Polonsky and Keer 1999). Friction is not included,
 * and slopes are assumed to be small.
 *
 * The result is the difference from the contact with the mean surface, which is the mean over
 * angles. Both contacts are solved on the same cells. Therefore most of the error of the cells
 * cancels.
 *
 * One object is used for one tool at one point. The solution of each contact starts with the
 * pressures of the previous contact. The object is not thread-safe. Cost: 0.1 ms per contact.
 */
class PALPATE_EXPORT UnevenContact
{
public:
  /// Tool and gap must outlive this object.
  UnevenContact(const AxisymmetricTool& tool, const SurfaceGap& gap);

  struct Change
  {
    /// Difference of δ from the contact with the mean surface under the same force, mm.
    double deflection = 0.0;
    /// Mean square slope of the deviation from the mean surface under the contact.
    double steepness = 0.0;
    bool isInside = true; ///< whether the surface is known all around the contact
  };

  /// Solves the contact under the load `load`, which is F/E* in mm², > 0. `radius` is the contact
  /// radius on the mean surface, mm.
  Change at(double radius, double load);

private:
  /// Returns the gap between the tool and the mean surface at first touch, mm. It is +inf where the
  /// surface is not known.
  double meanGap(double r) const;

  const AxisymmetricTool& Tool;
  double Reach;
  SurfaceGap::Spectrum Heights;
  Eigen::Vector2d Middle = Eigen::Vector2d::Zero(); ///< middle of the previous contact, mm
  /// Pressures of the previous contact with the uneven surface.
  Eigen::VectorXf OnShape;
  Eigen::VectorXf OnMean;
};
} // namespace palpate

#endif

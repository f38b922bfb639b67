// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_UnevenContact_h
#define palpate_UnevenContact_h

#include "Mechanics/PalpateExport.h"
#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Solids/TrueShape/SurfaceGap.h"

namespace palpate
{
/**
 * Contacts of an axisymmetric tool with a half-space whose surface has any shape around the axis:
 * uniform pressures on square cells (Love 1929), found for a given force by conjugate gradients on
 * the cells that touch (Polonsky and Keer 1999). Frictionless, small slopes.
 *
 * It tells how that contact differs from the one with the angle mean of the surface, which the same
 * cells solve, so that most of what cells do to a contact is in neither.
 *
 * One tool at one place, contact after contact, each from the pressures of the one before; not
 * shared by threads. Cost: 0.1 ms a contact.
 */
class PALPATE_EXPORT UnevenContact
{
public:
  /// Both must outlive it.
  UnevenContact(const AxisymmetricTool& tool, const SurfaceGap& gap);

  struct Change
  {
    double deflection = 0.0; ///< deeper, under the same force, than on the mean surface; mm
    double steepness = 0.0;  ///< mean square slope, under the contact, of what is not the mean
    bool isInside = true;    ///< the surface is known all around the contact
  };

  /// Of the contact under `load`, F/E* in mm², > 0, whose radius on the mean surface is `radius`,
  /// mm.
  Change at(double radius, double load);

private:
  /// Between tool and mean surface at first touch; +inf where there is none or it is not known.
  double meanGap(double r) const;

  const AxisymmetricTool& Tool;
  double Reach;
  SurfaceGap::Spectrum Heights;
  Eigen::Vector2d Middle = Eigen::Vector2d::Zero(); ///< of the contact before, mm
  Eigen::VectorXf OnShape;                          ///< its pressures
  Eigen::VectorXf OnMean;
};
} // namespace palpate

#endif

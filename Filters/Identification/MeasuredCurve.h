// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MeasuredCurve_h
#define palpate_MeasuredCurve_h

#include "Mechanics/Tools/ToolSpecification.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace palpate
{
/// The phase of the test in which a reading was taken.
enum class CurvePhase
{
  Unknown,
  Loading,
  Unloading,
  Hold
};

/**
 * The readings of one tool at one site, in the order of measurement. They may contain several
 * loadings.
 *
 * Deflection (mm) and force (N) are positive into the body. The origin of the deflection is that of
 * the instrument; the depth of first contact is determined later (BodyIdentification.h).
 */
struct MeasuredCurve
{
  std::string site;
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< mm
  std::vector<double> deflection;
  std::vector<double> force;
  std::vector<double> time;      ///< s, never decreasing; empty if it was not recorded
  std::vector<CurvePhase> phase; ///< empty if it was not recorded
};

/// The curves of one tool, as in a file.
struct MeasuredCurves
{
  std::string file;
  ToolSpecification tool;
  std::string toolText;  ///< text of the tool in the file
  std::string synthetic; ///< description of how the curves were computed; empty for measured curves
  std::vector<MeasuredCurve> curves;
};
} // namespace palpate

#endif

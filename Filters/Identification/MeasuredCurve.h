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
 * Deflection (mm) and force (N) are > 0 into the body. The origin of the deflection is that of the
 * instrument; the contact point is determined later (BodyIdentification.h).
 */
struct MeasuredCurve
{
  std::string site;
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< mm
  std::vector<double> deflection;
  std::vector<double> force;
  std::vector<double> time;      ///< s, never decreasing; empty: not recorded
  std::vector<CurvePhase> phase; ///< empty: not recorded
};

/// The curves of one tool, as in a file.
struct MeasuredCurves
{
  std::string file;
  ToolSpecification tool;
  std::string toolText;  ///< text of the tool in the file
  std::string synthetic; ///< method by which computed curves were made; empty for measured curves
  std::vector<MeasuredCurve> curves;
};
} // namespace palpate

#endif

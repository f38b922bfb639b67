// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * Finds the compliance of a whole body from its closed surface. This compliance acts in series with
 * the law of a tool on a half-space. The module Solids computes the compliance.
 */
#ifndef BodyYield_h
#define BodyYield_h

#include "palpateResponseModule.h" // For export macro

#include "Mechanics/Files/ModuleFile.h"

#include <functional>
#include <string>
#include <vector>

class vtkPolyData;

namespace palpate
{
/// Input of findYield in addition to the surface: material, support and mesh of the body. See
/// vtkBodyCompliance.
struct YieldRequest
{
  double youngsModulus = 0.1; ///< MPa
  double poissonRatio = 0.45;
  double radius = 2.0; ///< contact radius for which the compliance is computed, mm
  /// Value of FixedFaces. If it is "", the body is held at the side on which it rests most stably.
  std::string fixed;
  int cells = 12000; ///< approximate upper limit of the number of finite elements
};

/// Name of the array of compliances that attachYield() attaches.
constexpr const char* FoundCompliance = "GlobalCompliance";

/// Largest Poisson's ratio of the finite elements.
constexpr double LargestYieldRatio = 0.499;

/// The compliance of a body at the points of its surface.
struct BodyYield
{
  std::vector<double> compliance;    ///< mm/N; empty after an abort
  std::vector<double> error;         ///< mm/N, >= 0
  std::vector<unsigned char> status; ///< 0 at a point with a known compliance
  /// Motion of the surface under a force (GlobalModes.h). `modes` contains one mode after another,
  /// with 3 numbers per point, in sqrt(mm/N). `signs` contains the sign of each mode. Only displays
  /// use the motion.
  std::vector<float> modes;
  std::vector<signed char> signs;
  std::string heldAt;                ///< sides of the body at which it is held
  std::vector<std::string> warnings; ///< descriptions of repairs of the surface
};

/// Functions of the module Solids that the library Response calls (ModuleFile.h).
struct YieldModule : ModuleTable
{
  std::string (*find)(vtkPolyData* body, const YieldRequest& request,
    const std::function<bool(double)>& goOn, BodyYield& made);
};

/// Computes the compliance of a body. The body must be the body() of a SoundBody. `made` is empty
/// if `goOn(fraction of the work)` returned false. Returns "" or an error message. An error occurs
/// if the module is missing, or if the body cannot be filled with elements or held. Cost: see
/// vtkBodyCompliance.
PALPATERESPONSE_EXPORT std::string findYield(vtkPolyData* body, const YieldRequest& request,
  const std::function<bool(double)>& goOn, BodyYield& made);

/// Returns whether the compliance `found` makes a law more accurate. `found` is the result of
/// `request`.
///
/// The compliance makes a law more accurate if its error is small over half of the area where the
/// compliance is known at all corners of the triangles. An error is small if it is below half of
/// the compliance, or below a quarter of the total compliance of a contact with the radius of the
/// request. The error is large on a mesh of few large triangles, whose corners yield much and whose
/// faces yield little.
PALPATERESPONSE_EXPORT bool isAccurate(
  const BodyYield& found, vtkPolyData* body, const YieldRequest& request);

/// Attaches the members of `found` to the body from which it was computed. The arrays are
/// `GlobalCompliance` and `GlobalComplianceError` (double, mm/N), `ComplianceStatus` (uint8),
/// `GlobalMode0`... (float 3, sqrt(mm/N)) and the field array `GlobalModeSign`.
PALPATERESPONSE_EXPORT void attachYield(const BodyYield& found, vtkPolyData* body);
} // namespace palpate

#endif

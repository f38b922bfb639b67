// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * Finds the compliance of a whole body from its closed surface. This compliance is in series with
 * the law of a tool on a half-space. The module Solids computes it.
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
  double radius = 2.0; ///< radius of the contact for which the compliance is computed, mm
  std::string fixed;   ///< FixedFaces; "": the side on which the body rests most stably
  int cells = 12000;   ///< approximate upper limit of the number of finite elements
};

/// Name of the array that attachYield() attaches.
constexpr const char* FoundCompliance = "GlobalCompliance";

/// Largest Poisson's ratio of the finite elements.
constexpr double LargestYieldRatio = 0.499;

/// The compliance of a body at the points of its surface.
struct BodyYield
{
  std::vector<double> compliance;    ///< mm/N; empty after an abort
  std::vector<double> error;         ///< mm/N, >= 0
  std::vector<unsigned char> status; ///< 0: the compliance is known
  /// Motion of the surface under a force (GlobalModes.h). `modes`: one mode after another, 3
  /// numbers per point, sqrt(mm/N). `signs`: the sign of each mode. Used by displays only.
  std::vector<float> modes;
  std::vector<signed char> signs;
  std::string heldAt;                ///< the sides at which the body is held
  std::vector<std::string> warnings; ///< repairs of the surface
};

/// Functions of the module Solids that the library Response calls (ModuleFile.h).
struct YieldModule : ModuleTable
{
  std::string (*find)(vtkPolyData* body, const YieldRequest& request,
    const std::function<bool(double)>& goOn, BodyYield& made);
};

/// Finds the compliance of a body, which must be the body() of a SoundBody. `made` is empty if
/// `goOn(fraction of the work)` returned false. Returns "" or an error message: the module is
/// missing, or the body cannot be filled or held. Cost: see vtkBodyCompliance.
PALPATERESPONSE_EXPORT std::string findYield(vtkPolyData* body, const YieldRequest& request,
  const std::function<bool(double)>& goOn, BodyYield& made);

/// Whether the compliance makes a law more accurate. It does not on a mesh of few large triangles,
/// whose corners yield much and whose faces yield little. It does if its error is small over half
/// of the area where it is known at all corners: below half of the compliance, or a quarter of the
/// deflection of a contact with the radius of the request. `found` is the result of `request`.
PALPATERESPONSE_EXPORT bool isAccurate(
  const BodyYield& found, vtkPolyData* body, const YieldRequest& request);

/// Attaches `GlobalCompliance`, `GlobalComplianceError` (double, mm/N), `ComplianceStatus` (uint8),
/// `GlobalMode0`... (float 3, sqrt(mm/N)) and the field array `GlobalModeSign` to the body from
/// which `found` was computed.
PALPATERESPONSE_EXPORT void attachYield(const BodyYield& found, vtkPolyData* body);
} // namespace palpate

#endif

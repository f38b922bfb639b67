// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * The functions of Filters/Laws for a body. Each function fetches and checks the arrays, calls the
 * law and attaches the result. Filters call the functions in a pipeline, and other code calls them
 * directly. The functions return "" or an error message.
 */
#ifndef BodyLaws_h
#define BodyLaws_h

#include "palpateResponseModule.h" // For export macro

#include "Laws/BodyMaterial.h"              // For palpate::BodyMaterial
#include "Laws/LawTerms.h"                  // For palpate::LawTerms
#include "Response/Curves/MaterialArrays.h" // For palpate::MaterialArrays
#include "Response/Pieces/Ranks.h"          // For palpate::Ranks

#include <functional> // For std::function
#include <string>     // For std::string

class vtkContactTool;
class vtkPolyData;

namespace palpate
{
class AxisymmetricTool;
struct MeasuredBodyError;

/// Input of attachResponse and attachRegime. It describes a tool that is pressed into a material.
struct LawRequest
{
  vtkContactTool* tool = nullptr;
  std::string responseName = "Response";
  /// Depth, mm. For a response: the depth of the last sample. For a regime: the depth of the
  /// verdict, where 0 means half of each point's range.
  double deflection = 0.0;
  BodyMaterial::Constants material{ 0.1, 0.45, 0.0, LayerBase::Bonded, false };
  MaterialArrays arrays;
  int samples = 8;     ///< number of samples of a curve, for a response
  LawTerms terms = {}; ///< optional terms of the law, for a response
  /// Error of the material, for a response with a measured material.
  const MeasuredBodyError* measured = nullptr;
  RelaxationRequest relaxation = {}; ///< relaxation of the body, for a response
  bool couples = false;              ///< for a response: whether contacts on the body can interact
  /// For a response: an array that is nonzero at the points that get a response. Without the array,
  /// all points get a response.
  MaterialArray pressed = {};
  bool wholeBody = false; ///< for a response: whether it includes the body's compliance
                          ///< (WholeBody.h)
};

/// Checks the settings of a response. Returns "" if they are valid, else an error message.
PALPATERESPONSE_EXPORT std::string checkRequest(const LawRequest& request);

/// Checks that the tool can be pressed to the depth `deflection` (mm). Returns "" or an error
/// message.
PALPATERESPONSE_EXPORT std::string checkToolDepth(const AxisymmetricTool& tool, double deflection);

/// Attaches the response to the body, see vtkToolContactResponse. `output` is empty if
/// `goOn(fraction)` returns false. Returns "" or an error message. `warning` receives a warning or
/// "". Collective; `input` is the piece of this process. The laws use the repaired body
/// (SoundBody).
PALPATERESPONSE_EXPORT std::string attachResponse(const Ranks& ranks, vtkPolyData* input,
  const LawRequest& request, const std::function<bool(double)>& goOn, vtkPolyData* output,
  std::string& warning);
} // namespace palpate

#endif

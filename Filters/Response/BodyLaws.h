// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * The functions of Filters/Laws, called on a body: each fetches and checks the arrays, calls,
 * and attaches the result. Filters make these calls in a pipeline, other code directly. They return
 * what is wrong, or "".
 */
#ifndef BodyLaws_h
#define BodyLaws_h

#include "palpateResponseModule.h" // For export macro

#include "Laws/BodyMaterial.h"                 // For palpate::BodyMaterial
#include "Laws/LawTerms.h"                     // For palpate::LawTerms
#include "Response/Curves/RelaxationRequest.h" // For palpate::RelaxationRequest
#include "Response/Curves/MaterialArrays.h"    // For palpate::MaterialArrays
#include "Response/Pieces/Ranks.h"             // For palpate::Ranks

#include <functional> // For std::function
#include <string>     // For std::string

class vtkContactTool;
class vtkPolyData;

namespace palpate
{
struct MeasuredBodyError;

/// A tool pressed into a material.
struct LawRequest
{
  vtkContactTool* tool = nullptr;
  std::string responseName = "Response";
  /// Depth of a response's last sample, or depth at which a regime is judged (0: half of each
  /// point's range), mm.
  double deflection = 0.0;
  BodyMaterial::Constants material{ 0.1, 0.45, 0.0, LayerBase::Bonded, false };
  MaterialArrays arrays;
  int samples = 8;                             ///< of a response
  LawTerms terms = {};                         ///< of a response
  const MeasuredBodyError* measured = nullptr; ///< of a response whose material was measured
  RelaxationRequest relaxation = {};           ///< of a response
  bool couples = false; ///< of a response: contacts on it may feel one another
};

/// What is wrong with the settings of a response, or "".
PALPATERESPONSE_EXPORT std::string checkRequest(const LawRequest& request);

/// The body with its response, see vtkToolContactResponse; nothing if `goOn(fraction)` ends it.
/// Also a warning, or "". Collective; `input` is the own piece. The laws use the repaired body
/// (SoundBody).
PALPATERESPONSE_EXPORT std::string attachResponse(const Ranks& ranks, vtkPolyData* input,
  const LawRequest& request, const std::function<bool(double)>& goOn, vtkPolyData* output,
  std::string& warning);
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef RelaxationRequest_h
#define RelaxationRequest_h

#include "Mechanics/Relaxation/PronySeries.h"
#include "Response/Curves/MaterialArrays.h"

#include "palpateResponseModule.h"

#include <string>

class vtkPolyData;

namespace palpate
{
/// Index of the array to process that has the strengths at each point.
constexpr int RelaxationArrayIndex = 5;

/// The relaxation of a body. Without branches the body does not relax.
struct RelaxationRequest
{
  PronySeries series;
  MaterialArray strength = {};   ///< one component per branch; replaces the strengths of the series
  bool complianceRelaxes = true; ///< whether the global compliance relaxes with the material
};

/// Checks the request and the arrays of a body that it names. Returns "" or an error message.
std::string checkRelaxation(
  vtkPolyData* body, const RelaxationRequest& request, const MaterialArray& compliance);

/// The relaxation as text, for example ", relaxing 0.5 in 0.1 s, 0.3 in 2 s"; "" without
/// relaxation.
PALPATERESPONSE_EXPORT std::string relaxationInWords(
  const RelaxationRequest& request, const MaterialArray& compliance);

/// Attaches the arrays of the data contract to a body that has passed checkRelaxation. Replaces
/// existing ones.
PALPATERESPONSE_EXPORT void attachRelaxation(const RelaxationRequest& request,
  const MaterialArray& compliance, const std::string& name, vtkPolyData* output);
} // namespace palpate

#endif

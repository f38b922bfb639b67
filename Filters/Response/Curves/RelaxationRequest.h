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
/// Index of the array to process that holds the strengths of each point.
constexpr int RelaxationArrayIndex = 5;

/// How a body relaxes; without branches it does not.
struct RelaxationRequest
{
  PronySeries series;
  MaterialArray strength = {};   ///< as many components as branches, instead of the series' own
  bool complianceRelaxes = true; ///< the global compliance is of the same material
};

/// What is wrong with the request or with the arrays of a body that it names, or "".
std::string checkRelaxation(
  vtkPolyData* body, const RelaxationRequest& request, const MaterialArray& compliance);

/// ", relaxing 0.5 in 0.1 s, 0.3 in 2 s"; "" where nothing does.
PALPATERESPONSE_EXPORT std::string relaxationInWords(
  const RelaxationRequest& request, const MaterialArray& compliance);

/// Attaches the arrays of the data contract in place of any there were, for a body that has passed
/// checkRelaxation.
PALPATERESPONSE_EXPORT void attachRelaxation(const RelaxationRequest& request,
  const MaterialArray& compliance, const std::string& name, vtkPolyData* output);
} // namespace palpate

#endif

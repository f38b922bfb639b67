// SPDX-License-Identifier: BSD-3-Clause
#ifndef BodyChoice_h
#define BodyChoice_h

#include "palpateResponseModule.h" // For export macro

#include "Contact/Reduction/ResponseChoice.h" // For palpate::ResponseChoice
#include "Laws/RelaxationError.h"             // For palpate::RelaxationNeed
#include "Laws/TiltNeed.h"                    // For palpate::TiltNeed

#include <string> // For std::string

class vtkPolyData;

namespace palpate
{
/// The chosen form of a response, as numbers and text.
struct AttachedChoice
{
  ResponseChoice choice;
  std::string reason;
  int numbersPerPointBefore = 0;
  RelaxationNeed relaxation; ///< needed elements of relaxation; set if the body relaxes
  TiltNeed tilt;             ///< needed tilt data; set if the tool may be tilted
};

/// Replaces a body's response by its simplest form; see vtkResponseChoice. Returns "" or an error
/// message.
PALPATERESPONSE_EXPORT std::string attachChoice(vtkPolyData* body, const std::string& responseName,
  const ChoiceSettings& settings, vtkPolyData* output, AttachedChoice& attached);
} // namespace palpate

#endif

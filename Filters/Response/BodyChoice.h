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
/// A choice, in numbers and words.
struct AttachedChoice
{
  ResponseChoice choice;
  std::string reason;
  int numbersPerPointBefore = 0;
  RelaxationNeed relaxation; ///< of a body that relaxes
  TiltNeed tilt;             ///< of a tool that may be tilted
};

/// Puts the simplest form of a body's response in place of it, see vtkResponseChoice.
PALPATERESPONSE_EXPORT std::string attachChoice(vtkPolyData* body, const std::string& responseName,
  const ChoiceSettings& settings, vtkPolyData* output, AttachedChoice& attached);
} // namespace palpate

#endif

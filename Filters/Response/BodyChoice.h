// SPDX-License-Identifier: BSD-3-Clause
#ifndef BodyChoice_h
#define BodyChoice_h

#include "palpateResponseModule.h" // For export macro

#include "Contact/Reduction/ResponseChoice.h" // For palpate::ResponseChoice

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
};

/// The body with the least form of its response, see vtkResponseChoice.
PALPATERESPONSE_EXPORT std::string attachChoice(vtkPolyData* body, const std::string& responseName,
  const ChoiceSettings& settings, vtkPolyData* output, AttachedChoice& attached);
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef WindowPicture_h
#define WindowPicture_h

#include "palpateInteractionModule.h" // For export macro

#include <string>

class vtkRenderWindow;

namespace palpate
{
/// Draws the window and writes it as a .png file. The file is written completely or not at all
/// (WholeFile). Returns "" or an error message with the file and the reason.
PALPATEINTERACTION_EXPORT std::string writeWindowPicture(
  vtkRenderWindow* window, const std::string& file);
} // namespace palpate

#endif

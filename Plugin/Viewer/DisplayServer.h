// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DisplayServer_h
#define palpate_DisplayServer_h

#include <functional>
#include <string>

namespace palpate
{
/// Why nothing can be drawn, "" if nothing stands in the way. Without an X server that answers, VTK
/// would abort the process at the first picture.
std::string displayProblem();

/// From now on the process ends with a message and exit code 1 when it loses its X server. Xlib
/// does not allow a return from there: no destructor runs, so necessary actions are given to
/// AtDisplayLoss.
void endWithDisplay();

/// An action on the loss of the X server, while this lives: release the hand, save the record. It
/// runs within a call to Xlib and must not draw. Returns an error, or "". One at a time.
class AtDisplayLoss
{
public:
  explicit AtDisplayLoss(std::function<std::string()> action);
  ~AtDisplayLoss();
  AtDisplayLoss(const AtDisplayLoss&) = delete;
  AtDisplayLoss& operator=(const AtDisplayLoss&) = delete;
};
} // namespace palpate

#endif

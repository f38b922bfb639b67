// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DisplayServer_h
#define palpate_DisplayServer_h

#include <functional>
#include <string>

namespace palpate
{
/// Returns the reason why drawing is impossible, or "" if it is possible. Without a responding X
/// server, VTK would abort the process at the first picture.
std::string displayProblem();

/// After this call, the process ends with a message and exit code 1 when it loses its X server.
/// Xlib does not allow a return from this error, so that no destructor runs. AtDisplayLoss
/// registers actions that must run in this case.
void endWithDisplay();

/// Registers an action for the loss of the X server, for example to release the hand and to save
/// the record. The registration lasts as long as this object exists. The action runs within a call
/// to Xlib and must not draw. It returns "" or an error. Only one object may exist at a time.
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

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_EndSignals_h
#define palpate_EndSignals_h

namespace palpate
{
/// While this lives, SIGINT, SIGTERM and SIGHUP are noted, for a window to close as by hand: the
/// hand is let go of, what was recorded is written. The same one again ends the process at once.
/// One at a time.
class EndSignals
{
public:
  EndSignals();
  ~EndSignals();
  EndSignals(const EndSignals&) = delete;
  EndSignals& operator=(const EndSignals&) = delete;

  /// Whether one has come.
  bool any() const noexcept;
};
} // namespace palpate

#endif

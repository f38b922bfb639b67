// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_EndSignals_h
#define palpate_EndSignals_h

namespace palpate
{
/// While this lives, SIGINT, SIGTERM and SIGHUP are noted, so that a window closes normally: the
/// hand is released, and the record written. The same signal again ends the process at once. One at
/// a time.
class EndSignals
{
public:
  EndSignals();
  ~EndSignals();
  EndSignals(const EndSignals&) = delete;
  EndSignals& operator=(const EndSignals&) = delete;

  /// Whether a signal has arrived.
  bool any() const noexcept;
};
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_EndSignals_h
#define palpate_EndSignals_h

namespace palpate
{
/// While this object exists, SIGINT, SIGTERM and SIGHUP are only recorded, so that a window closes
/// normally, releases the hand and writes the record. A second signal of the same kind ends the
/// process immediately. Only one object may exist at a time.
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

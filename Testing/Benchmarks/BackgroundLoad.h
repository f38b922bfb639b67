// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_benchmarks_BackgroundLoad_h
#define palpate_benchmarks_BackgroundLoad_h

#include <memory>
#include <string>

namespace palpate::benchmarks
{
/// What the machine has to do beside a servo thread.
class BackgroundLoad
{
public:
  virtual ~BackgroundLoad() = default;
  /// Returns after so many seconds, or a little more.
  virtual void runFor(double seconds) = 0;
  /// One word: idle, rendering, memory.
  virtual std::string name() const = 0;
  /// What that is, for a person.
  virtual std::string describe() const = 0;
};

/// Sleeps.
std::unique_ptr<BackgroundLoad> makeIdleLoad();

/// A thread on every processor that reads through memory three times as large as the last cache.
std::unique_ptr<BackgroundLoad> makeMemoryLoad();

/// VTK draws a body of 200 thousand triangles off screen, one frame after the other: in the calling
/// thread, in those of the OpenGL library, and, from the first run until it is destroyed, in a
/// process for every further processor, because one drawing does not keep all of them at work. Null
/// where there is no display for it (DISPLAY).
std::unique_ptr<BackgroundLoad> makeRenderLoad();

/// What such a process is to do: this program, called with DrawOption. Ends with its parent.
extern const char* const DrawOption;
[[noreturn]] void drawForEver();
} // namespace palpate::benchmarks

#endif

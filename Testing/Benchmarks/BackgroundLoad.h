// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_benchmarks_BackgroundLoad_h
#define palpate_benchmarks_BackgroundLoad_h

#include <memory>
#include <string>

namespace palpate::benchmarks
{
/// Work for the machine in addition to a servo thread.
class BackgroundLoad
{
public:
  virtual ~BackgroundLoad() = default;
  /// Runs the load and returns after `seconds` s or a little more.
  virtual void runFor(double seconds) = 0;
  /// Short name in one word: idle, rendering, memory.
  virtual std::string name() const = 0;
  /// Description of the load for a reader.
  virtual std::string describe() const = 0;
};

/// Sleeps.
std::unique_ptr<BackgroundLoad> makeIdleLoad();

/// One thread per processor reads through memory three times as large as the last cache.
std::unique_ptr<BackgroundLoad> makeMemoryLoad();

/// VTK draws a body of 200 thousand triangles off screen, one frame after the other, in the calling
/// thread and in those of the OpenGL library. One drawing does not keep all processors busy. So one
/// process per further processor draws as well, from the first run until the load is destroyed.
/// Null if there is no display (DISPLAY).
std::unique_ptr<BackgroundLoad> makeRenderLoad();

/// The work of such a process: this program, called with DrawOption. It ends with its parent.
extern const char* const DrawOption;
[[noreturn]] void drawForEver();
} // namespace palpate::benchmarks

#endif

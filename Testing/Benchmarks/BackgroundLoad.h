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

/// Reads memory in one thread per processor. The memory is three times as large as the last cache.
std::unique_ptr<BackgroundLoad> makeMemoryLoad();

/// Draws a body of 200 thousand triangles off screen with VTK, frame after frame, in the calling
/// thread and in the threads of the OpenGL library. One such drawing does not use all processors.
/// Therefore one process per further processor draws as well, from the first run until the load is
/// destroyed. Returns null if there is no display (DISPLAY).
std::unique_ptr<BackgroundLoad> makeRenderLoad();

/// The work of such a further process: this program, called with DrawOption. The process ends with
/// its parent.
extern const char* const DrawOption;
[[noreturn]] void drawForEver();
} // namespace palpate::benchmarks

#endif

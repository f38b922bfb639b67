// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_DrawingThread_h
#define palpate_endurance_DrawingThread_h

#include "Haptics/Servo/LatestValue.h"
#include "RoundBody.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <atomic>
#include <cstdint>
#include <mutex>
#include <thread>

namespace palpate::endurance
{
/// Draws body and tip off screen in its own thread and window: a small picture about 30 times a
/// second.
class DrawingThread
{
public:
  DrawingThread() = default;
  ~DrawingThread() { this->stop(); }
  DrawingThread(const DrawingThread&) = delete;
  DrawingThread& operator=(const DrawingThread&) = delete;

  void start();
  void stop();
  /// Replaces the drawn body by a copy of `body`, from the next frame on.
  void show(vtkPolyData* body);
  /// Sets the position of the tip, mm.
  void move(const Vector3& tip) { this->Tip.write(tip); }
  std::uint64_t frames() const { return this->Frames.load(); }

private:
  void run();
  vtkSmartPointer<vtkPolyData> takeBody();

  std::atomic<bool> Stopping{ false };
  std::atomic<std::uint64_t> Frames{ 0 };
  LatestValue<Vector3> Tip{ Vector3::Zero() };
  std::mutex Lock; ///< protects Body; both threads may wait for it
  vtkSmartPointer<vtkPolyData> Body;
  std::thread Thread;
};
} // namespace palpate::endurance

#endif

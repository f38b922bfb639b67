// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LiveTouchSession_h
#define palpate_LiveTouchSession_h

#include "Interaction/Session/NewestRequest.h"
#include "LiveTouchPlace.h"
#include "LiveTouchPreparation.h"

#include "vtkContactTool.h"
#include "vtkHapticSession.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <deque>
#include <string>

namespace palpate
{
/**
 * A session of the panel: a haptic device on a body with responses, in real time.
 *
 * The search structure of the body is made on another thread, which also waits for a device to
 * answer. start and replace return immediately. collect must be called once per frame, and
 * continues when this work is done. Until then the previous body remains in use; afterwards the new
 * body is used.
 *
 * A simulated hand moves to the handle given to steer(). The hand begins above the surface, because
 * the force is zero until the tip has been outside of the body. If the target is far away, the hand
 * is lifted and restarted above the target instead of being moved through the body. Physical
 * devices begin 10 mm above the surface at the handle, with x to the right and y up in the view.
 *
 * stop() and the destructor end the force of the device and close the device.
 *
 * Not thread-safe. The bodies that are passed must not be changed in place.
 */
class LiveTouchSession
{
public:
  enum class State
  {
    Idle,
    Preparing, ///< being prepared; there is no session yet
    Touching
  };

  LiveTouchSession() = default;
  ~LiveTouchSession() { this->stop(); }
  LiveTouchSession(const LiveTouchSession&) = delete;
  LiveTouchSession& operator=(const LiveTouchSession&) = delete;

  /// Begins the preparation; the session starts when the preparation is complete. `device` is a
  /// device name as for vtkHapticDevice::Open. `sight` is the user's view of the body, with which
  /// the device is aligned.
  void start(vtkPolyData* body, const std::string& response, const std::string& device,
    const TouchHandle& handle, const Sight& sight);
  /// Replaces the body of the running session by another body, or by the same body with another
  /// response.
  void replace(vtkPolyData* body, const std::string& response);
  void stop();

  /// Must be called once per frame. Returns true if state, body or error have changed.
  bool collect();
  /// Must be called once per frame with the present handle. Only a simulated device follows the
  /// handle. Returns false if the session has ended in this call; see error().
  bool steer(const TouchHandle& handle);

  State state() const { return this->Phase; }
  /// Whether another body is being prepared.
  bool isPreparing() const { return this->Background.isBusy(); }
  /// The error of the last start or replace, or "" if there is none. The second function returns
  /// the defects of the mesh, or "" if there are none.
  const std::string& error() const { return this->Error; }
  const std::string& warning() const { return this->Warning; }

  /// The session; null if the state is not Touching.
  vtkHapticSession* session() { return this->Session; }
  /// The tool of the response in use; null if the state is not Touching.
  vtkContactTool* tool() { return this->Tool; }
  vtkPolyData* body() { return this->Body; }
  /// Largest force of the response at its range, N.
  double peakForce() const { return this->Peak; }
  /// The target of the tip, and the outward normal at the nearest point of the body.
  const LiveTouchPlace& place() const { return this->Place; }

private:
  void request(vtkPolyData* body, const std::string& response, const std::string& device,
    const std::optional<Sight>& sight = {});
  bool take(PreparedLiveTouch& made);
  bool begin(PreparedLiveTouch& made);
  bool change(const PreparedLiveTouch& made);
  void putDown();
  bool fail(const std::string& error);

  State Phase = State::Idle;
  std::string Error;
  std::string Warning;
  std::string Complaint; ///< last error of the session
  std::string Device;
  TouchHandle Handle;
  Sight View;
  LiveTouchPlace Place;
  double Peak = 0.0;
  vtkSmartPointer<vtkHapticSession> Session;
  vtkSmartPointer<vtkContactTool> Tool;
  vtkSmartPointer<vtkPolyData> Body;
  BodyKernels Kernels; ///< kernels of the body

  /// Bodies that the other thread may be reading. Only the thread of this class changes their
  /// reference counts.
  std::deque<vtkSmartPointer<vtkPolyData>> Held;
  /// Must be the last member, so that it is destroyed first.
  NewestRequest<LiveTouchRequest, PreparedLiveTouch> Background{ prepareLiveTouch };
};
} // namespace palpate

#endif

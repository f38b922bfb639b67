// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHapticRecorder
 * @brief records the ticks of a vtkHapticSession, and their timing
 *
 * In virtual time every tick is kept. On the servo thread ticks wait to be read, which happens
 * whenever the session is queried, as once a frame. Ticks that wait for more than RecordedSeconds
 * are lost, and counted. HistorySeconds keeps the last ticks only, for charts of an unlimited
 * session.
 *
 * Settings are read at the session's Start; results are those of the run since, empty before, and
 * end with the session. For the session's thread.
 */
#ifndef vtkHapticRecorder_h
#define vtkHapticRecorder_h

#include "palpateInteractionModule.h" // For export macro
#include "vtkObject.h"

#include <memory> // For std::weak_ptr
#include <string> // For std::string
#include <vector> // For std::vector

class vtkPolyData;
class vtkTable;

namespace palpate
{
class ServoLoop;
class SessionRun;
struct Tick;
class TickHistory;
class TickTape;
} // namespace palpate

class PALPATEINTERACTION_EXPORT vtkHapticRecorder : public vtkObject
{
public:
  static vtkHapticRecorder* New();
  vtkTypeMacro(vtkHapticRecorder, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether every tick is kept for GetRecording. Default on. With RealTime contacts and peaks are
   * counted over the ticks recorded, or in the history.
   */
  vtkSetMacro(Recording, bool);
  vtkGetMacro(Recording, bool);
  vtkBooleanMacro(Recording, bool);
  ///@}
  ///@{
  /** With RealTime: how long ticks wait to be read, s, 0.1 to 100; 600 bytes each. Default 5. */
  vtkSetClampMacro(RecordedSeconds, double, 0.1, 100.0);
  vtkGetMacro(RecordedSeconds, double);
  ///@}
  ///@{
  /** Whether the ticks of the last seconds are kept for GetHistory, and how many s: 0 to 100; 600
   * bytes each. With RealTime those that wait to be read, for at most this long if nothing else is
   * recorded. Default 0: none. */
  vtkSetClampMacro(HistorySeconds, double, 0.0, 100.0);
  vtkGetMacro(HistorySeconds, double);
  ///@}

  /**
   * Every tick since Start, as one polyline of tips with the arrays of vtkToolContactProbe and
   * `Time`, `AppliedForce` (3, N), `ForceFactor` and `SafetyLinks` (int; bits in the order of the
   * chain); `MemoryForce` if there was any, `ToolAxis` (3) and `Torque` (3, N mm, ideal, about the
   * tip) if any tick has an axis. Cells are numbered as in the newest body.
   */
  void GetRecording(vtkPolyData* recording);
  /**
   * The same of one of several devices, by its index; empty for none. History, and everything else
   * without a device index, is that of the first.
   */
  void GetRecording(vtkPolyData* recording, int device);
  /** The same of the last HistorySeconds: the ticks whose time is less than that before the newest.
   */
  void GetHistory(vtkPolyData* history);

  /** Ticks missed since Start; none in virtual time. */
  vtkIdType GetNumberOfMissedTicks();
  /** Ticks made since Start that nobody read in time: neither recording nor history has them. */
  vtkIdType GetNumberOfLostTicks();

  /**
   * One row: ticks, ticks in contact, peak force, applied force and friction (N), peak deflection
   * (mm), the memory part of the peak force (N), median and 99th percentile of the time per tick
   * (ns, wall clock, so they differ from run to run); with RealTime also ticks missed, samples
   * invalid and repeated, forces refused, ticks not recorded, scene changes, and the device's own
   * errors.
   */
  void GetStatistics(vtkTable* statistics);
  /** The same of one of several devices: contacts and peaks are its own, times and errors those of
   * all. */
  void GetStatistics(vtkTable* statistics, int device);
  /** Statistics and timing, as lines of text. */
  std::string GetStatisticsText();
  /**
   * With RealTime: columns Share, Period, WakeUp and Tick (us, wall clock): the time not exceeded
   * by that fraction of the ticks, to 1/32; the last row, 1, is the worst. Empty otherwise.
   */
  void GetTiming(vtkTable* timing);
  /** With RealTime: how many ticks had which Period, WakeUp and Tick: a row per class of durations,
   * longer than `From (us)` and up to `To (us)`, at most 1/32 apart, from the first to the last
   * that holds any; counts as double. Empty otherwise. */
  void GetTimingHistogram(vtkTable* histogram);
  /** With RealTime: the scheduling that the system granted the servo thread, and why not more. */
  std::string GetRealTimeGrant();

#ifndef __VTK_WRAP__
  /** Every tick since Start. */
  const std::vector<palpate::Tick>& GetTicks();
  const std::vector<palpate::Tick>& GetTicks(int device);
  /** Those of the last HistorySeconds, numbered. */
  const palpate::TickHistory& GetLastTicks();
  /** Records the ticks of a part of the session, also across runs. */
  const std::shared_ptr<palpate::TickTape>& GetTape();

  /** Called by a session that starts; null: nothing runs. */
  void Follow(const std::shared_ptr<palpate::SessionRun>& run);
#endif

protected:
  vtkHapticRecorder();
  ~vtkHapticRecorder() override;

private:
  vtkHapticRecorder(const vtkHapticRecorder&) = delete;
  void operator=(const vtkHapticRecorder&) = delete;

  palpate::SessionRun* Collected();
  const palpate::ServoLoop* Loop();

  bool Recording = true;
  double RecordedSeconds = 5.0;
  double HistorySeconds = 0.0;
  std::weak_ptr<palpate::SessionRun> Run;
  std::shared_ptr<palpate::TickTape> Tape;
};

#endif

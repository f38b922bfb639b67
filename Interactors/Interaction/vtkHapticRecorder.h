// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHapticRecorder
 * @brief records the ticks of a vtkHapticSession, and their timing
 *
 * In virtual time all ticks are stored. On the servo thread, ticks wait in a buffer until they are
 * read. They are read at each query of the session, for example once per frame. Ticks that wait for
 * more than RecordedSeconds are lost, and the lost ticks are counted. If HistorySeconds is set,
 * only the last ticks are stored, for charts of a session of unlimited length.
 *
 * Settings are read at the session's Start. The results are those of the run since Start. They are
 * empty before Start, and are lost when the session is deleted. Only the session's thread may use
 * the recorder.
 *
 * @code{.py}
 * session.GetRecorder().SetRecording(True)             # before Start
 * session.Start()
 * session.Step(2.0)                                    # s
 * session.GetRecorder().GetRecording(recording)        # a vtkPolyData: a point per tick
 * session.GetRecorder().GetStatistics(statistics)      # a vtkTable: ticks, peak force, ...
 * @endcode
 */
#ifndef vtkHapticRecorder_h
#define vtkHapticRecorder_h

#include "palpateInteractionModule.h" // For export macro
#include "vtkObject.h"

#include <memory> // For std::weak_ptr, std::unique_ptr
#include <string> // For std::string
#include <vector> // For std::vector

class vtkPolyData;
class vtkTable;

namespace palpate
{
struct RecordedSetup;
class RecordedSetups;
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
   * Whether all ticks are stored for GetRecording. Default on. With RealTime, contacts and peaks
   * are counted over the recorded ticks, or over the history.
   */
  vtkSetMacro(Recording, bool);
  vtkGetMacro(Recording, bool);
  vtkBooleanMacro(Recording, bool);
  ///@}
  ///@{
  /** Longest time for which ticks wait to be read with RealTime, s, 0.1 to 100. A tick needs 600
   * bytes. Default 5. */
  vtkSetClampMacro(RecordedSeconds, double, 0.1, 100.0);
  vtkGetMacro(RecordedSeconds, double);
  ///@}
  ///@{
  /**
   * Length of the history for GetHistory, s, 0 to 100. A tick needs 600 bytes. With RealTime, ticks
   * wait to be read for at most this long if nothing else is recorded. With 0, the default, there
   * is no history.
   */
  vtkSetClampMacro(HistorySeconds, double, 0.0, 100.0);
  vtkGetMacro(HistorySeconds, double);
  ///@}

  /**
   * All ticks since Start, as one polyline of tips with the arrays of vtkToolContactProbe and
   * `Time`, `AppliedForce` (3, N), `ForceFactor` and `SafetyLinks` (int; bits in the order of the
   * chain). `MemoryForce` is added if any tick has memory; `ToolAxis` (3) and `Torque` (3, N mm,
   * ideal, about the tip) if any tick has an axis. Cells are numbered as in the newest body.
   */
  void GetRecording(vtkPolyData* recording);
  /**
   * The recording of the device with the index `device`. It is empty for an invalid index. The
   * history, and all results without a device index, are those of the first device.
   */
  void GetRecording(vtkPolyData* recording, int device);
  /** Does the same as GetRecording for the history, which contains the ticks of the last
   * HistorySeconds before the newest tick. */
  void GetHistory(vtkPolyData* history);

  /** Number of ticks missed since Start. 0 in virtual time. */
  vtkIdType GetNumberOfMissedTicks();
  /** Number of ticks since Start that were not read in time. Neither the recording nor the history
   * contains them. */
  vtkIdType GetNumberOfLostTicks();

  /**
   * Writes one row with these columns: ticks, ticks in contact, peak force, applied force and
   * friction (N), peak deflection (mm), the memory part of the peak force (N), median and 99th
   * percentile of the duration of a tick (ns, wall clock, different in each run). With RealTime,
   * further columns are: ticks missed, samples invalid and repeated, forces refused, ticks not
   * recorded, scene changes, and the device's own errors.
   */
  void GetStatistics(vtkTable* statistics);
  /** Writes the row for the device with the index `device`. Contacts and peaks are those of this
   * device; times and errors are those of all devices. */
  void GetStatistics(vtkTable* statistics, int device);
  /** With RealTime, statistics and timing as lines of text. Empty in virtual time. */
  std::string GetStatisticsText();
  /**
   * With RealTime, a table with the columns Share, Period, WakeUp and Tick (us, wall clock). Share
   * is a fraction of the ticks. The other columns give the time that this fraction does not exceed,
   * with a resolution of 1/32. The last row, with Share 1, is the worst case. Empty in virtual
   * time.
   */
  void GetTiming(vtkTable* timing);
  /** With RealTime, histograms of Period, WakeUp and Tick. Each row is a class of durations that
   * are longer than `From (us)` and at most `To (us)`. The two limits differ by at most 1/32. The
   * rows extend from the first to the last class that contains a tick. The counts have the type
   * double. Empty in virtual time. */
  void GetTimingHistogram(vtkTable* histogram);
  /** With RealTime, a text about the scheduling that the system grants to the servo thread, with
   * the reason if a better scheduling was refused. */
  std::string GetRealTimeGrant();

#ifndef __VTK_WRAP__
  /** All ticks since Start. */
  const std::vector<palpate::Tick>& GetTicks();
  const std::vector<palpate::Tick>& GetTicks(int device);
  /** The ticks of the last HistorySeconds, with their numbers. */
  const palpate::TickHistory& GetLastTicks();
  /** The tape, which records the ticks of a part of the session. A part may extend over several
   * runs. */
  const std::shared_ptr<palpate::TickTape>& GetTape();

  /** The setups of the run since Start. If no ticks are recorded, only the newest setup. */
  const palpate::RecordedSetups& GetSetups() const;
  /** Called by a session that uses another setup from `time` (s) on. */
  void AddSetup(double time, const palpate::RecordedSetup& setup);

  /** Called by a session that starts. If `run` is null, there is no run. */
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
  std::unique_ptr<palpate::RecordedSetups> Setups;
};

#endif

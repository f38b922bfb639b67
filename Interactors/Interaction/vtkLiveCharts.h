// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLiveCharts
 * @brief live charts next to the scene: force over time and over deflection, and the stored curves
 *
 * Set a renderer (its own viewport in the live window; the charts fill it, side by side or one
 * above the other) and a session. Call Update once a frame, before the window renders.
 *
 * - **Time**: all ticks of the last Duration seconds: the ideal force and the applied force, and
 *   friction and memory force if there are any; magnitudes in N. The lines join the smallest and
 *   the largest value of a few ticks each, so that no peak is lost. A time without ticks is a gap.
 * - **Deflection**: force over deflection (mm, N) since the contact last began, loading and
 *   unloading, ideal and applied. For a body that relaxes, the slow force is shown, too; the curve
 *   of the ideal force is a loop around it.
 * - **Curves**: the stored curves of the three corners of the triangle in contact, and their blend
 *   by area coordinates, dotted beyond Validity, with a band of the estimated error. A running
 * point shows the present normal force. A tilted tool has a curve of its own, which contains this
 *   point. On a body that relaxes a line leads from the slow force, on the curve, to this point.
 *   With AddComparedResponse, the chart shows the blended curve of each response, one per tool, at
 *   the contact, instead of the curves of the corners. The last contact remains visible.
 * - **Histogram** (off by default): histograms of the period, wake-up latency and duration of the
 *   servo thread's ticks (µs), both axes logarithmic. Empty in virtual time.
 *
 * The first ranges of the axes are chosen once from the responses: their range of deflection, and
 * the force at half of it; or they are set by SetLargestDeflection and SetLargestForce. An axis
 * grows in round steps as soon as a drawn value is larger. It shrinks if for 3 s all drawn values
 * have been below a third of it. ResetRanges chooses again.
 *
 * Without a session, ShowTip shows the tips of a probe's output or a recording in the same way.
 *
 * Cost of an Update: 0.1 µs per tick since the last one, and tables of at most a few thousand
 * numbers, independent of the length of the session and the size of the body. An Update never waits
 * for the servo thread and takes no lock. Only the thread of the session may call it.
 *
 * @code{.py}
 * charts = palpate.vtkLiveCharts()
 * charts.SetRenderer(strip)
 * charts.SetSession(session)
 * charts.SetDuration(5.0)                              # s
 * clock.AddObserver(clock.FrameEvent, lambda *_: charts.Update())
 * @endcode
 */
#ifndef vtkLiveCharts_h
#define vtkLiveCharts_h

#include "palpateInteractionModule.h" // For export macro
#include "vtkObject.h"

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class vtkChartXY;
class vtkHapticSession;
class vtkPolyData;
class vtkRenderer;
class vtkTable;

class PALPATEINTERACTION_EXPORT vtkLiveCharts : public vtkObject
{
public:
  static vtkLiveCharts* New();
  vtkTypeMacro(vtkLiveCharts, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The renderer of the charts. The charts set its background and handle no events. Null: no
   * renderer.
   */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  ///@{
  /**
   * The session to show. If its recorder's HistorySeconds is less than Duration, it is set to
   * Duration, which takes effect at the next Start of the session. The charts adopt changes of the
   * session's body and ResponseName.
   */
  void SetSession(vtkHapticSession* session);
  vtkHapticSession* GetSession();
  ///@}
  /** Shows the ticks of the session since the last call. No effect without a session. */
  void Update();

  ///@{
  /** Body and prefix of the response for ShowTip. Default none, "Response". */
  void SetBody(vtkPolyData* body);
  void SetResponseName(const std::string& name);
  ///@}
  /**
   * Shows tip `index` of a probe's output or a recording over the body of SetBody, with the tips
   * before it as history. The chart over time needs an array `Time`. Returns false, after an error,
   * if there is no such tip, or the probe's arrays or the response are missing.
   */
  bool ShowTip(vtkPolyData* probed, vtkIdType index);

  /**
   * Shows a histogram of vtkHapticRecorder::GetTimingHistogram, of any run. Returns false, after an
   * error, if a column is missing.
   */
  bool ShowTimingHistogram(vtkTable* histogram);

  ///@{
  /**
   * Responses of the body to compare by their curves at the contact. The default label is the tool
   * of the response. Default none: the curves of the triangle's corners are shown.
   */
  void AddComparedResponse(const std::string& name, const std::string& label);
  void AddComparedResponse(const std::string& name) { this->AddComparedResponse(name, ""); }
  void RemoveAllComparedResponses();
  ///@}

  ///@{
  /** Which charts are shown. Default: all but the histogram. */
  void SetTimeVisibility(bool visible);
  bool GetTimeVisibility();
  void SetDeflectionVisibility(bool visible);
  bool GetDeflectionVisibility();
  void SetCurvesVisibility(bool visible);
  bool GetCurvesVisibility();
  void SetHistogramVisibility(bool visible);
  bool GetHistogramVisibility();
  ///@}

  ///@{
  /** Time span of the chart over time, s, 0.1 to 100. Default 10. A change clears the chart. */
  void SetDuration(double seconds);
  double GetDuration();
  ///@}

  ///@{
  /** Initial ends of the axes, N and mm. Default 0: chosen from the responses, see above. */
  void SetLargestForce(double force);
  double GetLargestForce();
  void SetLargestDeflection(double deflection);
  double GetLargestDeflection();
  ///@}
  /** Chooses new ranges of the axes at the next Update or ShowTip. */
  void ResetRanges();

  ///@{
  /** The charts. The tables of their plots hold the plotted data. */
  vtkChartXY* GetTimeChart();
  vtkChartXY* GetDeflectionChart();
  vtkChartXY* GetCurvesChart();
  vtkChartXY* GetHistogramChart();
  ///@}

protected:
  vtkLiveCharts();
  ~vtkLiveCharts() override;

private:
  vtkLiveCharts(const vtkLiveCharts&) = delete;
  void operator=(const vtkLiveCharts&) = delete;

  struct Parts;
  std::unique_ptr<Parts> Kept;
};

#endif

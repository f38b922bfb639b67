// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLiveCharts
 * @brief live charts next to the scene: force over time and over deflection, and the stored curves
 *
 * Set a renderer and a session. The renderer should have a viewport of its own in the live window;
 * the charts fill it, side by side or one above the other. Call Update once per frame, before the
 * window renders.
 *
 * - **Time**: all ticks of the last Duration seconds with the magnitudes of ideal force and applied
 *   force, and of friction and memory force if there are any, in N. The lines join the smallest and
 *   the largest value of a few ticks each, so that no peak is lost. A time without ticks is a gap.
 * - **Deflection**: force over deflection (mm, N) since the contact last began, loading and
 *   unloading, ideal and applied. For a body that relaxes, the slow force is shown, too; the curve
 *   of the ideal force is a loop around it.
 * - **Curves**: the stored curves of the three corners of the triangle in contact, and their blend
 *   by area coordinates, dotted beyond Validity, with a band of the estimated error. A running
 *   point shows the present normal force. A tilted tool has a curve of its own, which contains this
 *   point. On a body that relaxes a line leads from the slow force, on the curve, to this point.
 *   With AddComparedResponse, the chart shows the blended curve of each response, one per tool, at
 *   the contact, instead of the curves of the corners. The last contact remains visible.
 * - **Histogram** (off by default): histograms of the period, wake-up latency and duration of the
 *   servo thread's ticks (µs), both axes logarithmic. Empty in virtual time.
 *
 * The initial ranges of the axes are set by SetLargestDeflection and SetLargestForce, or chosen
 * once from the responses, from their range of deflection and the force at half of this range. An
 * axis grows in round steps as soon as a drawn value exceeds it. It shrinks if for 3 s all drawn
 * values have been below a third of it. ResetRanges chooses the ranges again.
 *
 * Without a session, ShowTip shows the tips of a probe's output or a recording in the same way.
 *
 * An Update costs 0.1 µs per tick since the last Update, and fills tables of at most a few thousand
 * numbers. The cost does not depend on the length of the session or the size of the body. An Update
 * never waits for the servo thread and takes no lock. Only the thread of the session may call it.
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
   * The renderer of the charts. The charts set the background of the renderer and handle no events.
   * Null removes the charts from their renderer.
   */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  ///@{
  /**
   * The session to show. If the HistorySeconds of its recorder are less than Duration, they are set
   * to Duration; this takes effect at the next Start of the session. The charts follow changes of
   * the session's body and ResponseName.
   */
  void SetSession(vtkHapticSession* session);
  vtkHapticSession* GetSession();
  ///@}
  /** Shows the ticks of the session since the last call. No effect without a session. */
  void Update();

  ///@{
  /** Body and prefix of the response for ShowTip. Default: no body, and "Response". */
  void SetBody(vtkPolyData* body);
  void SetResponseName(const std::string& name);
  ///@}
  /**
   * Shows the tip with index `index` of a probe's output, or of a recording, on the body of
   * SetBody. The tips before it are the history. The chart over time needs an array `Time`. Returns
   * false and reports an error if there is no such tip, or if the probe's arrays or the response
   * are missing.
   */
  bool ShowTip(vtkPolyData* probed, vtkIdType index);

  /**
   * Shows a table from vtkHapticRecorder::GetTimingHistogram, of any run. Returns false, after an
   * error, if a column is missing.
   */
  bool ShowTimingHistogram(vtkTable* histogram);

  ///@{
  /**
   * Responses of the body whose curves are compared at the contact. The default label is the tool
   * of the response. Without such responses, the default, the curves of the triangle's corners are
   * shown.
   */
  void AddComparedResponse(const std::string& name, const std::string& label);
  void AddComparedResponse(const std::string& name) { this->AddComparedResponse(name, ""); }
  void RemoveAllComparedResponses();
  ///@}

  ///@{
  /** Which charts are shown. Default: all except the histogram. */
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
  /** Initial ends of the axes, N and mm. With 0, the default, they are chosen from the responses
   * (see the description of the class). */
  void SetLargestForce(double force);
  double GetLargestForce();
  void SetLargestDeflection(double deflection);
  double GetLargestDeflection();
  ///@}
  /** Chooses new ranges of the axes at the next Update or ShowTip. */
  void ResetRanges();

  ///@{
  /** The charts. The tables of their plots contain the plotted data. */
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

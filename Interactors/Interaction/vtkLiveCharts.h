// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLiveCharts
 * @brief live charts beside the scene: force over time and over deflection, and the stored curves
 *
 * Give it a renderer (its own viewport in the live window; the charts fill it, side by side or one
 * above the other) and a session; call Update once a frame, before the window renders.
 *
 * - **Time**: the last Duration seconds of all ticks: the ideal and the applied force, and friction
 *   and memory if there are any; magnitudes in N. Lines are drawn through the least and the largest
 *   of some ticks each, so that no peak is lost. A time without ticks is a gap.
 * - **Deflection**: force over deflection (mm, N) since the last first contact, loading and
 *   unloading, ideal and applied; on a body that relaxes the slow force, too, around which the
 *   ideal one makes a loop.
 * - **Curves**: the stored curves of the three corners of the touched triangle and their blend by
 *   area coordinates, dotted beyond Validity, with the present normal force as a running point.
 *   With AddComparedResponse: instead of the corners' curves the blended curve of each response,
 *   that is of each tool, at the contact. The last contact remains.
 * - **Histogram** (off by default): histograms of the servo thread's period, wake-up latency and
 *   duration of ticks (µs), both axes logarithmic. Empty in virtual time.
 *
 * Axes begin with ranges chosen once from the responses: the depth they reach and the force half as
 * deep, or by SetLargestDeflection and SetLargestForce; they grow in round steps if a value is
 * larger, and shrink only by ResetRanges.
 *
 * Without a session ShowTip shows the tips of a probe's output or a recording in the same way.
 *
 * Cost of an Update: 0.1 µs per tick since the last one, and tables of at most some thousand
 * numbers, whatever the session's length and the body's size. It never waits for the servo thread,
 * and takes no lock. For the thread of the session.
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
  /** The renderer of the charts; they set its background and handle no events. Null: none. */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  ///@{
  /**
   * The session to show; its recorder's HistorySeconds is raised to Duration, which counts from its
   * next Start on. Changes of its body and ResponseName are followed.
   */
  void SetSession(vtkHapticSession* session);
  vtkHapticSession* GetSession();
  ///@}
  /** Shows the ticks of the session since the last call. Nothing happens without a session. */
  void Update();

  ///@{
  /** Body and prefix of the response for ShowTip. Default none, "Response". */
  void SetBody(vtkPolyData* body);
  void SetResponseName(const std::string& name);
  ///@}
  /**
   * Shows tip `index` of a probe's output or a recording over SetBody, with the tips before it as
   * history: over time if it has an array `Time`. Returns false, after an error, if there is no
   * such tip or the probe's arrays or the response are missing.
   */
  bool ShowTip(vtkPolyData* probed, vtkIdType index);

  /**
   * Shows a histogram of vtkHapticRecorder::GetTimingHistogram, of any run. Returns false, after an
   * error, if a column is missing.
   */
  bool ShowTimingHistogram(vtkTable* histogram);

  ///@{
  /**
   * Responses of the body whose curves at the contact are compared; the default label is the
   * response's tool. Default none: the triangle's corners.
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
  /** Time span of the chart over time, s, 0.1 to 100. Default 10. A change clears it. */
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
  /** The charts; what they plot is in their plots' tables. */
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

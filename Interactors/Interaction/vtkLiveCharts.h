// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLiveCharts
 * @brief what is felt now, in charts beside the scene: force over time, over deflection, the curves
 *
 * Give it a renderer (a viewport of its own in the live window; the charts fill it, side by side or
 * one above the other) and a session; call Update once a frame, before the window renders.
 *
 * - **Time**: the last Duration seconds, every tick seen: the ideal force, the applied one, and
 *   if there is any friction, and memory of a body that relaxes; lengths in N. Lines are drawn
 * through the least and the largest of some ticks each, so that no peak is lost. A stretch without
 * ticks is a gap.
 * - **Deflection**: force over deflection since the tool touched last (mm, N), loading and
 *   unloading, ideal and applied; of a body that relaxes the slow force, too, around which the
 *   ideal one makes its loop.
 * - **Curves**: the stored curves of the three corners of the touched triangle and their blend by
 *   area coordinates, dotted beyond Validity, with the normal force felt now as a running point.
 *   With AddComparedResponse: instead of the corners' the blended curve of each response, that is
 *   of each tool, at the contact. What was touched last stays.
 * - **Histogram** (off by default): how many ticks of the servo thread had which period, were woken
 *   how late and took how long (µs), both axes logarithmic. Empty in virtual time.
 *
 * Axes begin with ranges chosen once from the responses: the depth they reach, the force half as
 * deep, or what SetLargestDeflection and SetLargestForce say; they grow in round steps when
 * something is larger and never shrink, but for ResetRanges.
 *
 * Without a session ShowTip shows the tips of a probe's output or a recording, likewise.
 *
 * Cost of an Update: what arrived since the last one, some 0.1 us per tick, and tables of at most
 * some thousand numbers, however long the session and large the body. It never waits for the servo
 * thread, and takes no lock. For the thread of the session.
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
  /** The renderer the charts fill; they set its background and take no events. Null: none. */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  ///@{
  /** The session to show; its recorder's HistorySeconds is raised to Duration, which counts from
   * its next Start on. Its body and ResponseName are followed. */
  void SetSession(vtkHapticSession* session);
  vtkHapticSession* GetSession();
  ///@}
  /** Shows what the session felt since the last call. Nothing happens without a session. */
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

  /** Shows a histogram of vtkHapticRecorder::GetTimingHistogram, of whatever run. Returns false,
   * after an error, if a column is missing. */
  bool ShowTimingHistogram(vtkTable* histogram);

  ///@{
  /** Responses of the body whose curves at the contact are to be compared; without a label the tool
   * the response names is one. Default none: the triangle's corners. */
  void AddComparedResponse(const std::string& name, const std::string& label);
  void AddComparedResponse(const std::string& name) { this->AddComparedResponse(name, ""); }
  void RemoveAllComparedResponses();
  ///@}

  ///@{
  /** Which charts there are. Default: all but the histogram. */
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
  /** How far back the chart over time goes, s, 0.1 to 100. Default 10. What it showed is gone. */
  void SetDuration(double seconds);
  double GetDuration();
  ///@}

  ///@{
  /** Where the axes end at first, N and mm. Default 0: chosen from the responses, see above. */
  void SetLargestForce(double force);
  double GetLargestForce();
  void SetLargestDeflection(double deflection);
  double GetLargestDeflection();
  ///@}
  /** Chooses the ranges of the axes anew at the next Update or ShowTip. */
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

// SPDX-License-Identifier: BSD-3-Clause
// The curves at the contact. The interpolated curve is compared with the probe at the same place,
// and the corner curves with vtkResponseCurves, on facets and on the smooth surface. Also tested:
// compared tools, and the start of the dotted part.
#include "LiveChartChecks.h"
#include "LiverSlab.h"

#include "vtkAxis.h"
#include "vtkHapticSession.h"
#include "vtkPen.h"
#include "vtkResponseCurves.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <array>
#include <limits>

namespace
{
using namespace palpate::testing;

constexpr double Range = 2.0; // mm, the default of vtkToolContactResponse
constexpr int Steps = 60;
constexpr const char* Corners[3] = { "Corner 1", "Corner 2", "Corner 3" };

double felt(vtkPolyData* probed, const char* name)
{
  return probed->GetPointData()->GetArray(name)->GetTuple1(0);
}

std::array<vtkIdType, 3> cornersOf(vtkPolyData* body, vtkPolyData* probed)
{
  vtkNew<vtkIdList> ids;
  body->GetPolys()->GetCellAtId(static_cast<vtkIdType>(felt(probed, "ContactCell")), ids);
  return { ids->GetId(0), ids->GetId(1), ids->GetId(2) };
}

vtkSmartPointer<vtkTable> storedCurves(
  vtkPolyData* body, const std::string& name, std::initializer_list<vtkIdType> points)
{
  vtkNew<vtkResponseCurves> curves;
  curves->SetInputData(body);
  curves->SetResponseName(name);
  curves->SetNumberOfRows(Steps + 1);
  for (const vtkIdType point : points)
  {
    curves->AddPointId(point);
  }
  curves->Update();
  return curves->GetOutput();
}

/// Compares a curve with a table. Both evaluate the same samples of a stored curve and differ only
/// in the order of sums.
void checkCurve(const std::vector<Row>& curve, vtkTable* expected, vtkIdType column)
{
  vtkIdType row = 0;
  for (const auto& [depth, force] : curve)
  {
    while (row < Steps && expected->GetValue(row, 0).ToDouble() < depth - 1e-9)
    {
      ++row;
    }
    // The point is not the start of the dotted part.
    if (std::abs(expected->GetValue(row, 0).ToDouble() - depth) < 1e-9)
    {
      const double stored = expected->GetValue(row, column).ToDouble();
      PALPATE_CHECK_NEAR(force, stored, 1e-12 * stored);
    }
  }
  PALPATE_CHECK(row == Steps && curve.size() > Steps);
}

/// On a plane, a tip directly below the contact point has the same contact point. At any depth, the
/// interpolated curve equals the probe's force.
void checkFacets()
{
  const Body body = unevenResponse(planeBody(20.0, 20), "sphere:1.6");
  vtkDataArray* limits = body->GetPointData()->GetArray("ResponseValidity");
  for (vtkIdType i = 0; i < limits->GetNumberOfTuples(); ++i)
  {
    limits->SetTuple1(i, 0.31 + 0.1 * static_cast<double>(i % 5));
  }
  vtkNew<vtkLiveCharts> charts;
  charts->SetBody(body);
  vtkChartXY* chart = charts->GetCurvesChart();
  for (const auto& [x, y] :
    { Row{ 0.37, 0.81 }, Row{ -7.2, 3.1 }, Row{ 4.0, 4.0 }, Row{ 1.0, 6.0 } })
  {
    const Body pressed = probed(body, singleTip(x, y, -0.7));
    PALPATE_CHECK(charts->ShowTip(pressed, 0));
    const std::vector<Row> blend = curveOf(chart, "Blend");
    // Plus the point where the curve becomes dotted, which is in both parts.
    PALPATE_CHECK(blend.size() == Steps + 3);
    for (const auto& [depth, force] : blend)
    {
      const double expected =
        depth > 0.0 ? felt(probed(body, singleTip(x, y, -depth)), "NormalForce") : 0.0;
      PALPATE_CHECK_NEAR(force, expected, 1e-12 * expected);
    }
    const auto ids = cornersOf(body, pressed);
    vtkSmartPointer<vtkTable> stored = storedCurves(body, "Response", { ids[0], ids[1], ids[2] });
    double validity = Range;
    for (std::size_t k = 0; k < 3; ++k)
    {
      checkCurve(curveOf(chart, Corners[k]), stored, static_cast<vtkIdType>(k) + 1);
      validity = std::min(validity, limits->GetTuple1(ids[k]));
    }
    vtkPlot* solid = plotOf(chart, "Blend");
    vtkPlot* dotted = chart->GetPlot(chart->GetPlotIndex(solid) + 1);
    PALPATE_CHECK(pointsOf(solid).back().first == validity);
    PALPATE_CHECK(pointsOf(dotted).front() == pointsOf(solid).back());
    PALPATE_CHECK(solid->GetPen()->GetLineType() == vtkPen::SOLID_LINE);
    PALPATE_CHECK(dotted->GetPen()->GetLineType() == vtkPen::DOT_LINE);
    PALPATE_CHECK(!dotted->GetLegendVisibility());
    const Row now{ felt(pressed, "Deflection"), felt(pressed, "NormalForce") };
    PALPATE_CHECK(pointsOf(plotOf(chart, "Now")) == std::vector<Row>{ now });
  }
}

/// A curve that is valid at no depth is dotted from its beginning.
void checkNowhereValid()
{
  const Body body = unevenResponse(planeBody(20.0, 20), "sphere:1.6");
  body->GetPointData()->GetArray("ResponseValidity")->Fill(0.0);
  vtkNew<vtkLiveCharts> charts;
  charts->SetBody(body);
  PALPATE_CHECK(charts->ShowTip(probed(body, singleTip(0.37, 0.81, -0.7)), 0));
  vtkChartXY* chart = charts->GetCurvesChart();
  vtkPlot* solid = plotOf(chart, "Blend");
  PALPATE_CHECK(pointsOf(solid).empty());
  PALPATE_CHECK(pointsOf(chart->GetPlot(chart->GetPlotIndex(solid) + 1)).size() == Steps + 1);
}

/// When the tool leaves, the curves remain and the running point disappears.
void checkLeaving()
{
  const Body body = unevenResponse(planeBody(20.0, 20), "sphere:1.6");
  vtkNew<vtkLiveCharts> charts;
  charts->SetBody(body);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const double height : { 1.0, -0.7, 1.0 })
  {
    points->InsertNextPoint(1.0, 6.0, height);
  }
  const Body tips = Body::New();
  tips->SetPoints(points);
  const Body passed = probed(body, tips);
  vtkChartXY* chart = charts->GetCurvesChart();
  PALPATE_CHECK(charts->ShowTip(passed, 0));
  PALPATE_CHECK(chart->GetNumberOfPlots() == 0);
  PALPATE_CHECK(charts->ShowTip(passed, 1));
  const std::vector<Row> blend = curveOf(chart, "Blend");
  PALPATE_CHECK(blend.size() > Steps && pointsOf(plotOf(chart, "Now")).size() == 1);
  for (int i = 0; i < 2; ++i) // one tip at a time, then two tips at once
  {
    PALPATE_CHECK(charts->ShowTip(passed, 2));
    PALPATE_CHECK(curveOf(chart, "Blend") == blend && pointsOf(plotOf(chart, "Now")).empty());
    PALPATE_CHECK(charts->ShowTip(passed, 0));
  }
}

/// Cells before the triangles shift the cell ids but do not change the curves.
void checkOtherCells()
{
  const Body body = unevenResponse(planeBody(20.0, 20), "sphere:1.6");
  const Body more = Body::New();
  more->ShallowCopy(body);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 3 });
  vertices->InsertNextCell({ 5 });
  more->SetVerts(vertices);
  std::vector<std::vector<Row>> blends;
  for (const Body& each : { body, more })
  {
    vtkNew<vtkLiveCharts> charts;
    charts->SetBody(each);
    PALPATE_CHECK(charts->ShowTip(probed(each, singleTip(0.37, 0.81, -0.7)), 0));
    blends.push_back(curveOf(charts->GetCurvesChart(), "Blend"));
  }
  PALPATE_CHECK(blends[0] == blends[1]);
}

/// A point on the smooth surface has other area coordinates than its projection on the facet. At
/// the deflection of the contact, the interpolated curve must equal the force of the contact.
void checkSmooth()
{
  const Body body = unevenResponse(sphereBody(40.0, 3), "flat:1.6");
  vtkNew<vtkLiveCharts> charts;
  charts->SetBody(body);
  vtkNew<vtkToolContactProbe> probe;
  probe->SetInputData(0, body);
  probe->SetContactSurfaceToSmooth();
  constexpr int row = 15; // the row at 0.5 mm
  for (const auto& [x, y] : { Row{ 3.0, 8.0 }, Row{ -15.0, 6.0 }, Row{ 12.0, -21.0 } })
  {
    double tip[3] = { x, y, std::sqrt(39.5 * 39.5 - x * x - y * y) };
    for (int i = 0; i < 2; ++i) // the second time at exactly this deflection
    {
      probe->SetTipData(singleTip(tip[0], tip[1], tip[2]));
      probe->Update();
      vtkPointData* data = probe->GetOutput()->GetPointData();
      const double* contact = data->GetArray("ContactPoint")->GetTuple3(0);
      const double* normal = data->GetArray("Normal")->GetTuple3(0);
      for (int k = 0; k < 3; ++k)
      {
        tip[k] = contact[k] - Range * row / Steps * normal[k];
      }
    }
    PALPATE_CHECK_NEAR(felt(probe->GetOutput(), "Deflection"), 0.5, 1e-9);
    PALPATE_CHECK(charts->ShowTip(probe->GetOutput(), 0));
    const double force = felt(probe->GetOutput(), "NormalForce");
    const std::vector<Row> blend = curveOf(charts->GetCurvesChart(), "Blend");
    const auto at = std::find_if(blend.begin(), blend.end(),
      [](const Row& each) { return std::abs(each.first - 0.5) < 1e-9; });
    // The coordinates in the kernel have an error of 2e-6 mm on edges of 6 mm, over which the
    // modulus varies by a factor of three.
    PALPATE_CHECK(at != blend.end());
    PALPATE_CHECK_NEAR(at->second, force, 2e-6 * force);
  }
}

/// At a vertex, the interpolated curve of each tool is the curve of this vertex.
void checkCompared()
{
  const Body body = planeBody(20.0, 20);
  Body last = body;
  for (const auto& [name, tool] : { std::pair<const char*, const char*>{ "A", "flat:1.6" },
         { "B", "sphere:6.35" }, { "C", "cone:60" } })
  {
    vtkNew<vtkToolContactResponse> filter;
    filter->SetInputData(last);
    filter->SetTool(makeTool(tool));
    filter->SetResponseName(name);
    makePlain(filter);
    filter->Update();
    last = Body::New();
    last->ShallowCopy(filter->GetOutput());
  }
  vtkNew<vtkLiveCharts> charts;
  charts->SetBody(last);
  charts->SetResponseName("B");
  charts->AddComparedResponse("A");
  charts->AddComparedResponse("B", "the ball");
  charts->AddComparedResponse("C");
  const Body pressed = probed(last, singleTip(4.0, 4.0, -0.7), "B");
  PALPATE_CHECK(charts->ShowTip(pressed, 0));
  vtkChartXY* chart = charts->GetCurvesChart();
  PALPATE_CHECK(
    chart->GetNumberOfPlots() == 8); // each tool with its dotted part, memory, and the point
  const vtkIdType vertex = 12 * 21 + 12;
  const std::pair<std::string, const char*> labels[] = { { "A", nullptr }, { "B", "the ball" },
    { "C", nullptr } };
  for (const auto& [name, label] : labels)
  {
    auto* tool =
      vtkStringArray::SafeDownCast(last->GetFieldData()->GetAbstractArray((name + "Tool").c_str()));
    const std::string shown = label ? std::string(label) : std::string(tool->GetValue(0));
    checkCurve(curveOf(chart, shown), storedCurves(last, name, { vertex }), 1);
  }
  const Row now{ 0.7, felt(pressed, "NormalForce") };
  PALPATE_CHECK(pointsOf(plotOf(chart, "Now")) == std::vector<Row>{ now });
  charts->RemoveAllComparedResponses();
  PALPATE_CHECK(charts->ShowTip(pressed, 0));
  PALPATE_CHECK(curveOf(chart, "Blend").size() > Steps);

  charts->AddComparedResponse("D");
  Messages messages(charts);
  PALPATE_CHECK(!charts->ShowTip(pressed, 0));
  PALPATE_CHECK_TEXT(messages.takeErrors(), "'DSamples'");
}

/// A live session gives the same curves as a probe. Beyond the range the interpolated curve extends
/// to the depth of the tool.
void checkSession()
{
  const Body body = unevenResponse(planeBody(20.0, 20), "sphere:6.35");
  vtkNew<vtkHapticSession> session;
  session->SetBody(body);
  session->GetDevice()->SetPath(pressAndSlide(2.5));
  vtkNew<vtkLiveCharts> charts;
  charts->SetSession(session);
  PALPATE_CHECK(session->GetRecorder()->GetHistorySeconds() == charts->GetDuration());
  charts->Update(); // the session is not started, so there are no curves and no error
  PALPATE_CHECK(charts->GetCurvesChart()->GetNumberOfPlots() == 0);
  PALPATE_CHECK(session->Start());
  session->Step(1.7);
  charts->Update();
  PALPATE_CHECK(session->GetDeflection() > 2.4);
  vtkChartXY* chart = charts->GetCurvesChart();
  const std::vector<Row> blend = curveOf(chart, "Blend");
  PALPATE_CHECK(blend.back().first == session->GetDeflection());
  PALPATE_CHECK(pointsOf(plotOf(chart, "Now")) == std::vector<Row>{ blend.back() });
  double force[3];
  session->GetIdealForce(force);
  PALPATE_CHECK_NEAR(blend.back().second, vtkMath::Norm(force), 1e-9 * vtkMath::Norm(force));
  PALPATE_CHECK(chart->GetAxis(vtkAxis::BOTTOM)->GetMaximum() >= session->GetDeflection());
  PALPATE_CHECK(chart->GetAxis(vtkAxis::LEFT)->GetMaximum() >= blend.back().second);
  session->Stop();
  charts->Update();
  PALPATE_CHECK(pointsOf(plotOf(chart, "Now")).empty());
}

/// The force on a curve, between its two nearest rows. With 60 steps, chords of these curves are
/// below them by less than 1e-3 of the force at the depths of the tests.
constexpr double Chord = 1e-3;
double on(const std::vector<Row>& curve, double depth)
{
  for (std::size_t i = 1; i < curve.size(); ++i)
  {
    const auto& [from, low] = curve[i - 1];
    const auto& [to, high] = curve[i];
    if (from <= depth && depth <= to && from < to)
    {
      return low + (depth - from) / (to - from) * (high - low);
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// A tilted tool has a curve of its own, which contains the running point.
void checkTilted()
{
  constexpr double radius = 3.0;
  vtkNew<vtkToolContactResponse> filter;
  filter->SetInputData(planeBody(20.0, 8));
  filter->SetTool(makeTool("flat:3"));
  filter->SetPoissonRatio(0.0);
  filter->SetMaximumDeflection(1.0);
  filter->SetMaximumTilt(10.0);
  makePlain(filter);
  filter->Update();
  for (const bool compares : { false, true })
  {
    for (const double degrees : { 0.0, 5.0 })
    {
      const double tilt = vtkMath::RadiansFromDegrees(degrees);
      const double depth = 0.2 * radius - radius * std::sin(tilt); // of the tip
      const Body path =
        timedPath({ { 0.3, 0.7, 2.0, 0.0 }, { 0.3, 0.7, -depth, 0.5 }, { 0.3, 0.7, -depth, 0.7 } });
      vtkNew<vtkDoubleArray> axes;
      axes->SetName("ToolAxis");
      axes->SetNumberOfComponents(3);
      for (int i = 0; i < 3; ++i)
      {
        axes->InsertNextTuple3(std::sin(tilt), 0.0, std::cos(tilt));
      }
      path->GetPointData()->AddArray(axes);
      vtkNew<vtkHapticSession> session;
      session->SetBody(filter->GetOutput());
      session->GetDevice()->SetPath(path);
      vtkNew<vtkLiveCharts> charts;
      charts->SetSession(session);
      if (compares)
      {
        charts->AddComparedResponse("Response", "Tilted");
      }
      PALPATE_CHECK(session->Start());
      session->Step(0.6);
      charts->Update();
      vtkChartXY* chart = charts->GetCurvesChart();
      const Row now = pointsOf(plotOf(chart, "Now")).front();
      PALPATE_CHECK_NEAR(now.first, 0.2 * radius, 1e-6);
      const bool hasOwn = degrees > 0.0 || compares;
      if (!compares)
      {
        bool found = false;
        for (vtkIdType i = 0; i < chart->GetNumberOfPlots(); ++i)
        {
          found = found || std::string(chart->GetPlot(i)->GetLabel()) == "Tilted";
        }
        PALPATE_CHECK(found == hasOwn);
      }
      const std::vector<Row> curve = curveOf(chart, hasOwn ? "Tilted" : "Blend");
      PALPATE_CHECK_NEAR(on(curve, now.first), now.second, Chord * now.second);
      if (hasOwn && !compares) // tilt_bem.csv, D = 0.2 of the radius
      {
        PALPATE_CHECK_NEAR(now.second / on(curveOf(chart, "Blend"), now.first), 0.5757, 0.003);
      }
    }
  }
}

/// On a body that relaxes, a line leads from the slow force, which is on the curve, to the running
/// point. Without memory there is no such line.
void checkRelaxing()
{
  for (const bool relaxes : { true, false })
  {
    const auto session = slabSession(liverSlab(6.35, relaxes));
    vtkNew<vtkLiveCharts> charts;
    charts->SetSession(session);
    PALPATE_CHECK(session->Start());
    session->Step(SlabPress + SlabAbove);
    charts->Update();
    vtkChartXY* chart = charts->GetCurvesChart();
    const Row now = pointsOf(plotOf(chart, "Now")).front();
    const double slow = on(curveOf(chart, "Blend"), now.first);
    const std::vector<Row> memory = pointsOf(plotOf(chart, "Memory"));
    PALPATE_CHECK(plotOf(chart, "Memory")->GetVisible() == relaxes);
    PALPATE_CHECK(memory.size() == (relaxes ? 2U : 0U));
    PALPATE_CHECK_NEAR(now.second / slow, relaxes ? 1.514 : 1.0, 0.01); // as in TestRelaxingSession
    if (relaxes)
    {
      PALPATE_CHECK(memory[1] == now && memory[0].first == now.first);
      PALPATE_CHECK_NEAR(memory[0].second, slow, Chord * slow);
    }
    session->Stop();
    charts->Update();
    PALPATE_CHECK(pointsOf(plotOf(chart, "Memory")).empty());
  }
}
} // namespace

int TestLiveChartsCurves(int, char*[])
{
  checkTilted();
  checkRelaxing();
  checkFacets();
  checkNowhereValid();
  checkLeaving();
  checkOtherCells();
  checkSmooth();
  checkCompared();
  checkSession();
  return palpate::testing::result();
}

// SPDX-License-Identifier: BSD-3-Clause
// A measured body that relaxes: the slow response of any tool with its strengths and times, and
// loops compared with the readings. The forces are those of Lee and Radok.
#include "FilterChecks.h"
#include "MeasuredFiles.h"

#include "Identification/ClosedRelaxation.h"

#include "vtkFieldData.h"
#include "vtkMeasuredCurves.h"

#include <algorithm>

namespace
{
using namespace palpate::testing;

constexpr double Modulus = 0.05; // slow E*, MPa
constexpr double R = 6.35;
const char* const Tip = "paraboloid:6.35";

struct RelaxingSite
{
  const char* name;
  double x;
  palpate::PronySeries series;
};

palpate::PronySeries series(double p1, double p2)
{
  palpate::PronySeries made;
  made.add(p1, 0.1);
  made.add(p2, 2.0);
  return made;
}

RampAndHold testOf(const palpate::PronySeries& series)
{
  RampAndHold test;
  test.series = series;
  test.c = hertz(R, Modulus)(1.0);
  test.depth = 0.9; // a depth within small strain
  return test;
}

std::string writeHolds(
  const std::string& path, const std::vector<RelaxingSite>& sites, bool isTimed = true)
{
  std::ofstream file(path);
  file.precision(17);
  file << "# tool: " << Tip << "\nsite,x_mm,y_mm,z_mm,deflection_mm,force_N"
       << (isTimed ? ",time_s\n" : "\n");
  for (const RelaxingSite& site : sites)
  {
    const RampAndHold test = testOf(site.series);
    std::mt19937 random(4);
    const auto curve =
      timedCurve(rampAndHoldTimes(test.ramp, 20.0, 60, 140), test, 0.2, 1e-4 * test.c, random);
    for (std::size_t i = 0; i < curve.force.size(); ++i)
    {
      file << site.name << ',' << site.x << ",0,0," << curve.deflection[i] << ',' << curve.force[i];
      if (isTimed)
      {
        file << ',' << curve.time[i];
      }
      file << '\n';
    }
  }
  return path;
}

vtkDataArray* fieldArray(vtkMeasuredContactResponse* filter, const char* name)
{
  return filter->GetOutput()->GetFieldData()->GetArray(name);
}

vtkDataArray* array(vtkMeasuredContactResponse* filter, const char* name)
{
  return filter->GetOutput()->GetPointData()->GetArray(name);
}

void checkOneSite(const std::string& folder)
{
  const Body body = planeBody(12.0, 8);
  const std::string file = writeHolds(folder + "/holds.csv", { { "A", 0.0, series(0.6, 0.4) } });
  const MeasuredFilter filter = measure(body, file, "sphere:1.6");
  Messages messages(filter.Get());
  filter->Update();
  PALPATE_CHECK(messages.none());
  // The smallest assumed noise, 0.3 % of the force, gives an error of a few thousandths with 200
  // readings.
  const double found = siteNumber(filter, 0, "ReducedModulus (MPa)");
  PALPATE_CHECK_NEAR(found, Modulus, 2e-3 * Modulus);
  PALPATE_CHECK_NEAR(siteNumber(filter, 0, "ContactOffset (mm)"), 0.2, 1e-3);
  const std::array<double, 2> strengths = { 0.6, 0.4 };
  const std::array<double, 2> times = { 0.1, 2.0 };
  auto* strength = fieldArray(filter, "ResponseRelaxationStrength");
  auto* time = fieldArray(filter, "ResponseRelaxationTime");
  PALPATE_CHECK(strength != nullptr && time != nullptr);
  if (!strength || !time)
  {
    return;
  }
  PALPATE_CHECK(strength->GetNumberOfTuples() == 2 && time->GetNumberOfTuples() == 2);
  PALPATE_CHECK(strength->GetNumberOfComponents() == 1 && strength->IsA("vtkDoubleArray"));
  for (int i = 0; i < 2; ++i)
  {
    const auto branch = static_cast<std::size_t>(i);
    PALPATE_CHECK_NEAR(strength->GetTuple1(i), strengths[branch], 0.01);
    PALPATE_CHECK_NEAR(time->GetTuple1(i), times[branch], 0.02 * times[branch]);
    const std::string number = std::to_string(i + 1);
    const double p = siteNumber(filter, 0, ("RelaxationStrength " + number).c_str());
    PALPATE_CHECK(p == strength->GetTuple1(i));
    PALPATE_CHECK(siteNumber(filter, 0, ("RelaxationStrength " + number + " from").c_str()) < p);
    PALPATE_CHECK(siteNumber(filter, 0, ("RelaxationStrength " + number + " to").c_str()) > p);
    PALPATE_CHECK(
      siteNumber(filter, 0, ("RelaxationTime " + number + " to (s)").c_str()) > time->GetTuple1(i));
  }
  PALPATE_CHECK(array(filter, "ResponseLocalRelaxation") == nullptr);
  PALPATE_CHECK_NEAR(siteNumber(filter, 0, "ShortestTime (s)"), 0.05 / 15.0, 2e-4);
  PALPATE_CHECK_NEAR(siteNumber(filter, 0, "LongestTime (s)"), 20.0, 0.1);
  PALPATE_CHECK_TEXT(siteText(filter, 0, "Remark"), "times from", "are determined");
  auto* model = vtkStringArray::SafeDownCast(
    filter->GetOutput()->GetFieldData()->GetAbstractArray("ResponseModel"));
  PALPATE_CHECK_TEXT(model ? model->GetValue(0) : std::string(), "half-space, relaxing 0.",
    "determined", "identified from measured curves");

  // The stored curve is the slow curve, equal to that of the same body with given material.
  vtkNew<vtkToolContactResponse> given;
  given->SetInputData(body);
  given->SetTool(makeTool("sphere:1.6"));
  given->SetPoissonRatio(0.45);
  given->SetYoungsModulus(found * (1.0 - 0.45 * 0.45));
  given->Update();
  auto* slow = given->GetOutput()->GetPointData()->GetArray("ResponseForce");
  for (int k = 0; k < 8; ++k)
  {
    PALPATE_CHECK_NEAR(array(filter, "ResponseForce")->GetComponent(40, k),
      slow->GetComponent(40, k), 1e-6 * slow->GetComponent(40, k)); // stored as floats
  }
  // The uncertainty from the readings is stated and small.
  const double error = array(filter, "ResponseError")->GetComponent(40, 1);
  PALPATE_CHECK(error > 0.0 && error < 0.05);

  // The table contains the whole history, including the loop, in the order of time.
  auto* readings = vtkTable::SafeDownCast(filter->GetOutputDataObject(2));
  PALPATE_CHECK(readings->GetNumberOfRows() == 211);
  const RampAndHold test = testOf(series(0.6, 0.4));
  double before = -1.0;
  for (vtkIdType i = 0; i < readings->GetNumberOfRows(); ++i)
  {
    const double t = readings->GetValueByName(i, "Time (s)").ToDouble();
    PALPATE_CHECK(t >= before);
    before = t;
    PALPATE_CHECK_NEAR(readings->GetValueByName(i, "ModelForce (N)").ToDouble(),
      t > 0.0 ? test.forceAt(t) : 0.0, 5e-3 * test.c); // 0.3 % of the force
  }
  vtkNew<vtkMeasuredCurves> curves;
  curves->SetInputData(readings);
  curves->Update();
  for (vtkIdType i = 0; i < readings->GetNumberOfRows(); ++i)
  {
    PALPATE_CHECK(curves->GetOutput()->GetValueByName(i, "A model (N)").ToDouble() ==
      readings->GetValueByName(i, "ModelForce (N)").ToDouble());
  }
}

void checkTwoSites(const std::string& folder)
{
  const std::string file = writeHolds(
    folder + "/two-holds.csv", { { "A", -6.0, series(0.6, 0.4) }, { "B", 6.0, series(1.2, 0.2) } });
  const Body body = planeBody(30.0, 60);
  const MeasuredFilter filter = measure(body, file, "sphere:1.6");
  filter->SetReach(15.0);
  Messages messages(filter.Get());
  filter->Update();
  PALPATE_CHECK(messages.none());
  auto* local = array(filter, "ResponseLocalRelaxation");
  auto* mean = fieldArray(filter, "ResponseRelaxationStrength");
  PALPATE_CHECK(local != nullptr && mean != nullptr);
  if (!local || !mean)
  {
    return;
  }
  PALPATE_CHECK(local->IsA("vtkFloatArray") && local->GetNumberOfComponents() == 2);
  const auto at = [&](double x, int k)
  { return local->GetComponent(body->vtkDataSet::FindPoint(x, 0.0, 0.0), k); };
  PALPATE_CHECK_NEAR(at(-6.0, 0), 0.6, 0.02);
  PALPATE_CHECK_NEAR(at(-6.0, 1), 0.4, 0.02);
  PALPATE_CHECK_NEAR(at(6.0, 0), 1.2, 0.03);
  PALPATE_CHECK_NEAR(at(6.0, 1), 0.2, 0.02);
  PALPATE_CHECK_NEAR(at(0.0, 0), 0.9, 0.03); // half-way between the sites: the mean strength
  PALPATE_CHECK(at(29.0, 0) == 0.0);
  PALPATE_CHECK_NEAR(mean->GetTuple1(0), 0.9, 0.03);
  PALPATE_CHECK_NEAR(fieldArray(filter, "ResponseRelaxationTime")->GetTuple1(1), 2.0, 0.1);
}

void checkGiven(const std::string& folder)
{
  const std::string file = writeHolds(folder + "/holds.csv", { { "A", 0.0, series(0.6, 0.4) } });
  const MeasuredFilter filter = measure(planeBody(12.0, 8), file, "sphere:1.6");
  Messages messages(filter.Get());
  filter->AddRelaxation(0.6, 0.1);
  filter->AddRelaxation(0.4, 2.0);
  PALPATE_CHECK(filter->GetNumberOfRelaxations() == 2);
  PALPATE_CHECK(filter->GetRelaxationStrength(1) == 0.4 && filter->GetRelaxationTime(1) == 2.0);
  PALPATE_CHECK(filter->GetRelaxationTime(2) == 0.0);
  filter->Update();
  PALPATE_CHECK(messages.none());
  PALPATE_CHECK_NEAR(siteNumber(filter, 0, "ReducedModulus (MPa)"), Modulus, 1e-3 * Modulus);
  PALPATE_CHECK(fieldArray(filter, "ResponseRelaxationStrength")->GetTuple1(0) == 0.6);
  PALPATE_CHECK_TEXT(siteText(filter, 0, "Remark"), "given");
  filter->AddRelaxation(-0.4, 2.0);
  filter->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "relaxation 3", "-0.4");
  filter->ClearRelaxations();
  for (int i = 0; i < 5; ++i)
  {
    filter->AddRelaxation(0.1, 1.0);
  }
  filter->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "at most 4", "5");
  PALPATE_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
}

void checkWithoutTimes(const std::string& folder)
{
  const std::string file =
    writeHolds(folder + "/timeless.csv", { { "A", 0.0, series(0.6, 0.4) } }, false);
  const MeasuredFilter filter = measure(planeBody(12.0, 8), file, "sphere:1.6");
  Messages messages(filter.Get());
  filter->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "'A'", "hold", "time_s");
}

/// An elastic body has none of these arrays and columns.
void checkElastic(const std::string& folder)
{
  const std::string file =
    writeCurves(folder + "/elastic.csv", Tip, { { "A", { 0.0, 0.0, 0.0 }, hertz(R, Modulus) } });
  const MeasuredFilter filter = measure(planeBody(12.0, 8), file, "sphere:1.6");
  filter->Update();
  PALPATE_CHECK(fieldArray(filter, "ResponseRelaxationStrength") == nullptr);
  PALPATE_CHECK(fieldArray(filter, "ResponseRelaxationTime") == nullptr);
  for (int port = 1; port < 3; ++port)
  {
    auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(port));
    PALPATE_CHECK(table->GetNumberOfRows() > 0);
    for (const char* name : { "RelaxationTime 1 (s)", "Time (s)" })
    {
      PALPATE_CHECK(table->GetColumnByName(name) == nullptr);
    }
  }
}
} // namespace

int TestMeasuredRelaxation(int, char* arguments[])
{
  const std::string folder = arguments[1];
  checkOneSite(folder);
  checkTwoSites(folder);
  checkGiven(folder);
  checkWithoutTimes(folder);
  checkElastic(folder);
  return result();
}

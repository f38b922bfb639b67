// SPDX-License-Identifier: BSD-3-Clause
// Coupled tips that press at the same time, tips with an axis, the coupling arrays of a response,
// and the messages on invalid input.
#include "FilterChecks.h"
#include "TestBodies.h"

#include "Contact/Coupled/CoupledContacts.h"
#include "Response/BodyConversion.h"
#include "Response/FlatBodyConversion.h"
#include "vtkFieldData.h"
#include "vtkToolContactProbe.h"
#include "Mechanics/Numerics/Constants.h"

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace
{
using namespace palpate::testing;
using palpate::NotANumber;
using palpate::Pi;

constexpr double Modulus = 0.5 / (1.0 - 0.45 * 0.45); // E* of the plane, MPa
constexpr double Flat = 2.0;

using Response = vtkSmartPointer<vtkToolContactResponse>;

/// Response of a flat end of 2 mm on a half-space of 0.5 MPa, or on a layer of the given thickness.
Response coupledResponse(vtkPolyData* body, double layer = 0.0)
{
  Response response = filterOf(body, "flat:2", 1.0);
  response->SetYoungsModulus(0.5);
  response->SetPoissonRatio(0.45);
  response->SetLayerThickness(layer);
  response->CouplingOn();
  return response;
}

struct Tip
{
  double x, y, depth, time;
};

/// Tips in `lines` lines with equal numbers of points; single points if `lines` is 0.
Body tipsOf(const std::vector<Tip>& tips, std::size_t lines = 0, bool isInTime = false)
{
  auto data = Body::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> times;
  times->SetName("Time");
  vtkNew<vtkCellArray> cells;
  for (const Tip& tip : tips)
  {
    points->InsertNextPoint(tip.x, tip.y, -tip.depth);
    times->InsertNextValue(tip.time);
  }
  data->SetPoints(points);
  if (isInTime)
  {
    data->GetPointData()->AddArray(times);
  }
  const std::size_t each = lines > 0 ? tips.size() / lines : 0;
  for (std::size_t line = 0; line < lines; ++line)
  {
    cells->InsertNextCell(static_cast<int>(each));
    for (std::size_t i = 0; i < each; ++i)
    {
      cells->InsertCellPoint(static_cast<vtkIdType>(line * each + i));
    }
  }
  data->SetLines(cells);
  return data;
}

vtkSmartPointer<vtkToolContactProbe> probeOf(vtkPolyData* body, vtkPolyData* tips)
{
  auto probe = vtkSmartPointer<vtkToolContactProbe>::New();
  probe->SetInputData(body);
  probe->SetTipData(tips);
  probe->CoupledOn();
  return probe;
}

double forceOf(vtkToolContactProbe* probe, vtkIdType tip)
{
  return probe->GetOutput()->GetPointData()->GetArray("NormalForce")->GetTuple1(tip);
}

/// Force on the first of two flat ends at the distance r, with the depths d1 and d2, from the
/// linear system of both.
double firstOfTwo(double r, double d1, double d2)
{
  const double own = 1.0 / (2.0 * Modulus * Flat);
  const double other = 1.0 / (Pi * Modulus * r);
  return (own * d1 - other * d2) / (own * own - other * other);
}

void checkSinglePoints()
{
  Response response = coupledResponse(planeBody(30.0, 12));
  response->Update();
  const std::vector<Tip> tips = { { 1.1, 2.3, 0.5, 0.0 }, { 7.1, 2.3, 0.4, 0.0 },
    { 1.1, 2.3, 0.3, 2.5 }, { 9.1, 2.3, 0.5, 2.5 }, { 5.0, 5.2, 0.25, NotANumber } };
  {
    // Without Time both tips press at the same time. The curves are stored as floats.
    const auto probe = probeOf(response->GetOutput(), tipsOf({ tips[0], tips[1] }));
    probe->Update();
    PALPATE_CHECK_NEAR(forceOf(probe, 0), firstOfTwo(6.0, 0.5, 0.4), 1e-6);
    PALPATE_CHECK_NEAR(forceOf(probe, 1), firstOfTwo(6.0, 0.4, 0.5), 1e-6);
    probe->CoupledOff();
    probe->Update();
    PALPATE_CHECK_NEAR(forceOf(probe, 0), 2.0 * Modulus * Flat * 0.5, 1e-6);
  }
  {
    const auto probe =
      probeOf(response->GetOutput(), tipsOf({ tips[0], tips[2], tips[1], tips[3] }, 0, true));
    probe->Update();
    PALPATE_CHECK_NEAR(forceOf(probe, 0), firstOfTwo(6.0, 0.5, 0.4), 1e-6);
    PALPATE_CHECK_NEAR(forceOf(probe, 2), firstOfTwo(6.0, 0.4, 0.5), 1e-6);
    PALPATE_CHECK_NEAR(forceOf(probe, 1), firstOfTwo(8.0, 0.3, 0.5), 1e-6);
    PALPATE_CHECK_NEAR(forceOf(probe, 3), firstOfTwo(8.0, 0.5, 0.3), 1e-6);
  }
  const auto probe = probeOf(response->GetOutput(), tipsOf(tips, 0, true));
  Messages messages(probe.Get());
  probe->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "'Time' is nan at point 4");
  probe->SetTipData(tipsOf(std::vector<Tip>(65, tips[0])));
  probe->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "65 single points at one time, but at most 64");
}

void checkPolylines()
{
  Response response = coupledResponse(planeBody(30.0, 12));
  response->Update();
  // The second tip begins 1 s later and is 0.2 mm deeper at each step. Without Time both begin at
  // the same time.
  const std::vector<Tip> tips = { { 1.1, 2.3, 0.3, 0.0 }, { 1.1, 2.3, 0.4, 1.0 },
    { 1.1, 2.3, 0.5, 2.0 }, { 7.1, 2.3, 0.5, 1.0 }, { 7.1, 2.3, 0.6, 2.0 },
    { 7.1, 2.3, 0.7, 3.0 } };
  const auto probe = probeOf(response->GetOutput(), tipsOf(tips, 2));
  probe->Update();
  for (vtkIdType i = 0; i < 3; ++i)
  {
    const double first = 0.3 + 0.1 * static_cast<double>(i);
    PALPATE_CHECK_NEAR(forceOf(probe, i), firstOfTwo(6.0, first, first + 0.2), 1e-6);
    PALPATE_CHECK_NEAR(forceOf(probe, 3 + i), firstOfTwo(6.0, first + 0.2, first), 1e-6);
  }
  probe->SetTipData(tipsOf(tips, 2, true));
  probe->Update();
  const double alone = 2.0 * Modulus * Flat;
  PALPATE_CHECK_NEAR(forceOf(probe, 0), 0.3 * alone, 1e-6);
  PALPATE_CHECK_NEAR(forceOf(probe, 1), firstOfTwo(6.0, 0.4, 0.5), 1e-6);
  PALPATE_CHECK_NEAR(forceOf(probe, 2), firstOfTwo(6.0, 0.5, 0.6), 1e-6);
  PALPATE_CHECK_NEAR(forceOf(probe, 3), firstOfTwo(6.0, 0.5, 0.4), 1e-6);
  PALPATE_CHECK_NEAR(forceOf(probe, 5), 0.7 * alone, 1e-6);

  Messages messages(probe.Get());
  std::vector<Tip> wrong = tips;
  wrong[4].time = 1.0;
  probe->SetTipData(tipsOf(wrong, 2, true));
  probe->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "polyline 1 has two points at Time 1, 3 and 4");
  wrong[4].time = 1.5;
  probe->SetTipData(tipsOf(wrong, 2, true));
  probe->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "polyline 0 has no point at Time 1.5");
  probe->SetTipData(tipsOf(std::vector<Tip>(65, tips[0]), 65));
  probe->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "65 polylines, but at most 64");
}

void checkLayersAndVaryingBodies(const std::string& directory)
{
  // On a bonded layer, at a distance of three thicknesses, the surface bulges next to each tip.
  Response layer = coupledResponse(planeBody(30.0, 12), 3.0);
  layer->Update();
  const auto probe =
    probeOf(layer->GetOutput(), tipsOf({ { 1.1, 2.3, 0.3, 0.0 }, { 10.1, 2.3, 0.3, 0.0 } }));
  probe->Update();
  const double together = forceOf(probe, 0);
  probe->CoupledOff();
  probe->Update();
  PALPATE_CHECK(together > forceOf(probe, 0) && together < 1.02 * forceOf(probe, 0));

  // Modulus and thickness per point. A file restores them to the bit.
  Body plane = planeBody(30.0, 12);
  vtkNew<vtkDoubleArray> young;
  young->SetName("E");
  vtkNew<vtkDoubleArray> thickness;
  thickness->SetName("h");
  vtkNew<vtkDoubleArray> modes;
  modes->SetName("CouplingModes");
  modes->SetNumberOfComponents(2);
  vtkNew<vtkDoubleArray> compliance;
  compliance->SetName("C");
  for (vtkIdType i = 0; i < plane->GetNumberOfPoints(); ++i)
  {
    const double x = plane->GetPoint(i)[0];
    young->InsertNextValue(0.5 + 0.01 * x);
    thickness->InsertNextValue(4.0 + 0.05 * x);
    modes->InsertNextTuple2(0.5 + 0.01 * x, -0.1);
    compliance->InsertNextValue(0.7);
  }
  for (vtkDataArray* array : { young.Get(), thickness.Get(), modes.Get(), compliance.Get() })
  {
    plane->GetPointData()->AddArray(array);
  }
  Response varied = coupledResponse(plane, 4.0);
  varied->SetInputArrayToProcess(0, 0, 0, 0, "E");
  varied->SetInputArrayToProcess(1, 0, 0, 0, "h");
  Messages messages(varied.Get());
  varied->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "'CouplingModes'", "no global compliance");
  varied->SetInputArrayToProcess(2, 0, 0, 0, "C");
  varied->ComplianceExcludesLayerOn();
  varied->Update();
  PALPATE_CHECK(messages.none());
  std::string error;
  palpate::ResponseArrays arrays;
  PALPATE_CHECK(palpate::viewResponse(varied->GetOutput(), "Response", arrays, error));
  PALPATE_CHECK_NEAR(static_cast<double>(arrays.coupling.localModulus[5]) * (1.0 - 0.45 * 0.45),
    young->GetValue(5), 1e-6); // 1e-6: stored as floats
  PALPATE_CHECK_NEAR(
    static_cast<double>(arrays.coupling.localThickness[5]), thickness->GetValue(5), 1e-6);
  PALPATE_CHECK(arrays.coupling.modeCount == 2 && arrays.coupling.knots);
  PALPATE_CHECK_NEAR(
    static_cast<double>(arrays.coupling.modes[2 * 5]), modes->GetComponent(5, 0), 1e-6);

  const std::string path = directory + "/coupled.palpate";
  PALPATE_CHECK(palpate::writeFlatBody(varied->GetOutput(), "Response", path).empty());
  const auto read = palpate::readFlatBody(path, "Response", error);
  PALPATE_CHECK(read && error.empty());
  std::remove(path.c_str());
  const Body tips = tipsOf({ { 1.1, 2.3, 0.3, 0.0 }, { 6.1, 2.3, 0.3, 0.0 } });
  const auto of = probeOf(varied->GetOutput(), tips);
  const auto ofFile = probeOf(read, tips);
  of->Update();
  ofFile->Update();
  PALPATE_CHECK(forceOf(of, 0) == forceOf(ofFile, 0) && forceOf(of, 1) == forceOf(ofFile, 1));
  PALPATE_CHECK(forceOf(of, 0) > 0.0);
}

void checkFaults()
{
  Response response = coupledResponse(planeBody(30.0, 12));
  response->CouplingOff();
  response->Update();
  const Body tips = tipsOf({ { 1.1, 2.3, 0.5, 0.0 }, { 7.1, 2.3, 0.4, 0.0 } });
  const auto probe = probeOf(response->GetOutput(), tips);
  Messages messages(probe.Get());
  probe->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Coupled is on", "'ResponseCoupling' is missing");

  response->CouplingOn();
  response->Update();
  const auto says = [&](const auto& change, std::initializer_list<const char*> words)
  {
    Body body = Body::New();
    body->DeepCopy(response->GetOutput());
    change(body.Get());
    probe->SetInputData(body);
    probe->Update();
    checkText(messages.takeErrors(), words, __FILE__, __LINE__);
  };
  const auto lawOf = [](vtkPolyData* body)
  { return vtkDoubleArray::SafeDownCast(body->GetFieldData()->GetArray("ResponseCoupling")); };
  says([&](vtkPolyData* body) { lawOf(body)->SetComponent(0, 0, -1.0); },
    { "reduced modulus", "but is -1" });
  says([&](vtkPolyData* body) { lawOf(body)->SetNumberOfTuples(7); },
    { "'ResponseCoupling'", "1 or 80 tuples", "7 tuples" });
  says(
    [&](vtkPolyData* body)
    {
      vtkNew<vtkFloatArray> modulus;
      modulus->SetName("ResponseCouplingModulus");
      modulus->SetNumberOfTuples(body->GetNumberOfPoints());
      modulus->FillValue(1.0F);
      modulus->SetValue(11, 0.0F);
      body->GetPointData()->AddArray(modulus);
    },
    { "reduced modulus (MPa) of point 11", "but is 0" });
  says(
    [&](vtkPolyData* body)
    {
      vtkNew<vtkDoubleArray> modes;
      modes->SetName("ResponseCouplingModes");
      modes->SetNumberOfTuples(body->GetNumberOfPoints());
      body->GetPointData()->AddArray(modes);
    },
    { "'ResponseCouplingModes'", "must be float" });
  says(
    [&](vtkPolyData* body)
    {
      vtkNew<vtkFloatArray> modulus;
      modulus->SetName("ResponseCouplingModulus");
      body->GetPointData()->AddArray(modulus);
      body->GetFieldData()->RemoveArray("ResponseCoupling");
    },
    { "'ResponseCoupling' is missing, but 'ResponseCouplingModulus' is there" });

  Body mixed = planeBody(30.0, 12);
  vtkNew<vtkDoubleArray> thickness;
  thickness->SetName("h");
  thickness->SetNumberOfTuples(mixed->GetNumberOfPoints());
  thickness->FillValue(3.0);
  thickness->SetValue(4, 0.0);
  mixed->GetPointData()->AddArray(thickness);
  Response partly = coupledResponse(mixed);
  partly->SetInputArrayToProcess(1, 0, 0, 0, "h");
  Messages ofResponse(partly.Get());
  partly->Update();
  PALPATE_CHECK_TEXT(ofResponse.takeErrors(), "layers everywhere or nowhere");
}

void checkAxes()
{
  Response response = coupledResponse(planeBody(30.0, 12));
  response->Update();
  Body tips = tipsOf({ { 1.1, 2.3, 0.5, 0.0 }, { 7.1, 2.3, 0.4, 0.0 } });
  const auto probe = probeOf(response->GetOutput(), tips);
  probe->CoupledOff();
  probe->Update();
  PALPATE_CHECK(!probe->GetOutput()->GetPointData()->HasArray("Torque"));
  vtkNew<vtkDoubleArray> axes;
  axes->SetName("ToolAxis");
  axes->SetNumberOfComponents(3);
  axes->InsertNextTuple3(0.0, 0.0, 2.0);
  axes->InsertNextTuple3(0.0, 0.0, 1.0);
  tips->GetPointData()->AddArray(axes);
  tips->Modified();
  for (const bool together : { false, true })
  {
    probe->SetCoupled(together);
    probe->Update();
    vtkPointData* felt = probe->GetOutput()->GetPointData();
    // An axis along the normal means no tilt, and no torque about the tip of a round tool.
    PALPATE_CHECK(felt->GetArray("Torque")->GetNumberOfComponents() == 3);
    PALPATE_CHECK_NEAR(felt->GetArray("Torque")->GetMaxNorm(), 0.0, 1e-9);
    PALPATE_CHECK_NEAR(felt->GetArray("Tilt")->GetTuple1(0), 0.0, 1e-5);
    PALPATE_CHECK(forceOf(probe, 0) > 0.0);
  }
  Messages messages(probe.Get());
  for (const double bad : { 0.0, NotANumber })
  {
    axes->SetTuple3(1, 0.0, 0.0, bad);
    tips->Modified();
    probe->Update();
    PALPATE_CHECK_TEXT(messages.takeErrors(), "'ToolAxis' is (0, 0, ", "at point 1");
  }
  axes->SetNumberOfComponents(2);
  tips->Modified();
  probe->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "'ToolAxis' must hold three numbers per point");
}
} // namespace

int TestCoupledProbe(int argc, char* argv[])
{
  checkSinglePoints();
  checkPolylines();
  checkLayersAndVaryingBodies(argc > 1 ? argv[1] : ".");
  checkFaults();
  checkAxes();
  return palpate::testing::result();
}

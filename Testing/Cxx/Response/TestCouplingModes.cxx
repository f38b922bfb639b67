// SPDX-License-Identifier: BSD-3-Clause
// Two fingers on bodies that bend: on a strip held at one end, against beam theory, and on opposite
// sides of a plate held at its rim, against the solution for one finger.
#include "FilterChecks.h"
#include "TestBodies.h"
#include "VolumeBlock.h"

#include "vtkElasticCompliance.h"
#include "vtkToolContactProbe.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <string>

namespace
{
using namespace palpate::testing;

constexpr double Young = 10.0; // MPa
constexpr double Poisson = 0.3;

vtkSmartPointer<vtkElasticCompliance> solved(vtkUnstructuredGrid* grid, int modes)
{
  auto filter = vtkSmartPointer<vtkElasticCompliance>::New();
  filter->SetInputData(grid);
  filter->SetYoungsModulus(Young);
  filter->SetPoissonRatio(Poisson);
  filter->SetNumberOfCouplingModes(modes);
  return filter;
}

/// The response of a ball of 2 mm on the body, in series with the compliance of the body, with
/// coupling.
Body pressed(vtkPolyData* body)
{
  auto response = filterOf(body, "sphere:2", 1.0);
  response->SetYoungsModulus(Young);
  response->SetPoissonRatio(Poisson);
  response->SetInputArrayToProcess(2, 0, 0, 0, "GlobalCompliance");
  response->SetCurvatureCorrection(false);
  response->CouplingOn();
  response->Update();
  return response->GetOutput();
}

/// Normal forces of two tips at these places, pressed together or one at a time.
std::array<double, 2> forces(
  vtkPolyData* body, const std::array<std::array<double, 3>, 2>& tips, bool together)
{
  auto data = Body::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& tip : tips)
  {
    points->InsertNextPoint(tip.data());
  }
  data->SetPoints(points);
  vtkNew<vtkToolContactProbe> probe;
  probe->SetInputData(body);
  probe->SetTipData(data);
  probe->SetCoupled(together);
  probe->Update();
  vtkDataArray* felt = probe->GetOutput()->GetPointData()->GetArray("NormalForce");
  return { felt->GetTuple1(0), felt->GetTuple1(1) };
}

double between(vtkPolyData* body, vtkIdType one, vtkIdType other)
{
  vtkDataArray* modes = body->GetPointData()->GetArray("CouplingModes");
  double sum = 0.0;
  for (int m = 0; m < modes->GetNumberOfComponents(); ++m)
  {
    sum += modes->GetComponent(one, m) * modes->GetComponent(other, m);
  }
  return sum;
}

/// Deflection of a strip of length × 4 × 4 mm at x under 1 N at a >= x: bending and shear.
double beam(double x, double a)
{
  const double inertia = 64.0 * 4.0 / 12.0;
  const double shear = Young / (2.0 * (1.0 + Poisson)) * 16.0 * 5.0 / 6.0;
  return x * x * (3.0 * a - x) / (6.0 * Young * inertia) + x / shear;
}

void checkStrip()
{
  const Grid grid = voxels(30, 4, 4, [](int i, int) { return i == 0; });
  const auto filter = solved(grid, 4);
  filter->Update();
  vtkPolyData* body = filter->GetOutput();
  std::cout << "strip: modes neglect " << filter->GetNeglectedByCouplingModes() << std::endl;
  PALPATE_CHECK(filter->GetNeglectedByCouplingModes() < 0.01);
  const std::array<double, 3> far = { 27.0, 2.0, 4.0 };
  const std::array<double, 3> near = { 15.0, 2.0, 4.0 };
  const std::array<double, 3> under = { 15.0, 2.0, 0.0 };
  const auto at = [body](const std::array<double, 3>& x)
  { return body->FindPoint(x[0], x[1], x[2]); };
  // 3 %: the beam is only seven times as long as thick, and the elements do not clamp its end
  // completely.
  PALPATE_CHECK_NEAR(between(body, at(near), at(far)) / beam(15.0, 27.0), 1.0, 0.03);
  PALPATE_CHECK_NEAR(between(body, at(under), at(far)) / beam(15.0, 27.0), -1.0, 0.03);

  // The two dents are small compared with the bending, which by beam theory is C F. Hertz's dents
  // add a few per cent of the depth.
  const Body whole = pressed(body);
  const double depth = 0.2;
  const std::array<std::array<double, 3>, 2> tips = { { { 27.0, 2.0, 4.0 - depth },
    { 15.0, 2.0, 4.0 - depth } } };
  const auto felt = forces(whole, tips, true);
  const auto alone = forces(whole, tips, false);
  const double c11 = beam(27.0, 27.0);
  const double c12 = beam(15.0, 27.0);
  const double c22 = beam(15.0, 15.0);
  const double reduced = Young / (1.0 - Poisson * Poisson);
  const auto dent = [reduced](double force)
  {
    return force > 0.0 ? std::pow(0.75 * force / (reduced * std::sqrt(2.0)), 2.0 / 3.0)
                       : 0.0; // Hertz's law
  };
  PALPATE_CHECK_NEAR(alone[0] * c11 + dent(alone[0]), depth, 0.04 * depth);
  PALPATE_CHECK_NEAR(alone[1] * c22 + dent(alone[1]), depth, 0.04 * depth);
  // The tip near the support lowers the strip below the tip at the end, which therefore has no
  // force.
  PALPATE_CHECK(c12 * alone[0] < depth && c12 / c22 * depth > depth);
  PALPATE_CHECK(felt[0] == 0.0);
  PALPATE_CHECK_NEAR(felt[1], alone[1], 1e-9);
  // Here the tip at the end is deeper than the bending by the other tip, so both press.
  const std::array<std::array<double, 3>, 2> both = { { { 27.0, 2.0, 3.5 }, { 15.0, 2.0, 3.8 } } };
  const auto pair = forces(whole, both, true);
  PALPATE_CHECK(pair[0] > 0.0 && pair[1] > 0.0);
  PALPATE_CHECK_NEAR(pair[0] * c11 + pair[1] * c12 + dent(pair[0]), 0.5, 0.04 * 0.5);
  PALPATE_CHECK_NEAR(pair[0] * c12 + pair[1] * c22 + dent(pair[1]), 0.2, 0.04 * 0.5);
}

void checkPlate()
{
  constexpr int side = 16;
  const Grid grid =
    voxels(side, side, 2, [](int i, int j) { return i == 0 || j == 0 || i == side || j == side; });
  const auto filter = solved(grid, 12);
  filter->Update();
  const std::array<double, 3> above = { 8.0, 8.0, 2.0 };
  const std::array<double, 3> below = { 8.0, 8.0, 0.0 };
  const vtkIdType top = filter->GetOutput()->FindPoint(above[0], above[1], above[2]);
  const vtkIdType bottom = filter->GetOutput()->FindPoint(below[0], below[1], below[2]);
  filter->SetLoadedPoint(top);
  filter->Update();
  vtkPolyData* body = filter->GetOutput();
  std::cout << "plate: modes neglect " << filter->GetNeglectedByCouplingModes() << std::endl;
  PALPATE_CHECK(filter->GetNeglectedByCouplingModes() < 0.1);
  // The full solution under the upper finger gives the motion at the lower finger, which is
  // outward.
  const double moved =
    body->GetPointData()->GetArray("LoadedDisplacement")->GetComponent(bottom, 2);
  PALPATE_CHECK(moved < 0.0);
  PALPATE_CHECK_NEAR(
    between(body, top, bottom) / moved, 1.0, 0.1); // tolerance: the part that the modes neglect

  // Opposite fingers do not bend the plate. Each presses as on a plate that is held below the
  // finger.
  const Body whole = pressed(body);
  const std::array<std::array<double, 3>, 2> tips = { { { 8.0, 8.0, 1.8 }, { 8.0, 8.0, 0.2 } } };
  const auto felt = forces(whole, tips, true);
  const auto alone = forces(whole, tips, false);
  const double compliance = body->GetPointData()->GetArray("GlobalCompliance")->GetTuple1(top);
  const double reduced = Young / (1.0 - Poisson * Poisson);
  const auto local = [reduced](double force)
  { return std::pow(0.75 * force / (reduced * std::sqrt(2.0)), 2.0 / 3.0); };
  // Closed form by Hertz and the compliances: δ = δ(F) + (C_11 + C_12) F, with C_12 from the modes.
  // The tolerance covers floats and curves between eight samples.
  const double modes = between(body, top, bottom);
  PALPATE_CHECK_NEAR(local(alone[0]) + compliance * alone[0], 0.2, 0.002);
  PALPATE_CHECK_NEAR(local(felt[0]) + (compliance + modes) * felt[0], 0.2, 0.002);
  // With C_12 of the full solution the force would be larger, because C_11 + C_12 is the difference
  // of two large numbers.
  PALPATE_CHECK(local(felt[0]) + (compliance + moved) * felt[0] < 0.2);
  PALPATE_CHECK_NEAR(felt[0], felt[1], 0.02 * felt[0]); // the plate is symmetric
  PALPATE_CHECK(felt[0] > 3.0 * alone[0]);
}

// Modes with a larger compliance than the body, for example the modes of another body, would let
// two opposite fingers sink in without limit. The effect of the modes is limited to the compliance
// of the response.
void checkModesThatDoNotFit()
{
  Body box = boxBody(5.0, 5.0, 1.0, 8);
  vtkNew<vtkDoubleArray> compliance;
  compliance->SetName("GlobalCompliance");
  vtkNew<vtkDoubleArray> modes;
  modes->SetName("CouplingModes");
  for (vtkIdType i = 0; i < box->GetNumberOfPoints(); ++i)
  {
    compliance->InsertNextValue(0.2);
    modes->InsertNextValue(box->GetPoint(i)[2] > 0.0 ? 2.0 : -2.0);
  }
  box->GetPointData()->AddArray(compliance);
  box->GetPointData()->AddArray(modes);
  const Body whole = pressed(box);
  vtkDataArray* kept = whole->GetPointData()->GetArray("ResponseCouplingModes");
  const vtkIdType top = whole->FindPoint(0.0, 0.0, 1.0);
  const vtkIdType bottom = whole->FindPoint(0.0, 0.0, -1.0);
  // 0.2 mm/N, plus a third of the dent's compliance at the last sample: 2E*a by Hertz, where a is
  // at most that at the depth.
  const double square = kept->GetTuple1(top) * kept->GetTuple1(top);
  const double dent = 0.5 * (1.0 - Poisson * Poisson) / Young;
  PALPATE_CHECK(square > 0.2 && square < 0.2 + 1.5 * dent);
  PALPATE_CHECK_NEAR(kept->GetTuple1(bottom), -kept->GetTuple1(top), 0.2 * std::sqrt(square));
  const auto felt = forces(whole, { { { 0.1, 0.2, 0.8 }, { 0.1, 0.2, -0.8 } } }, true);
  const auto alone = forces(whole, { { { 0.1, 0.2, 0.8 }, { 0.1, 0.2, -0.8 } } }, false);
  PALPATE_CHECK(felt[0] > alone[0] && felt[0] < 100.0 * alone[0]);
}

void checkFaults()
{
  const Grid grid = voxels(6, 4, 4, [](int i, int) { return i == 0; });
  const auto filter = solved(grid, 17);
  Messages messages(filter.Get());
  filter->Update();
  PALPATE_CHECK_TEXT(
    messages.takeErrors(), "Number Of Coupling Modes must lie between 0 and 16, but is 17");
  filter->SetNumberOfCouplingModes(0);
  filter->Update();
  PALPATE_CHECK(messages.none());
  PALPATE_CHECK(!filter->GetOutput()->GetPointData()->HasArray("CouplingModes"));
  PALPATE_CHECK(filter->GetNeglectedByCouplingModes() == 0.0);
  filter->SetNumberOfCouplingModes(2);
  const AbortAfter abort(filter, 0.92);
  filter->Update();
  PALPATE_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
}
} // namespace

int TestCouplingModes(int, char*[])
{
  checkStrip();
  checkPlate();
  checkModesThatDoNotFit();
  checkFaults();
  return palpate::testing::result();
}

// SPDX-License-Identifier: BSD-3-Clause
// Friction along polylines over a plate, where every model has a closed form. Single tips have no
// friction. Time has no effect.
#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkToolContactProbe.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace
{
using namespace palpate::testing;

constexpr double Friction = 0.5;  // Coulomb's coefficient
constexpr double Stiffness = 8.0; // N/mm
constexpr double Depth = 1.0;     // mm
constexpr double Young = 3.45;    // E of withResponse at ν = 0, MPa

/// A plate with the response of a paraboloid, whose law is stored exactly except for float
/// rounding.
Body plate()
{
  return withResponse(planeBody(10.0, 10), "paraboloid:2");
}

double normalForce(double depth)
{
  return makeTool("paraboloid:2")->GetForce(depth, Young);
}

/// Adds tips at a depth of `Depth` and in equal steps of x from `from` to `to`. All tips form one
/// line.
void drag(vtkPolyData* tips, double from, double to, int steps)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  if (tips->GetPoints())
  {
    points->DeepCopy(tips->GetPoints());
  }
  for (int i = points->GetNumberOfPoints() > 0 ? 1 : 0; i <= steps; ++i)
  {
    points->InsertNextPoint(from + (to - from) * i / steps, 0.3, -Depth);
  }
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(static_cast<int>(points->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    line->InsertCellPoint(i);
  }
  tips->SetPoints(points);
  tips->SetLines(line);
}

vtkSmartPointer<vtkToolContactProbe> makeProbe(vtkPolyData* body, vtkPolyData* tips, int model)
{
  auto probe = vtkSmartPointer<vtkToolContactProbe>::New();
  probe->SetInputData(body);
  probe->SetTipData(tips);
  probe->SetForceFormToNormalizedDirection();
  probe->SetContactSurfaceToFacets();
  probe->SetFrictionCoefficient(Friction);
  probe->SetFrictionModel(model);
  probe->SetTangentialStiffness(Stiffness);
  return probe;
}

double frictionAt(vtkToolContactProbe* probe, vtkIdType tip)
{
  probe->Update();
  double f[3];
  probe->GetOutput()->GetPointData()->GetArray("FrictionForce")->GetTuple(tip, f);
  // On a plane friction is along x, except for the rounding of 3 N in the transported axes.
  PALPATE_CHECK(std::abs(f[1]) < 1e-14 && std::abs(f[2]) < 1e-14);
  return f[0];
}

int stateAt(vtkToolContactProbe* probe, vtkIdType tip)
{
  probe->Update();
  return static_cast<int>(
    probe->GetOutput()->GetPointData()->GetArray("ContactState")->GetTuple1(tip));
}

/// Elastic up to the breakaway, then sliding at Coulomb's limit, and elastic again in the opposite
/// direction.
void checkElastoPlastic(vtkPolyData* body)
{
  const double limit = Friction * normalForce(Depth);
  const double elastic = limit / Stiffness; // 0.41 mm
  Body tips = Body::New();
  drag(tips, 0.0, 0.75 * elastic, 5);
  drag(tips, 0.75 * elastic, 3.0 * elastic, 10);
  drag(tips, 3.0 * elastic, 2.0 * elastic, 5);
  const auto probe = makeProbe(body, tips, vtkToolContactProbe::ElastoPlastic);
  for (vtkIdType i = 0; i <= 5; ++i)
  {
    PALPATE_CHECK_NEAR(frictionAt(probe, i), -Stiffness * tips->GetPoint(i)[0], 1e-12);
    PALPATE_CHECK(stateAt(probe, i) == 1);
  }
  PALPATE_CHECK_NEAR(frictionAt(probe, 15), -limit, 1e-6 * limit); // the law is stored as floats
  PALPATE_CHECK(stateAt(probe, 15) == 2);
  for (vtkIdType i = 16; i <= 20; ++i)
  {
    const double back = tips->GetPoint(15)[0] - tips->GetPoint(i)[0];
    PALPATE_CHECK_NEAR(frictionAt(probe, i), -limit + Stiffness * back, 1e-6 * limit);
    PALPATE_CHECK(stateAt(probe, i) == 1);
  }
  // Force is the sum of normal force and friction, and friction is tangential.
  vtkPointData* felt = probe->GetOutput()->GetPointData();
  for (vtkIdType i = 0; i < tips->GetNumberOfPoints(); ++i)
  {
    double force[3];
    felt->GetArray("Force")->GetTuple(i, force);
    PALPATE_CHECK_NEAR(force[0], frictionAt(probe, i), 1e-14);
    PALPATE_CHECK_NEAR(force[2], felt->GetArray("NormalForce")->GetTuple1(i), 1e-14);
  }
  // The same path in about twenty times as many steps.
  Body finer = Body::New();
  drag(finer, 0.0, 3.0 * elastic, 300);
  drag(finer, 3.0 * elastic, 2.0 * elastic, 100);
  const auto fine = makeProbe(body, finer, vtkToolContactProbe::ElastoPlastic);
  PALPATE_CHECK_NEAR(frictionAt(fine, 400), frictionAt(probe, 20), 1e-9 * limit);

  // Without breakaway the contact creeps below the limit. With a breakaway of 1 it either sticks or
  // slides.
  probe->SetFrictionBreakaway(0.0);
  PALPATE_CHECK(frictionAt(probe, 5) > -0.9999 * 0.75 * limit);
  probe->SetFrictionBreakaway(1.0);
  probe->SetFrictionStickRadius(1.0);
  Body close = Body::New();
  drag(close, 0.0, 0.99 * elastic, 3);
  probe->SetTipData(close);
  PALPATE_CHECK_NEAR(frictionAt(probe, 3), -0.99 * limit, 1e-6 * limit);
  PALPATE_CHECK(stateAt(probe, 3) == 1);
}

/// Dahl's exponential law: z = z_max (1 - e^(-u/z_max)).
void checkDahl(vtkPolyData* body)
{
  const double limit = Friction * normalForce(Depth);
  Body tips = Body::New();
  drag(tips, 0.0, 1.0, 7);
  const auto probe = makeProbe(body, tips, vtkToolContactProbe::Dahl);
  for (vtkIdType i = 0; i <= 7; ++i)
  {
    const double u = tips->GetPoint(i)[0];
    PALPATE_CHECK_NEAR(
      frictionAt(probe, i), -limit * (1.0 - std::exp(-u * Stiffness / limit)), 1e-6 * limit);
  }
}

/// Jaeger's and Ciavarella's law: Q(u) = μ [f(δ) - f(δ - u/(μc))], c = (2-ν)/(2(1-ν)).
void checkShapeDerived(vtkPolyData* body)
{
  for (const double poisson : { 0.0, 0.3, 0.5 })
  {
    const double ratio = (2.0 - poisson) / (2.0 * (1.0 - poisson));
    const double slip = Friction * ratio * Depth;
    Body tips = Body::New();
    drag(tips, 0.0, 1.2 * slip, 12);
    const auto probe = makeProbe(body, tips, vtkToolContactProbe::ShapeDerived);
    probe->SetPoissonRatio(poisson);
    for (vtkIdType i = 0; i <= 12; ++i)
    {
      const double left = std::max(0.0, Depth - tips->GetPoint(i)[0] / (Friction * ratio));
      const double expected = -Friction * (normalForce(Depth) - normalForce(left));
      // Friction.h states the number of springs and the error. If half of the range is used, the
      // error is at most 3e-3 of the limit.
      PALPATE_CHECK_NEAR(frictionAt(probe, i), expected, 3e-3 * Friction * normalForce(Depth));
      // tip 10 is at the limit itself
      PALPATE_CHECK(i == 10 || stateAt(probe, i) == (i < 10 ? 1 : 2));
    }
  }
}

void checkSingleTips(vtkPolyData* body)
{
  Body tips = Body::New();
  drag(tips, 0.0, 2.0, 50);
  tips->SetLines(vtkNew<vtkCellArray>());
  for (const int model : { 0, 1, 2 })
  {
    const auto probe = makeProbe(body, tips, model);
    for (vtkIdType i = 0; i <= 50; ++i)
    {
      PALPATE_CHECK(frictionAt(probe, i) == 0.0 && stateAt(probe, i) == 2);
    }
  }
}

/// The speed has no effect, and each polyline begins without displacement.
void checkTimeAndLines(vtkPolyData* body)
{
  for (const int model : { 0, 1, 2 })
  {
    Body tips = Body::New();
    drag(tips, 0.0, 1.0, 40);
    const auto probe = makeProbe(body, tips, model);
    probe->Update();
    vtkNew<vtkPolyData> untimed;
    untimed->DeepCopy(probe->GetOutput());
    vtkDataArray* expected = untimed->GetPointData()->GetArray("Force");
    for (const double rate : { 1e-3, 1e3 })
    {
      Body timed = Body::New();
      timed->DeepCopy(tips);
      pointArray(timed, "Time", [rate](vtkIdType i) { return static_cast<double>(i) / rate; });
      probe->SetTipData(timed);
      probe->Update();
      vtkDataArray* found = probe->GetOutput()->GetPointData()->GetArray("Force");
      PALPATE_CHECK(std::memcmp(expected->GetVoidPointer(0), found->GetVoidPointer(0),
                      41 * 3 * sizeof(double)) == 0);
    }
    const double whole = frictionAt(probe, 40);
    Body cut = Body::New();
    cut->DeepCopy(tips);
    vtkNew<vtkCellArray> lines;
    for (const std::pair<vtkIdType, vtkIdType> part : { std::pair(0, 35), std::pair(36, 40) })
    {
      lines->InsertNextCell(static_cast<int>(part.second - part.first + 1));
      for (vtkIdType i = part.first; i <= part.second; ++i)
      {
        lines->InsertCellPoint(i);
      }
    }
    cut->SetLines(lines);
    probe->SetTipData(cut);
    PALPATE_CHECK(frictionAt(probe, 36) == 0.0);
    PALPATE_CHECK(frictionAt(probe, 40) > 0.9 * whole); // both are negative
  }
}
} // namespace

int TestProbeFriction(int, char*[])
{
  const Body body = plate();
  checkElastoPlastic(body);
  checkDahl(body);
  checkShapeDerived(body);
  checkSingleTips(body);
  checkTimeAndLines(body);
  return palpate::testing::result();
}

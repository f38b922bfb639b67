// SPDX-License-Identifier: BSD-3-Clause
// Responses with terms for curvature and finite strain, and their estimated error.
#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkFieldData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkToolContactProbe.h"
#include "vtkToolTouch.h"

#include <functional>
#include <string>

namespace
{
using namespace palpate::testing;

using Filter = vtkSmartPointer<vtkToolContactResponse>;

constexpr double Reduced = 0.1 / (1.0 - 0.45 * 0.45);
constexpr vtkIdType Middle = 12; // a point of planeBody(40.0, 4) that is far from the border

double last(vtkToolContactResponse* filter, const char* array, vtkIdType point)
{
  vtkDataArray* values = filter->GetOutput()->GetPointData()->GetArray(array);
  return values->GetComponent(point, values->GetNumberOfComponents() - 1);
}

/// Hertz on a ball: the radii of tool and body combine to 1/(1/R + 1/R_b), in a hollow to 1/(1/R -
/// 1/R_b).
void checkBall(double sign)
{
  const Body body = sign < 0.0 ? hollowBody(20.0, 3) : sphereBody(20.0, 3);
  addRadialNormals(body, sign);
  const Filter filter = filterOf(body, "paraboloid:5", 1.0);
  filter->SetErrorTolerance(0.0); // no estimated error
  filter->Update();
  const double radius = 1.0 / (0.2 + sign * 0.05);
  const double hertz = 4.0 / 3.0 * Reduced * std::sqrt(radius);
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    // The curvature from float normals over edges of 3 mm has an error of 1e-6, the nodes of the
    // law the same.
    PALPATE_CHECK_NEAR(last(filter, "ResponseForce", i), hertz, 1e-5 * hertz);
  }
}

/// On an ellipsoid with exact normals the error of the curvature is of the order of the edges. The
/// force is compared with Hertz's ellipse in closed form at the ends of the three axes.
void checkEllipsoid()
{
  const double axis[3] = { 30.0, 24.0, 20.0 };
  Body body = sphereBody(1.0, 4);
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    double x[3];
    body->GetPoint(i, x);
    double n[3];
    for (int k = 0; k < 3; ++k)
    {
      n[k] = x[k] / axis[k];
      x[k] *= axis[k];
    }
    vtkMath::Normalize(n);
    normals->InsertNextTuple(n);
    body->GetPoints()->SetPoint(i, x);
  }
  body->GetPointData()->SetNormals(normals);
  const Filter filter = filterOf(body, "paraboloid:5", 1.0);
  filter->Update();
  for (int k = 0; k < 3; ++k)
  {
    double end[3] = { 0.0, 0.0, 0.0 };
    end[k] = axis[k];
    const vtkIdType point = body->FindPoint(end);
    double there[3];
    body->GetPoint(point, there);
    // Curvatures at the end of axis k: axis_k / axis_j², added to those of the tool.
    const double first = 0.2 + axis[k] / (axis[(k + 1) % 3] * axis[(k + 1) % 3]);
    const double second = 0.2 + axis[k] / (axis[(k + 2) % 3] * axis[(k + 2) % 3]);
    const double ratio = std::log(first / second);
    const double wanted =
      4.0 / 3.0 * Reduced / std::sqrt(std::sqrt(first * second)) * (1.0 + ratio * ratio / 48.0);
    const double off = std::abs(last(filter, "ResponseForce", point) / wanted - 1.0);
    // Edges are 2 mm long; the nearest point is up to 1.5 mm away from the end.
    PALPATE_CHECK(off < 5e-3);
    PALPATE_CHECK(off < last(filter, "ResponseError", point));
  }
}

/// The factor c of a sphere at δ = R/2 is 0.988 at ν = 0.45, from another code
/// (Data/Reference/deep).
void checkNeoHooke()
{
  const Body body = planeBody(40.0, 4);
  const Filter small = filterOf(body, "sphere:5", 2.5);
  makePlain(small);
  small->Update();
  const Filter finite = filterOf(body, "sphere:5", 2.5);
  finite->SetStrainModelToNeoHooke();
  finite->Update();
  const double c = last(finite, "ResponseForce", Middle) / last(small, "ResponseForce", Middle);
  PALPATE_CHECK_NEAR(c, 0.988, 0.005);
  PALPATE_CHECK(last(finite, "ResponseError", Middle) < 0.01);
  PALPATE_CHECK_NEAR(last(finite, "ResponseValidity", Middle), 2.5, 1e-6);
  vtkFieldData* fields = finite->GetOutput()->GetFieldData();
  const std::string model =
    vtkStringArray::SafeDownCast(fields->GetAbstractArray("ResponseModel"))->GetValue(0);
  PALPATE_CHECK_TEXT(model, "half-space", "Neo-Hooke");
}

/// Without the terms every bit is that of the uncorrected law.
void checkUntouched()
{
  Body body = sphereBody(20.0, 2);
  const Filter plain = filterOf(body, "sphere:5", 1.0);
  makePlain(plain);
  PALPATE_CHECK(plain->GetStoreError()); // has no effect here
  plain->Update();
  const Filter estimated = filterOf(body, "sphere:5", 1.0);
  estimated->CurvatureCorrectionOff();
  estimated->StoreErrorOff();
  estimated->Update();
  PALPATE_CHECK(!plain->GetOutput()->GetPointData()->HasArray("ResponseError"));
  PALPATE_CHECK(!estimated->GetOutput()->GetPointData()->HasArray("ResponseError"));
  for (const char* name : { "ResponseForce", "ResponseStiffness" })
  {
    auto* one = vtkFloatArray::SafeDownCast(plain->GetOutput()->GetPointData()->GetArray(name));
    auto* other =
      vtkFloatArray::SafeDownCast(estimated->GetOutput()->GetPointData()->GetArray(name));
    PALPATE_CHECK(std::equal(
      one->GetPointer(0), one->GetPointer(0) + one->GetNumberOfValues(), other->GetPointer(0)));
  }
  // A sphere on a ball of four times its radius: the missing term is -Rκ/2, 12.5 %.
  PALPATE_CHECK_NEAR(last(estimated, "ResponseValidity", 3), 0.0, 0.0);
  PALPATE_CHECK_NEAR(last(estimated, "ResponseLimit", 3), 2.0, 0.0);
}

/// The defaults: the curvature is in the law, the error is stored, and validity ends at an error of
/// 5 %.
void checkDefaults()
{
  vtkNew<vtkToolContactResponse> fresh;
  PALPATE_CHECK(fresh->GetCurvatureCorrection() && fresh->GetStoreError());
  PALPATE_CHECK(fresh->GetErrorTolerance() == 0.05);
  PALPATE_CHECK(fresh->GetStrainModel() == vtkToolContactResponse::SmallStrain);
  // On a plane at ν = 0.3 (n = 4/7) the error is K s plus a remaining part, with s = 4/(3π) √(δ/R)
  // of a paraboloid (Hertz). The paraboloid is stored exactly.
  const Filter filter = filterOf(planeBody(40.0, 4), "paraboloid:5", 2.5);
  filter->SetPoissonRatio(0.3);
  filter->Update();
  const auto errorAt = [](double depth)
  {
    const double s = 4.0 / (3.0 * vtkMath::Pi()) * std::sqrt(depth / 5.0);
    return (-0.148 + 0.61 * 4.0 / 7.0) * s + 0.1 * s * s;
  };
  PALPATE_CHECK_NEAR(last(filter, "ResponseError", Middle), errorAt(2.5), 1e-6);
  // Between samples the error is linear in √δ, so its square term is off by 0.1 (Δs)²/4.
  PALPATE_CHECK_NEAR(errorAt(last(filter, "ResponseValidity", Middle)), 0.05, 1e-4);
  PALPATE_CHECK(last(filter, "ResponseLimit", Middle) == 1.0);
}

/// A flat end on a cylinder: first in contact along a line, then over its whole circle, and then
/// with a small error.
void checkFlatOnCylinder()
{
  Body body = Body::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  constexpr int cells = 20;
  constexpr double radius = 30.0;
  for (int j = 0; j <= cells; ++j)
  {
    for (int i = 0; i <= cells; ++i)
    {
      const double angle = 0.02 * (i - cells / 2);
      points->InsertNextPoint(
        radius * std::sin(angle), j - cells / 2, radius * (std::cos(angle) - 1.0));
      normals->InsertNextTuple3(std::sin(angle), 0.0, std::cos(angle));
      if (i < cells && j < cells)
      {
        const vtkIdType at = static_cast<vtkIdType>(j) * (cells + 1) + i;
        triangles->InsertNextCell({ at, at + 1, at + cells + 2 });
        triangles->InsertNextCell({ at, at + cells + 2, at + cells + 1 });
      }
    }
  }
  body->SetPoints(points);
  body->SetPolys(triangles);
  body->GetPointData()->SetNormals(normals);
  const Filter filter = filterOf(body, "flat:1.6", 1.0);
  filter->Update();
  const vtkIdType middle = (cells / 2) * (cells + 2);
  // In full contact the mean of the sag over the circle counts: F = 2E*(aδ - a³κ_m/3).
  const double wanted = 2.0 * Reduced * (1.6 - 1.6 * 1.6 * 1.6 / (2.0 * radius) / 3.0);
  PALPATE_CHECK_NEAR(last(filter, "ResponseForce", middle), wanted, 1e-3 * wanted);
  PALPATE_CHECK(last(filter, "ResponseError", middle) < 0.1);
  PALPATE_CHECK(last(filter, "ResponseLimit", middle) != 2.0);
}

std::string touchText(vtkToolTouch* touch)
{
  auto* table = vtkTable::SafeDownCast(touch->GetOutputDataObject(vtkToolTouch::TextPort));
  return table && table->GetNumberOfRows() == 1 ? table->GetValueByName(0, "Text").ToString() : "";
}

/// A touch reports its force with its error.
void checkTouch()
{
  const Filter filter = filterOf(planeBody(40.0, 8), "sphere:5", 2.0);
  filter->SetPoissonRatio(0.3);
  vtkNew<vtkToolTouch> touch;
  touch->SetInputConnection(filter->GetOutputPort());
  touch->SetTipPosition(0.0, 0.0, 0.0);
  touch->SetIndentation(1.0);
  touch->Update();
  // K s = 0.2 · 0.424 √0.2 (Hertz), plus the remaining part.
  PALPATE_CHECK_TEXT(touchText(touch), "N \u00b1 4 %", "Within the law's validity");
}

/// The tips of a probe have the error of their force: that of the curve at the depth, as the mean
/// over the three corners, which are equal here. If the response stores no error, the tips have
/// none.
void checkProbe()
{
  const Filter filter = filterOf(planeBody(40.0, 8), "sphere:5", 2.0);
  filter->SetPoissonRatio(0.3);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const double depth : { -0.5, 2.0 * 36.0 / 64.0, 2.0 * 42.25 / 64.0, 2.5 })
  {
    points->InsertNextPoint(1.0, 2.0, -depth);
  }
  vtkNew<vtkPolyData> tips;
  tips->SetPoints(points);
  vtkNew<vtkToolContactProbe> probe;
  probe->SetInputConnection(0, filter->GetOutputPort());
  probe->SetInputData(1, tips);
  probe->Update();
  auto* error =
    vtkDoubleArray::SafeDownCast(probe->GetOutput()->GetPointData()->GetArray("RelativeError"));
  PALPATE_CHECK(error && error->GetNumberOfTuples() == 4);
  if (!error)
  {
    return;
  }
  vtkDataArray* stored = filter->GetOutput()->GetPointData()->GetArray("ResponseError");
  const double sixth = stored->GetComponent(40, 5);
  const double seventh = stored->GetComponent(40, 6);
  PALPATE_CHECK(seventh > sixth && sixth > 0.03);
  PALPATE_CHECK(error->GetValue(0) == 0.0);
  PALPATE_CHECK_NEAR(error->GetValue(1), sixth, 1e-7);
  // half-way between two samples in √δ
  PALPATE_CHECK_NEAR(error->GetValue(2), 0.5 * (sixth + seventh), 1e-7);
  PALPATE_CHECK(std::isnan(error->GetValue(3)));
  filter->StoreErrorOff();
  probe->Update();
  PALPATE_CHECK(!probe->GetOutput()->GetPointData()->HasArray("RelativeError"));
}

void checkFaults()
{
  const Body body = planeBody(10.0, 2);
  const auto expect = [&body](const char* words, const std::function<void(Filter)>& spoil)
  {
    const Filter filter = filterOf(body, "sphere:5", 1.0);
    spoil(filter);
    Messages messages(filter);
    filter->Update();
    PALPATE_CHECK_TEXT(messages.errors(), words);
  };
  expect("Error Tolerance must be", [](const Filter& f) { f->SetErrorTolerance(-0.1); });
  expect("Error Tolerance must be", [](const Filter& f) { f->SetErrorTolerance(std::nan("")); });
  expect("Ogden",
    [](const Filter& f)
    {
      f->SetStrainModelToOgden();
      f->SetOgdenExponent(0.0);
    });
}
} // namespace

int TestResponseError(int, char*[])
{
  checkBall(1.0);
  checkBall(-1.0);
  checkEllipsoid();
  checkNeoHooke();
  checkUntouched();
  checkDefaults();
  checkFlatOnCylinder();
  checkTouch();
  checkProbe();
  checkFaults();
  return result();
}

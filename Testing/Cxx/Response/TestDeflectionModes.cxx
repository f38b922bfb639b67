// SPDX-License-Identifier: BSD-3-Clause
// The displacement field of a body with a global deflection: the modes plus the tool's own field.
// Also a field with a given end.
#include "Response/BodyConversion.h"
#include "FilterChecks.h"
#include "ProbedTips.h"

#include "vtkFieldData.h"
#include "vtkSignedCharArray.h"

#include <vector>

namespace
{
using namespace palpate::testing;

constexpr double Depth = 1.5;
constexpr double Force = 8.0;
constexpr double Here[3] = { 0.13, -0.21, 0.0 };

/// Modes that are linear in x and y, so that their interpolated value at the contact is exact;
/// sqrt(mm/N).
void mode(int k, const double x[3], double phi[3])
{
  phi[0] = k == 0 ? 0.05 + 0.01 * x[1] : -0.02;
  phi[1] = 0.004 * x[0];
  phi[2] = k == 0 ? 0.3 + 0.01 * x[0] : 0.1 - 0.005 * x[1];
}
const int Signs[2] = { 1, -1 };

Body bendingPlane(int modes)
{
  const Body body = withResponse(planeBody(8.0, 32), "sphere:5");
  palpate::describeModel(body, "Response",
    { "half-space in series with global compliance",
      palpate::HalfSpacePart | palpate::GlobalCompliancePart });
  vtkNew<vtkSignedCharArray> signs;
  signs->SetName("GlobalModeSign");
  for (int k = 0; k < modes; ++k)
  {
    vtkNew<vtkFloatArray> array;
    array->SetName(("GlobalMode" + std::to_string(k)).c_str());
    array->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
    {
      double phi[3];
      mode(k, body->GetPoint(i), phi);
      array->InsertNextTuple(phi);
    }
    body->GetPointData()->AddArray(array);
    signs->InsertNextValue(static_cast<signed char>(Signs[k]));
  }
  body->GetFieldData()->AddArray(signs);
  return body;
}

/// The triangle that contains Here.
vtkIdType cellHere(vtkPolyData* body)
{
  double closest[3];
  double pcoords[3];
  double weights[3];
  int subId = 0;
  double distance = 0.0;
  for (vtkIdType i = 0; i < body->GetNumberOfCells(); ++i)
  {
    if (body->GetCell(i)->EvaluatePosition(Here, closest, subId, pcoords, distance, weights) == 1)
    {
      return i;
    }
  }
  return -1;
}

Body tipHere(vtkPolyData* body)
{
  const Body tips =
    makeTips({ { cellHere(body), Depth, { Here[0], Here[1], Here[2] }, { 0, 0, 1 } } });
  vtkNew<vtkDoubleArray> force;
  force->SetName("NormalForce");
  force->InsertNextValue(Force);
  tips->GetPointData()->AddArray(force);
  return tips;
}

/// u(x) = -F Σ s φ(x) (n·φ(X)), plus the tool's own field at δ - F Σ s (n·φ(X))².
void checkModes(int modes)
{
  const Body body = bendingPlane(modes);
  const auto tool = makeTool("sphere:5");
  auto filter = makeFilter(body, tipHere(body), tool);
  Messages messages(filter.Get());
  filter->Update();
  PALPATE_CHECK(messages.none());
  double local = Depth;
  for (int k = 0; k < modes; ++k)
  {
    double there[3];
    mode(k, Here, there);
    local -= Force * Signs[k] * there[2] * there[2];
  }
  PALPATE_CHECK(local < 0.9 * Depth && local > 0.3 * Depth);
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    const double* x = body->GetPoint(i);
    const double away[2] = { x[0] - Here[0], x[1] - Here[1] };
    const double r = std::hypot(away[0], away[1]);
    double u[2];
    tool->GetSurfaceDisplacement(r, local, Poisson, u);
    double expected[3] = { u[0] * away[0] / r, u[0] * away[1] / r, -u[1] };
    for (int k = 0; k < modes; ++k)
    {
      double there[3];
      double phi[3];
      mode(k, Here, there);
      mode(k, x, phi);
      for (int c = 0; c < 3; ++c)
      {
        expected[c] -= Force * Signs[k] * phi[c] * there[2];
      }
    }
    const auto found = displacement(filter, i);
    for (std::size_t c = 0; c < 3; ++c)
    {
      // the modes and their sums are floats
      PALPATE_CHECK_NEAR(found[c], expected[c], 1e-6 * Depth);
    }
  }
}

/// With a given distance the field is exact within three quarters of it, zero beyond it, and falls
/// in between.
void checkEnd()
{
  constexpr double End = 6.0;
  const Body body = withResponse(planeBody(8.0, 32), "sphere:5");
  const auto tips = tipHere(body);
  auto whole = makeFilter(body, tips, nullptr);
  auto ended = makeFilter(body, tips, nullptr);
  ended->SetMaximumDistance(End);
  whole->Update();
  ended->Update();
  int faded = 0;
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    const double r = std::hypot(body->GetPoint(i)[0] - Here[0], body->GetPoint(i)[1] - Here[1]);
    const auto u = displacement(whole, i);
    const auto v = displacement(ended, i);
    PALPATE_CHECK(r > 0.75 * End || u == v);
    PALPATE_CHECK(r < End || isZero(v));
    if (r > 0.76 * End && r < 0.99 * End)
    {
      const double t = (r / End - 0.75) / 0.25;
      PALPATE_CHECK_NEAR(v[2], u[2] * (1.0 - t * t * (3.0 - 2.0 * t)), 1e-6);
      ++faded;
    }
  }
  PALPATE_CHECK(faded > 50);
}
} // namespace

int TestDeflectionModes(int, char*[])
{
  checkModes(1);
  checkModes(2);
  checkEnd();
  return palpate::testing::result();
}

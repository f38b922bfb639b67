// SPDX-License-Identifier: BSD-3-Clause
// The compact form of a response - laws and a coefficient per point - against the form per point.
#include "FilterChecks.h"
#include "ProbedBall.h"

#include "vtkFieldData.h"

#include <vector>

namespace
{
using namespace palpate::testing;

/// The compact form of a body: each given law at E* = 1 is a row of the basis.
Body compactForm(vtkPolyData* full, const std::vector<Body>& laws, const std::vector<double>& share)
{
  Body body = Body::New();
  body->ShallowCopy(full);
  body->GetPointData()->RemoveArray("ResponseForce");
  body->GetPointData()->RemoveArray("ResponseStiffness");
  vtkNew<vtkFloatArray> basis;
  basis->SetName("ResponseBasis");
  basis->SetNumberOfComponents(16);
  vtkNew<vtkFloatArray> coefficients;
  coefficients->SetName("ResponseCoefficient");
  coefficients->SetNumberOfComponents(static_cast<int>(laws.size()));
  coefficients->SetNumberOfTuples(body->GetNumberOfPoints());
  for (std::size_t law = 0; law < laws.size(); ++law)
  {
    for (const char* name : { "ResponseForce", "ResponseStiffness" })
    {
      vtkDataArray* curve = laws[law]->GetPointData()->GetArray(name);
      for (int k = 0; k < 8; ++k)
      {
        basis->InsertNextValue(static_cast<float>(curve->GetComponent(0, k)));
      }
    }
    for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
    {
      coefficients->SetComponent(i, static_cast<int>(law), share[law] * modulusAt(i));
    }
  }
  body->GetFieldData()->AddArray(basis);
  body->GetPointData()->AddArray(coefficients);
  return body;
}

void checkStorageForms(vtkPolyData* full, vtkPolyData* compact)
{
  const Body tips = tipsInBall(400);
  const auto a = probe(full, tips);
  const auto b = probe(compact, tips);
  for (vtkIdType i = 0; i < tips->GetNumberOfPoints(); ++i)
  {
    const double force = a->GetArray("NormalForce")->GetTuple1(i);
    // Each form rounds its stored values to float, 6e-8. The cubic polynomials and the power law at
    // the start multiply this error by at most ten (differences of neighbouring samples, exponent q
    // from a quotient).
    PALPATE_CHECK_NEAR(b->GetArray("NormalForce")->GetTuple1(i), force, 1e-6 * force);
    PALPATE_CHECK(
      a->GetArray("ContactState")->GetTuple1(i) == b->GetArray("ContactState")->GetTuple1(i));
  }
}

void checkCompact()
{
  const Body sphere = heterogeneousBall("sphere:5");
  const Body sphereLaw = heterogeneousBall("sphere:5", 1.0);
  checkStorageForms(sphere, compactForm(sphere, { sphereLaw }, { 1.0 }));

  // Two laws: the curve is 0.6 of the sphere's curve plus 0.4 of a punch's curve.
  const Body punch = heterogeneousBall("flat:2");
  const Body punchLaw = heterogeneousBall("flat:2", 1.0);
  Body mixed = Body::New();
  mixed->DeepCopy(sphere);
  for (const char* name : { "ResponseForce", "ResponseStiffness" })
  {
    auto* to = vtkFloatArray::SafeDownCast(mixed->GetPointData()->GetArray(name));
    auto* from = vtkFloatArray::SafeDownCast(punch->GetPointData()->GetArray(name));
    for (vtkIdType k = 0; k < to->GetNumberOfValues(); ++k)
    {
      to->SetValue(k, 0.6F * to->GetValue(k) + 0.4F * from->GetValue(k));
    }
  }
  checkStorageForms(mixed, compactForm(mixed, { sphereLaw, punchLaw }, { 0.6, 0.4 }));
}
} // namespace

int TestProbeStorage(int, char*[])
{
  checkCompact();
  return palpate::testing::result();
}

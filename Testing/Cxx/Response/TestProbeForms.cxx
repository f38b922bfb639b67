// SPDX-License-Identifier: BSD-3-Clause
// The two forms of a force, points without a response, threads.
#include "ContractOracle.h"
#include "FilterChecks.h"
#include "ProbedBall.h"

#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstring>

namespace
{
using namespace palpate::testing;

/// Both force forms against the curves and normals of the three corners, at the probe's cell and
/// contact point, which TestToolContactProbe checks.
void checkForceForms()
{
  const Body body = heterogeneousBall("sphere:5");
  const Body tips = tipsInBall(400);
  const ContractOracle oracle(body);
  const auto paper = probe(body, tips, vtkToolContactProbe::Paper);
  const auto normalized = probe(body, tips, vtkToolContactProbe::NormalizedDirection);
  double largestLoss = 0.0;
  int contacts = 0;
  for (vtkIdType i = 0; i < tips->GetNumberOfPoints(); ++i)
  {
    const auto cell = static_cast<vtkIdType>(paper->GetArray("ContactCell")->GetTuple1(i));
    PALPATE_CHECK(cell == normalized->GetArray("ContactCell")->GetTuple1(i));
    if (cell < 0)
    {
      continue;
    }
    ++contacts;
    double weights[3];
    double parametric[3];
    double closest[3];
    double squared = 0.0;
    int subId = 0;
    vtkCell* triangle = body->GetCell(cell);
    triangle->EvaluatePosition(
      paper->GetArray("ContactPoint")->GetTuple3(i), closest, subId, parametric, squared, weights);
    const double depth = paper->GetArray("Deflection")->GetTuple1(i);
    double sum[3] = { 0.0, 0.0, 0.0 };
    double direction[3] = { 0.0, 0.0, 0.0 };
    double magnitude = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const vtkIdType point = triangle->GetPointId(k);
      const double force = oracle.force(point, depth);
      double n[3];
      oracle.normal(point, n);
      magnitude += weights[k] * force;
      for (int c = 0; c < 3; ++c)
      {
        sum[c] += weights[k] * force * n[c];
        direction[c] += weights[k] * n[c];
      }
    }
    vtkMath::Normalize(direction);
    for (int c = 0; c < 3; ++c)
    {
      // Rounding of about 1e-15 in forces below 20 N, and in weights from coordinates of 20 mm.
      PALPATE_CHECK_NEAR(paper->GetArray("Force")->GetComponent(i, c), sum[c], 1e-11);
      PALPATE_CHECK_NEAR(
        normalized->GetArray("Force")->GetComponent(i, c), magnitude * direction[c], 1e-11);
    }
    PALPATE_CHECK_NEAR(paper->GetArray("NormalForce")->GetTuple1(i), vtkMath::Norm(sum), 1e-11);
    largestLoss = std::max(largestLoss, 1.0 - vtkMath::Norm(sum) / magnitude);
  }
  // Facets of h = 5.5 mm (162 points) lose h²/(6R²) = 1.2 % at the centroid. The lengths of edges
  // vary by a quarter.
  PALPATE_CHECK(contacts > 300 && largestLoss > 0.009 && largestLoss < 0.018);
}

void checkThreads()
{
  const Body body = heterogeneousBall("sphere:5");
  const Body tips = tipsInBall(3000);
  const auto one = probe(body, tips, 1, 1);
  for (const int threads : { 2, 8 })
  {
    const auto many = probe(body, tips, 1, threads);
    for (const char* name : { "Force", "Normal", "ContactPoint", "Deflection", "ContactCell" })
    {
      vtkDataArray* a = one->GetArray(name);
      vtkDataArray* b = many->GetArray(name);
      PALPATE_CHECK(std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
                      static_cast<std::size_t>(a->GetNumberOfValues()) * 8) == 0);
    }
  }
}

/// A vertex without a response makes only contacts on its triangles invalid.
void checkPointWithoutResponse()
{
  const Body body = heterogeneousBall("sphere:5");
  vtkUnsignedCharArray::SafeDownCast(body->GetPointData()->GetArray("ResponseStatus"))
    ->SetValue(5, 3);
  const Body tips = tipsInBall(2000);
  const auto found = probe(body, tips);
  int invalid = 0;
  for (vtkIdType i = 0; i < tips->GetNumberOfPoints(); ++i)
  {
    const double state = found->GetArray("ContactState")->GetTuple1(i);
    invalid += state == 5.0;
    PALPATE_CHECK((state == 5.0) <= (found->GetArray("NormalForce")->GetTuple1(i) == 0.0));
  }
  // 5 or 6 of 320 triangles, thus few of 1800 contacts
  PALPATE_CHECK(invalid > 10 && invalid < 200);
}
} // namespace

int TestProbeForms(int, char*[])
{
  checkForceForms();
  checkThreads();
  checkPointWithoutResponse();
  return palpate::testing::result();
}

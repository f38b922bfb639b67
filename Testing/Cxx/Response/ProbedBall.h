// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_ProbedBall_h
#define palpate_testing_ProbedBall_h

#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkDataObject.h"
#include "vtkToolContactProbe.h"

#include <random>

namespace palpate::testing
{
constexpr double BallRadius = 20.0;

/// Tips in a cube around the ball: some outside, some below the surface, up to a depth of 2.5 mm.
/// The range of the response is 2 mm.
inline Body tipsInBall(int count)
{
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> depth(-0.3, 2.5);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < count; ++i)
  {
    double x[3];
    for (double& c : x)
    {
      c = normal(random);
    }
    vtkMath::Normalize(x);
    vtkMath::MultiplyScalar(x, BallRadius - depth(random));
    points->InsertNextPoint(x);
  }
  auto tips = Body::New();
  tips->SetPoints(points);
  return tips;
}

/// The arrays that the probe gives for these tips.
inline vtkSmartPointer<vtkPointData> probe(
  vtkPolyData* body, vtkPolyData* tips, int form = 1, int threads = 1)
{
  vtkNew<vtkToolContactProbe> filter;
  filter->SetInputData(body);
  filter->SetTipData(tips);
  filter->SetForceForm(form);
  filter->SetContactSurfaceToFacets();
  withThreads(threads, [&] { filter->Update(); });
  return filter->GetOutput()->GetPointData();
}

/// A modulus that differs from point to point, MPa.
inline double modulusAt(vtkIdType point)
{
  return 0.1 + 0.07 * static_cast<double>(point % 13);
}

/// A ball of 162 points with the response of a tool. The modulus is modulusAt(), or `modulus`
/// everywhere if it is not 0.
inline Body heterogeneousBall(const char* tool, double modulus = 0.0)
{
  Body body = sphereBody(BallRadius, 2);
  snapPoints(body);
  pointArray(body, "E", [modulus](vtkIdType i) { return modulus > 0.0 ? modulus : modulusAt(i); });
  vtkNew<vtkToolContactResponse> filter;
  filter->SetInputData(body);
  filter->SetTool(makeTool(tool));
  filter->SetPoissonRatio(0.0);
  makePlain(filter);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "E");
  filter->Update();
  Body output = Body::New();
  output->DeepCopy(filter->GetOutput());
  return output;
}
} // namespace palpate::testing

#endif

// SPDX-License-Identifier: BSD-3-Clause
#include "StudyConvergence.h"

#include "LawMethods.h"
#include "MethodErrors.h"
#include "PenetratingVertices.h"
#include "StoredMethods.h"

#include <cmath>

namespace palpate::testing
{
namespace
{
constexpr double BallRadius = 40.0;
constexpr int Samples = 16; // enough that the error of the samples is negligible

void judgeMesh(const std::string& name, const StudyBody& body, const StudyLaw& law,
  const ErrorJudge& judge, std::vector<ConvergencePoint>& points)
{
  const SampledCurves curves = law.sample(body.spots(), Samples);
  const auto add = [&](const std::string& method, std::unique_ptr<ContactMethod> made) {
    points.push_back({ name, method, body.meanEdge(), judge.judge(*made).all });
  };
  add("Hermite, facets", hermite("", body, curves));
  add("Hermite, smooth surface", hermite("", body, curves, ContactSurface::Smooth));
  add(
    "penetrating vertices", std::make_unique<PenetratingVertices>("", body, law, law.tool().shape));
}

/// Inverse thickness between 1/12 and 1/8 /mm, in waves of about 20 mm.
Spot unevenSpot(double x, double y)
{
  const double wave = std::sin(0.3 * x + 0.4) * std::cos(0.25 * y - 0.3);
  return { 1.0 / (10.0 + 2.0 * wave), 0.0 };
}
} // namespace

std::vector<ConvergencePoint> meshConvergence(
  const StudyEffort& effort, const StudyScene* head, bool isQuick)
{
  std::vector<ConvergencePoint> points;
  const StudyLaw law(studyTool("sphere:6.35", 2.0), { 3.45, 0.45 });
  {
    const StudyTips tips = ballTips(BallRadius, law.tool().range, effort.sites);
    const auto reference = ballReference(BallRadius, law);
    const ErrorJudge judge(tips, *reference, 1);
    for (int times = 3; times <= (isQuick ? 5 : 6); ++times)
    {
      Surface ball = icosphere(BallRadius, times);
      std::vector<Spot> spots(ball.points.size());
      judgeMesh("ball", StudyBody(std::move(ball), std::move(spots)), law, judge, points);
    }
  }
  {
    const StudyTips tips = flatTips(12.0, law.tool().range, effort.sites, 0);
    const auto reference = planeReference(unevenSpot, law);
    const ErrorJudge judge(tips, *reference, 1);
    for (const double edge : { 8.0, 4.0, 2.0, 1.0 })
    {
      Surface top = flatTop(24.0, edge);
      std::vector<Spot> spots;
      for (const Vector3& point : top.points)
      {
        spots.push_back(unevenSpot(point.x(), point.y()));
      }
      judgeMesh("uneven layer", StudyBody(std::move(top), std::move(spots)), law, judge, points);
    }
  }
  if (head != nullptr)
  {
    const StudyLaw scalp(head->tools.front(), head->material);
    const StudyTips tips = head->tips(scalp.tool());
    const auto reference = head->reference(scalp);
    const ErrorJudge judge(tips, *reference, 1);
    for (const auto& body : head->bodies)
    {
      judgeMesh("head", *body, scalp, judge, points);
    }
  }
  return points;
}

std::vector<ConvergencePoint> sampleConvergence(const StudyScene& scene)
{
  std::vector<ConvergencePoint> points;
  const StudyBody& coarse = *scene.bodies.back();
  for (const StudyTool& tool : scene.tools)
  {
    const StudyLaw law(tool, scene.material);
    const StudyTips tips = scene.tips(tool);
    const auto reference = exactReference(coarse, law);
    const ErrorJudge judge(tips, *reference, 4);
    for (const int samples : { 3, 4, 5, 6, 8, 12, 16, 24, 32 })
    {
      const SampledCurves curves = law.sample(coarse.spots(), samples);
      const std::string body = scene.name + ", " + tool.name;
      const auto add = [&](const std::string& method, std::unique_ptr<ContactMethod> made) {
        points.push_back({ body, method, static_cast<double>(samples), judge.judge(*made).all });
      };
      add("linear", linear("", coarse, curves));
      add("Hermite, float16", hermiteIn(FloatWidth::Half, "", coarse, curves));
      add("Hermite, float32", hermiteIn(FloatWidth::Single, "", coarse, curves));
      add("Hermite, float64", hermiteIn(FloatWidth::Double, "", coarse, curves));
    }
  }
  return points;
}
} // namespace palpate::testing

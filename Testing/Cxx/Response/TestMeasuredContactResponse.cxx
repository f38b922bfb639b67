// SPDX-License-Identifier: BSD-3-Clause
// A body measured with one tool and applied to another one: its arrays are those of a body of known
// material.
#include "FilterChecks.h"
#include "MeasuredFiles.h"

#include "vtkFieldData.h"

#include <algorithm>

namespace
{
using namespace palpate::testing;

constexpr double Modulus = 0.05; // E*, MPa
constexpr double R = 6.35;

vtkDataArray* array(vtkMeasuredContactResponse* filter, const char* name)
{
  return filter->GetOutput()->GetPointData()->GetArray(name);
}

/// Largest relative difference of an array between two bodies.
double difference(vtkDataArray* a, vtkDataArray* b)
{
  double largest = 0.0;
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < a->GetNumberOfComponents(); ++k)
    {
      const double x = a->GetComponent(i, k);
      const double y = b->GetComponent(i, k);
      largest = std::max(largest, std::abs(x - y) / std::max(std::abs(y), 1e-30));
    }
  }
  return largest;
}

/// A half-space measured with a paraboloid has the same response to any tool as the half-space of
/// known material.
void checkHalfSpace(const std::string& folder)
{
  const Body body = planeBody(12.0, 8);
  const std::string file = writeCurves(folder + "/half-space.csv", "paraboloid:6.35",
    { { "A", { 1.0, -1.0, 0.5 }, hertz(R, Modulus) } }, 1.5, 0.3);
  for (const char* tool : { "sphere:1.6", "flat:1.6", "cone:60" })
  {
    const MeasuredFilter filter = measure(body, file, tool);
    Messages messages(filter.Get());
    filter->Update();
    PALPATE_CHECK(messages.none());
    vtkNew<vtkToolContactResponse> given;
    given->SetInputData(body);
    given->SetTool(makeTool(tool));
    given->SetPoissonRatio(0.45);
    given->SetYoungsModulus(Modulus * (1.0 - 0.45 * 0.45));
    given->Update();
    for (const char* name :
      { "ResponseForce", "ResponseStiffness", "ResponseRange", "ResponseNormal" })
    {
      // Tolerance: floats, and 1e-8 of the fit.
      PALPATE_CHECK(
        difference(array(filter, name), given->GetOutput()->GetPointData()->GetArray(name)) < 3e-7);
    }
  }
  const MeasuredFilter filter = measure(body, file, "sphere:1.6");
  filter->Update();
  PALPATE_CHECK(siteText(filter, 0, "Site") == "A");
  PALPATE_CHECK(siteText(filter, 0, "Verdict") == "identified");
  PALPATE_CHECK_TEXT(siteText(filter, 0, "Model"), "half-space");
  PALPATE_CHECK_NEAR(siteNumber(filter, 0, "ReducedModulus (MPa)"), Modulus, 1e-9);
  PALPATE_CHECK_NEAR(siteNumber(filter, 0, "ContactOffset (mm)"), 0.3, 1e-7);
  PALPATE_CHECK_NEAR(siteNumber(filter, 0, "Distance (mm)"), 0.5, 1e-15);
  PALPATE_CHECK_NEAR(filter->GetSiteResidual(), 0.5, 1e-15);
  PALPATE_CHECK_NEAR(siteNumber(filter, 0, "ForceOffset (N)"), 0.0, 1e-9);
  // Small strain ends at a depth of 0.16 R: 20 readings, 1.5/60 mm apart, are deeper.
  PALPATE_CHECK_TEXT(
    siteText(filter, 0, "Remark"), "20 of 71 readings are not used", "strain of 0.4");
  filter->SetMaximumStrain(0.5);
  filter->Update();
  PALPATE_CHECK(siteText(filter, 0, "Remark").find("not used") == std::string::npos);
  filter->SetMaximumStrain(0.4);
  filter->Update();
  auto* model = vtkStringArray::SafeDownCast(
    filter->GetOutput()->GetFieldData()->GetAbstractArray("ResponseModel"));
  PALPATE_CHECK(model != nullptr);
  PALPATE_CHECK_TEXT(model ? model->GetValue(0) : std::string(), "half-space, identified",
    "synthetic", "paraboloid:6.35", "1 site", "closed form");
  PALPATE_CHECK(array(filter, "palpate:YoungsModulus") == nullptr);
  PALPATE_CHECK(body->GetPointData()->GetNumberOfArrays() == 0); // the input is not changed

  // The curves from first contact on: 71 readings, of which 10 are before contact.
  auto* curves = vtkTable::SafeDownCast(filter->GetOutputDataObject(2));
  PALPATE_CHECK(curves->GetNumberOfRows() == 71);
  for (vtkIdType i = 0; i < curves->GetNumberOfRows(); ++i)
  {
    const double depth = curves->GetValueByName(i, "Deflection (mm)").ToDouble();
    const double force = depth > 0.0 ? hertz(R, Modulus)(depth) : 0.0;
    PALPATE_CHECK_NEAR(curves->GetValueByName(i, "Force (N)").ToDouble(), force, 1e-7);
    PALPATE_CHECK_NEAR(curves->GetValueByName(i, "MonotoneForce (N)").ToDouble(), force, 1e-7);
    PALPATE_CHECK_NEAR(curves->GetValueByName(i, "ModelForce (N)").ToDouble(), force, 1e-7);
  }
}

/// A body with a global compliance: the curve of a sphere is measured, and the curve of a flat end
/// is compared with the closed form in series.
void checkGlobalCompliance(const std::string& folder)
{
  const double compliance = 4.0;
  const auto law = [=](double depth)
  {
    double low = 0.0;
    double high = hertz(R, Modulus)(depth);
    for (int i = 0; i < 100; ++i)
    {
      const double force = 0.5 * (low + high);
      const double local = std::cbrt(std::pow(0.75 * force / (Modulus * std::sqrt(R)), 2.0));
      (local + compliance * force < depth ? low : high) = force;
    }
    return 0.5 * (low + high);
  };
  const std::string file =
    writeCurves(folder + "/series.csv", "paraboloid:6.35", { { "A", { 0.0, 0.0, 0.0 }, law } });
  const MeasuredFilter filter = measure(planeBody(12.0, 8), file, "flat:1.6");
  Messages messages(filter.Get());
  filter->Update();
  PALPATE_CHECK(messages.none());
  PALPATE_CHECK_NEAR(siteNumber(filter, 0, "Compliance (mm/N)"), compliance, 1e-5);
  const double local = 2.0 * 1.6 * Modulus;
  const double stiffness = local / (1.0 + local * compliance);
  for (int k = 0; k < 8; ++k)
  {
    const double depth = 2.0 * (k + 1) * (k + 1) / 64.0;
    // Tolerance: 1e-6 of the fit, and the rounding of floats.
    PALPATE_CHECK_NEAR(
      array(filter, "ResponseForce")->GetComponent(40, k), stiffness * depth, 2e-6 * depth);
  }
}

/// The end of the data, computed by hand: a paraboloid of 6.35 mm at a depth of 0.5 mm has the
/// force F₁ and the contact radius a₁ = √(R δ).
void checkDataEnd(const std::string& folder)
{
  const double depth = 0.5;
  const std::string file = writeCurves(folder + "/end.csv", "paraboloid:6.35",
    { { "A", { 0.0, 0.0, 0.0 }, hertz(R, Modulus) } }, depth);
  const double radius = std::sqrt(R * depth); // 1.782 mm
  const double force = hertz(R, Modulus)(depth);
  const auto expect = [&](const char* tool, double validity, int limit)
  {
    const MeasuredFilter filter = measure(planeBody(12.0, 8), file, tool);
    filter->Update();
    // Force or stiffness have a tolerance of 1e-3, which is 1e-3 to 2e-3 of the depth.
    PALPATE_CHECK_NEAR(
      array(filter, "ResponseValidity")->GetTuple1(40), validity, 2.5e-3 * validity + 1e-6);
    PALPATE_CHECK(array(filter, "ResponseLimit")->GetTuple1(40) == limit);
  };
  expect("paraboloid:6.35", depth, 6);
  // A blunter tip reaches the contact radius first: a² = R δ.
  expect("paraboloid:50", radius * radius / 50.0, 6);
  // A sharper tip reaches the force first. A flat end reaches its strain limit, δ/a = 0.4, before
  // the force.
  expect("paraboloid:4", std::pow(force / (4.0 / 3.0 * Modulus * 2.0), 2.0 / 3.0), 6);
  expect("flat:1.6", std::min(0.4 * 1.6, force / (2.0 * 1.6 * Modulus)), 6);
  // The tool is wider than any measured contact, so its validity is 0.
  expect("flat:2", 0.0, 6);
  // With a sharp tip the strain limit comes first, as the first violated assumption: a/R = 0.4, δ =
  // a²/R.
  const MeasuredFilter filter = measure(planeBody(12.0, 8), file, "paraboloid:1");
  filter->SetErrorTolerance(0.0);
  filter->Update();
  PALPATE_CHECK_NEAR(array(filter, "ResponseValidity")->GetTuple1(40), 0.16, 1e-6);
  PALPATE_CHECK(array(filter, "ResponseLimit")->GetTuple1(40) == 1);
  PALPATE_CHECK(array(filter, "ResponseError") == nullptr);
}

vtkIdType pointAt(vtkPolyData* body, double x, double y, double z)
{
  return body->vtkDataSet::FindPoint(x, y, z);
}

/// The error between two sites is their difference: halfway between E* and 1.4 E* the force is that
/// of 1.2 E*, which differs from both sites by a sixth. At a site the error is that of the fit
/// alone.
void checkErrorBetweenSites(const std::string& folder)
{
  const std::string file = writeCurves(folder + "/two.csv", "paraboloid:6.35",
    { { "A", { -3.0, 0.0, 0.0 }, hertz(R, Modulus) },
      { "B", { 3.0, 0.0, 0.0 }, hertz(R, 1.4 * Modulus) } });
  const Body body = planeBody(12.0, 8);
  const MeasuredFilter filter = measure(body, file, "paraboloid:6.35");
  filter->Update();
  auto* error = array(filter, "ResponseError");
  const auto at = [&](double x, int sample)
  { return error->GetComponent(pointAt(body, x, 0.0, 0.0), sample); };
  for (const int sample : { 1, 5 })
  {
    PALPATE_CHECK(at(-3.0, sample) > 0.0 && at(-3.0, sample) < 0.02);
    // ln 1.4 / 2, plus less than 1 % for the strain at ν = 0.45.
    PALPATE_CHECK_NEAR(at(0.0, sample), 0.5 * std::log(1.4), 0.02);
  }
  PALPATE_CHECK(array(filter, "ResponseLimit")->GetTuple1(pointAt(body, 0.0, 0.0, 0.0)) == 6);
  PALPATE_CHECK(array(filter, "ResponseValidity")->GetTuple1(pointAt(body, 0.0, 0.0, 0.0)) == 0.0);
  // Points out of reach have no error.
  filter->SetReach(5.0);
  filter->Update();
  PALPATE_CHECK(
    std::isnan(array(filter, "ResponseError")->GetComponent(pointAt(body, 12.0, 12.0, 0.0), 0)));
}

/// A ball is measured with one paraboloid, and the result is applied to other paraboloids. The
/// error is that of the curvature: by Hertz F is proportional to √(1/(1/R + 1/B)), and the readings
/// with R already contain √(1/(1 + R/B)).
void checkErrorOfCurvature(const std::string& folder)
{
  const double ball = 60.0;
  const auto effective = [=](double radius) { return 1.0 / (1.0 / radius + 1.0 / ball); };
  const Body body = sphereBody(ball, 5);
  const std::string file = writeCurves(folder + "/ball.csv", "paraboloid:6.35",
    { { "A", { 0.0, 0.0, ball }, hertz(effective(R), Modulus) } });
  for (const double radius : { 1.0, 3.0, 6.35, 12.0 })
  {
    const MeasuredFilter filter = measure(body, file, "paraboloid:" + std::to_string(radius));
    filter->SetMaximumDeflection(1.5);
    filter->Update();
    const vtkIdType pole = pointAt(body, 0.0, 0.0, ball);
    for (int k = 2; k < 8; ++k)
    {
      const double depth = 1.5 * (k + 1) * (k + 1) / 64.0;
      const double force = array(filter, "ResponseForce")->GetComponent(pole, k);
      const double error = array(filter, "ResponseError")->GetComponent(pole, k);
      const double off = std::abs(force / hertz(effective(radius), Modulus)(depth) - 1.0);
      PALPATE_CHECK(off <= error);
      // The stated error also contains the deflection of the whole body, the curvature of the mesh
      // and the strain, which are a few per cent.
      PALPATE_CHECK(error <= 2.0 * off + 0.04);
    }
  }
}

void checkThreads(const std::string& folder)
{
  std::vector<MadeSite> sites;
  for (int i = 0; i < 5; ++i)
  {
    sites.push_back(
      { "S" + std::to_string(i), { 4.0 * i - 8.0, 2.0, 0.0 }, hertz(R, Modulus * (1 + i)) });
  }
  const std::string file =
    writeCurves(folder + "/threads.csv", "paraboloid:6.35", sites, 1.5, 0.1, 0.001);
  std::vector<vtkSmartPointer<vtkDataArray>> runs;
  for (const int threads : { 1, 3 })
  {
    withThreads(threads,
      [&]
      {
        const MeasuredFilter filter = measure(planeBody(12.0, 20), file, "sphere:1.6");
        filter->Update();
        runs.emplace_back(array(filter, "ResponseForce"));
      });
  }
  bool same = true;
  for (vtkIdType i = 0; i < runs[0]->GetNumberOfValues(); ++i)
  {
    same = same && runs[0]->GetVariantValue(i).ToDouble() == runs[1]->GetVariantValue(i).ToDouble();
  }
  PALPATE_CHECK(same);
}
} // namespace

int TestMeasuredContactResponse(int, char* arguments[])
{
  const std::string folder = arguments[1];
  checkHalfSpace(folder);
  checkGlobalCompliance(folder);
  checkDataEnd(folder);
  checkErrorBetweenSites(folder);
  checkErrorOfCurvature(folder);
  checkThreads(folder);
  return result();
}

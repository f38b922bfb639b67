// SPDX-License-Identifier: BSD-3-Clause
// Runs all steps before a tick for a body with many points. It compares the response with the
// closed form, writes the flat file and reads it back bit by bit, and compares ticks with a search
// over all triangles. It also measures the memory. The body is the bumpy sphere of the benchmarks.
#include "Response/BodyConversion.h"
#include "BumpySphere.h"
#include "DrawnBody.h"
#include "Response/FlatBodyConversion.h"
#include "PlainSearch.h"
#include "ProcessMemory.h"
#include "Contact/ToolContact.h"

#include "vtkContactTool.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkToolContactResponse.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>

namespace
{
using palpate::Vector3;
using palpate::testing::peakMemory;
using Body = vtkSmartPointer<vtkPolyData>;

constexpr double TipRadius = 5.0; // mm; the tool is a paraboloid
constexpr double Modulus = 2.0;   // MPa; ν = 0
constexpr double Range = 2.0;     // mm
constexpr double LargestDepth = 1.5;
// mm; half an ulp of a float at 64 to 128 mm from the centre, plus the rounding of the centre.
constexpr double KeptWithin = 3.9e-6;
// Twice the result of the scale study at eight million points (Data/Studies/scale), which is 975
// bytes. The libraries add some megabytes.
constexpr double MostBytesPerPoint = 2000.0;
constexpr double BytesOfLibraries = 1e9;

/// F = 4/3 E* √R δ^1.5.
double law(double depth)
{
  return 4.0 / 3.0 * Modulus * std::sqrt(TipRadius) * std::pow(depth, 1.5);
}

/// Results of checks, in the order of the checks.
class Findings
{
public:
  void tell(const char* name, double value)
  {
    std::cout << name << " " << value << std::endl;
    this->Figures += this->Figures.empty() ? "" : ", ";
    this->Figures += "\"" + std::string(name) + "\": " + number(value);
  }
  /// Records a check value <= most. NaN fails.
  void expect(const char* name, double value, double most)
  {
    this->tell(name, value);
    if (!(value <= most))
    {
      std::cout << "FAILED: " << name << " must not exceed " << most << std::endl;
      this->Passed = false;
    }
  }
  bool passed() const { return this->Passed; }
  std::string json() const
  {
    return "{\"part\": \"limits\", \"passed\": " + std::string(this->Passed ? "true" : "false") +
      ", \"figures\": {" + this->Figures + "}}\n";
  }

private:
  static std::string number(double value)
  {
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", value);
    return std::isfinite(value) ? text : "null";
  }

  std::string Figures;
  bool Passed = true;
};

Body respond(vtkPolyData* body)
{
  vtkNew<vtkContactTool> tool;
  tool->SetShapeToParaboloid();
  tool->SetRadius(TipRadius);
  vtkNew<vtkToolContactResponse> filter;
  filter->SetInputData(body);
  filter->SetTool(tool);
  filter->SetYoungsModulus(Modulus);
  filter->SetPoissonRatio(0.0);
  filter->SetMaximumDeflection(Range);
  filter->CurvatureCorrectionOff(); // the closed form is valid for a flat body
  filter->Update();
  auto output = Body::New();
  output->ShallowCopy(filter->GetOutput());
  return output;
}

/// Largest relative error of all stored forces.
double responseError(vtkPolyData* body)
{
  vtkDataArray* force = body->GetPointData()->GetArray("ResponseForce");
  double worst =
    force && force->GetNumberOfTuples() == body->GetNumberOfPoints() ? 0.0 : std::nan("");
  for (int k = 0; force && k < 8; ++k)
  {
    const double expected = law(Range * (k + 1) * (k + 1) / 64.0);
    for (vtkIdType i = 0; i < force->GetNumberOfTuples(); ++i)
    {
      worst = std::max(worst, std::abs(force->GetComponent(i, k) / expected - 1.0));
    }
  }
  return worst;
}

/// Returns the number of response arrays that are not bitwise equal in the two bodies.
int arraysThatDiffer(vtkPolyData* one, vtkPolyData* other)
{
  int differ = palpate::copyPoints(one) == palpate::copyPoints(other) ? 0 : 1;
  differ += palpate::copyTriangles(one) == palpate::copyTriangles(other) ? 0 : 1;
  for (const char* name :
    { "Force", "Stiffness", "Normal", "Range", "Status", "Validity", "Limit" })
  {
    vtkDataArray* a = one->GetPointData()->GetArray((std::string("Response") + name).c_str());
    vtkDataArray* b = other->GetPointData()->GetArray((std::string("Response") + name).c_str());
    const bool same = a && b && a->GetDataType() == b->GetDataType() &&
      a->GetNumberOfValues() == b->GetNumberOfValues() &&
      std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
        static_cast<std::size_t>(a->GetNumberOfValues() * a->GetDataTypeSize())) == 0;
    differ += same ? 0 : 1;
  }
  return differ;
}

/// Writes the body to a flat file and reads it back. Returns the body that was read, or
/// `body` on failure.
Body throughFile(const Body& body, const std::string& file, Findings& findings)
{
  std::string error = palpate::writeFlatBody(body, "Response", file);
  Body read;
  if (error.empty())
  {
    read = palpate::readFlatBody(file, "Response", error);
  }
  std::remove(file.c_str());
  if (!read)
  {
    std::cout << error << std::endl;
    findings.expect("flat_file_failed", 1.0, 0.0);
    return body;
  }
  findings.expect("arrays_that_differ_after_the_flat_file", arraysThatDiffer(body, read), 0.0);
  return read;
}

void compareTicks(vtkPolyData* body, int tips, Findings& findings)
{
  std::string error;
  const auto kernel = palpate::makeContactBody(body, "Response", error);
  if (!kernel)
  {
    std::cout << error << std::endl;
    findings.expect("kernel_failed", 1.0, 0.0);
    return;
  }
  const palpate::endurance::PlainSearch search(kernel->surface);
  findings.expect(
    "kernel_coordinates_off_mm", search.roundedBy(palpate::copyPoints(body)), KeptWithin);
  palpate::ToolContact contact(*kernel);
  double depthError = 0.0;
  double forceError = 0.0;
  double touched = 0.0;
  for (int i = 0; i < tips; ++i)
  {
    // Depths from 0.1 to 1.5 mm, at places all over the smooth body.
    const double depth = 0.1 + (LargestDepth - 0.1) * (i % 29) / 28.0;
    const Vector3 tip = palpate::testing::windingTip(depth, 61.7 * i);
    contact.reset();
    const palpate::Contact felt = contact.update(tip);
    const palpate::testing::Nearest nearest = search.nearest(tip);
    const auto expected = static_cast<double>(nearest.distance);
    touched += felt.normalForce > 0.0 ? 1.0 : 0.0;
    depthError = std::max(depthError, std::abs(felt.deflection - expected));
    forceError = std::max(forceError, std::abs(felt.normalForce / law(expected) - 1.0));
  }
  findings.tell("tips", tips);
  findings.expect("tips_that_felt_nothing", tips - touched, 0.0);
  // Rounding error for coordinates of 100 mm.
  findings.expect("deflection_off_mm", depthError, 1e-10);
  findings.expect("force_off_relative", forceError, 1e-6); // forces are stored as floats
}
} // namespace

int main(int argc, char* argv[])
{
  double wanted = 8e6;
  int tips = 300;
  std::string output;
  CLI::App app{ "A body of many points through everything.", "palpateLimits" };
  app.add_option("--points", wanted, "of the body, about (default 8e6)")
    ->check(CLI::Range(100.0, 1e8));
  app.add_option("--tips", tips, "compared with all triangles (default 300)")
    ->check(CLI::Range(1, 1000000));
  app.add_option("--output", output, "the result, JSON; a body file lies beside it for a while")
    ->required();
  CLI11_PARSE(app, argc, argv);

  Findings findings;
  Body body = respond(palpate::benchmarks::drawnBody(2.0 * wanted));
  const auto points = static_cast<double>(body->GetNumberOfPoints());
  findings.tell("points", points);
  findings.tell("triangles", static_cast<double>(body->GetNumberOfPolys()));
  findings.expect("share_of_points_missing", 1.0 - points / wanted, 0.01);
  // Half a unit in the last place.
  findings.expect("stored_force_off_relative", responseError(body), 6e-8);
  body = throughFile(body, output + ".palpate", findings);
  compareTicks(body, tips, findings);
  findings.expect("peak_MiB", peakMemory() / 1048576.0,
    (BytesOfLibraries + MostBytesPerPoint * points) / 1048576.0);
  findings.tell("peak_bytes_per_point", peakMemory() / points);

  std::ofstream file(output);
  file << findings.json();
  file.flush();
  if (!file)
  {
    std::cerr << "palpateLimits: cannot write " << output << std::endl;
    return 1;
  }
  return findings.passed() ? 0 : 1;
}

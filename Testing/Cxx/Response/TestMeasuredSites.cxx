// SPDX-License-Identifier: BSD-3-Clause
// Sites of measured curves on a body: their reach, which does not extend to the other side of a
// thin lobe, their registration, and rejected sites.
#include "FilterChecks.h"
#include "MeasuredFiles.h"

#include "vtkAppendPolyData.h"
#include "vtkReverseSense.h"

namespace
{
using namespace palpate::testing;

constexpr double Modulus = 0.05; // E*, MPa
constexpr double R = 6.35;
const char* const Tip = "paraboloid:6.35";

vtkDataArray* array(vtkMeasuredContactResponse* filter, const char* name)
{
  return filter->GetOutput()->GetPointData()->GetArray(name);
}

/// Two sites on a plane: moduli between the sites and out of their reach.
void checkSpread(const std::string& folder)
{
  const std::string file = writeCurves(folder + "/two.csv", Tip,
    { { "A", { -6.0, 0.0, 0.0 }, hertz(R, Modulus) },
      { "B", { 6.0, 0.0, 0.0 }, hertz(R, 3.0 * Modulus) } });
  const MeasuredFilter filter = measure(planeBody(30.0, 60), file, "sphere:1.6");
  filter->SetReach(15.0);
  Messages messages(filter.Get());
  filter->Update();
  PALPATE_CHECK(messages.none());
  for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
  {
    double x[3];
    filter->GetOutput()->GetPoint(i, x);
    const double toA = std::hypot(x[0] + 6.0, x[1]);
    const double toB = std::hypot(x[0] - 6.0, x[1]);
    const bool reached = toA < 15.0 || toB < 15.0;
    PALPATE_CHECK(array(filter, "ResponseStatus")->GetTuple1(i) == (reached ? 0.0 : 4.0));
    const double modulus = array(filter, "IdentifiedModulus")->GetTuple1(i);
    const double force = array(filter, "ResponseForce")->GetComponent(i, 7);
    if (!reached)
    {
      PALPATE_CHECK(modulus == 0.0 && force == 0.0);
      PALPATE_CHECK(array(filter, "ResponseValidity")->GetTuple1(i) == 0.0);
      continue;
    }
    // Shepard's weights 1/d², which fall to 0 at the reach (Franke and Little 1980), computed by
    // hand.
    const auto weight = [](double d)
    { return d < 15.0 ? std::pow((1.0 - d / 15.0) / std::max(d, 1e-12), 2.0) : 0.0; };
    const double share = weight(toB) / (weight(toA) + weight(toB));
    PALPATE_CHECK_NEAR(modulus, Modulus * (1.0 + 2.0 * share), 1e-8);
  }
}

/// A thin plate of two sheets at a distance of 1 mm with opposite normals: a measurement on one
/// sheet does not apply to the other. The same for a plate with a rim that connects the sheets.
void checkThinLobe(const std::string& folder)
{
  const std::string file =
    writeCurves(folder + "/lobe.csv", Tip, { { "A", { 0.0, 0.0, 0.5 }, hertz(R, Modulus) } });
  vtkNew<vtkReverseSense> down;
  down->SetInputData(planeBody(10.0, 10, -0.5));
  down->ReverseCellsOn();
  vtkNew<vtkAppendPolyData> sheets;
  sheets->AddInputData(planeBody(10.0, 10, 0.5));
  sheets->AddInputConnection(down->GetOutputPort());
  sheets->Update();
  for (const Body& body : { Body(sheets->GetOutput()), boxBody(10.0, 10.0, 0.5, 10) })
  {
    const MeasuredFilter filter = measure(body, file, "sphere:1.6");
    filter->SetReach(40.0);
    filter->Update();
    vtkIdType reached = 0;
    for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
    {
      double x[3];
      body->GetPoint(i, x);
      const bool above = x[2] == 0.5;
      const bool inside =
        std::max(std::abs(x[0]), std::abs(x[1])) < 9.9; // at the edges the normals are not vertical
      const bool valid = array(filter, "ResponseStatus")->GetTuple1(i) == 0.0;
      PALPATE_CHECK(!valid || above);
      PALPATE_CHECK(valid || !above || !inside);
      reached += valid ? 1 : 0;
    }
    PALPATE_CHECK(reached >= 81);
  }
}

void checkDistance(const std::string& folder)
{
  const std::string file = writeCurves(folder + "/far.csv", Tip,
    { { "near", { 0.0, 0.0, 1.0 }, hertz(R, Modulus) },
      { "far", { 0.0, 3.0, 5.0 }, hertz(R, Modulus) } });
  const MeasuredFilter filter = measure(planeBody(10.0, 10), file, "sphere:1.6");
  Messages messages(filter.Get());
  filter->Update();
  PALPATE_CHECK_TEXT(messages.warnings(), "1 of 2 sites", "'far'", "5 mm", "Maximum Site Distance");
  PALPATE_CHECK(messages.errors().empty());
  PALPATE_CHECK_TEXT(siteText(filter, 1, "Verdict"), "5 mm from the surface");
  PALPATE_CHECK(siteText(filter, 0, "Verdict") == "identified");
  messages.clear();
  filter->SetMaximumSiteDistance(0.5);
  filter->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "No site can be used", "'near'", "'far'");
  PALPATE_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
  filter->SetMaximumSiteDistance(6.0);
  filter->Update();
  PALPATE_CHECK(messages.none());
}

std::string writeText(const std::string& path, const std::string& text)
{
  std::ofstream(path) << text;
  return path;
}

/// The frame of the instrument is rotated by 90° about z and moved by (1, 2, 3): x' = 1 - y, y' = 2
/// + x.
void checkRegistration(const std::string& folder)
{
  // The site is at (0, 0, 0.25) in the frame of the body.
  const std::string file =
    writeCurves(folder + "/moved.csv", Tip, { { "A", { -2.0, 1.0, -2.75 }, hertz(R, Modulus) } });
  const MeasuredFilter filter = measure(planeBody(10.0, 10), file, "sphere:1.6");
  Messages messages(filter.Get());
  filter->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "'A'", "2.75 mm");

  const auto check = [&]
  {
    filter->Update();
    PALPATE_CHECK(messages.none());
    PALPATE_CHECK_NEAR(siteNumber(filter, 0, "X (mm)"), 0.0, 1e-13);
    PALPATE_CHECK_NEAR(siteNumber(filter, 0, "Y (mm)"), 0.0, 1e-13);
    PALPATE_CHECK_NEAR(filter->GetSiteResidual(), 0.25, 1e-13);
  };
  filter->SetRegistrationFile(
    writeText(folder + "/matrix.txt", "# to the body\n0 -1 0 1\n1 0 0 2\n0, 0, 1, 3\n0 0 0 1\n"));
  check();
  PALPATE_CHECK(std::isnan(filter->GetRegistrationResidual()));
  const std::string columns = "from_x_mm,from_y_mm,from_z_mm,to_x_mm,to_y_mm,to_z_mm\n";
  filter->SetRegistrationFile(writeText(
    folder + "/pairs.csv", columns + "0,0,0,1,2,3\n10,0,0,1,12,3\n0,10,0,-9,2,3\n0,0,10,1,2,13\n"));
  check();
  PALPATE_CHECK_NEAR(filter->GetRegistrationResidual(), 0.0, 1e-13);

  // Four corners of a square, moved out of the plane by ±0.1 in turn: no other rigid motion fits
  // better, and every pair has a residual of exactly 0.1.
  filter->SetRegistrationFile(writeText(folder + "/rough.csv",
    columns + "0,0,0,1,2,3.1\n10,0,0,1,12,2.9\n10,10,0,-9,12,3.1\n0,10,0,-9,2,2.9\n"));
  filter->Update();
  PALPATE_CHECK(messages.none());
  PALPATE_CHECK_NEAR(filter->GetRegistrationResidual(), 0.1, 1e-12);

  const auto refuse = [&](const std::string& text, std::initializer_list<const char*> words)
  {
    filter->SetRegistrationFile(writeText(folder + "/wrong.txt", text));
    filter->Modified();
    filter->Update();
    checkText(messages.takeErrors(), words, __FILE__, __LINE__);
    PALPATE_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
  };
  refuse("2 0 0 0\n0 2 0 0\n0 0 2 0\n0 0 0 1\n", { "wrong.txt", "not a rigid motion", "8" });
  refuse("1 0 0 0\n0 1 0 0\n0 0 -1 0\n0 0 0 1\n", { "not a rigid motion", "-1" });
  refuse("1 0 0 0\n0 1 0 0\n0 0 1 0\n", { "16 numbers", "12" });
  refuse("1 0 0 0\n0 1 nan 0\n", { "wrong.txt:2", "4 finite numbers" });
  refuse("1 0 0\n", { "wrong.txt:1", "4 finite numbers", "from_x_mm" });
  refuse(columns + "0,0,0,1,2,3\n1,2\n", { "wrong.txt:3", "2 fields instead of 6" });
  refuse(columns + "0,0,0,1,2,3\n1,0,0,2,2,3\n2,0,0,3,2,3\n", { "three pairs", "not in line" });
  filter->SetRegistrationFile("/nowhere/matrix.txt");
  filter->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "/nowhere/matrix.txt", "cannot be opened");
}

void checkRefusals(const std::string& folder)
{
  const auto refuse = [&](const char* tool, const std::function<double(double)>& law,
                        std::initializer_list<const char*> words)
  {
    const std::string file =
      writeCurves(folder + "/refused.csv", tool, { { "here", { 0.0, 0.0, 0.0 }, law } });
    const MeasuredFilter filter = measure(planeBody(10.0, 10), file, "sphere:1.6");
    Messages messages(filter.Get());
    filter->Update();
    checkText(messages.errors(), words, __FILE__, __LINE__);
    PALPATE_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
    PALPATE_CHECK(siteText(filter, 0, "Site").empty()); // no output at all after an error
  };
  refuse("flat:1.6", [](double d) { return 0.1 * d; }, { "'here'", "flat punch", "compliance" });
  refuse(Tip, [](double d) { return std::sqrt(d); }, { "'here'", "no model fits" });
}

void checkProperties(const std::string& folder)
{
  const std::string file = folder + "/two.csv";
  const MeasuredFilter filter = measure(planeBody(10.0, 10), file, "sphere:1.6");
  Messages messages(filter.Get());
  const auto refuse = [&](std::initializer_list<const char*> words)
  {
    filter->Update();
    checkText(messages.takeErrors(), words, __FILE__, __LINE__);
  };
  filter->SetReach(0.0);
  refuse({ "Reach must be positive", "0" });
  filter->SetReach(20.0);
  filter->SetNoise(-1.0);
  refuse({ "Noise", "-1" });
  filter->SetNoise(0.0);
  filter->SetPoissonRatio(0.7);
  refuse({ "Poisson's Ratio", "0.7" });
  filter->SetPoissonRatio(0.45);
  filter->SetMaximumDeflection(-2.0); // rejected by the inner filter
  refuse({ "Maximum Deflection", "-2" });
  filter->SetMaximumDeflection(2.0);
  filter->SetTool(nullptr);
  refuse({ "Tool is required" });
  filter->SetTool(makeTool("sphere:1.6"));
  filter->AddFileName(writeText(folder + "/broken.csv", "# tool: sphere:3\nsite,x_mm\n"));
  refuse({ "broken.csv:2", "y_mm" });
  filter->ClearFileNames();
  refuse({ "AddFileName" });
  filter->AddFileName(file);
  filter->Update();
  PALPATE_CHECK(messages.none() && filter->GetOutput()->GetNumberOfPoints() > 0);
}
} // namespace

int TestMeasuredSites(int, char* arguments[])
{
  const std::string folder = arguments[1];
  checkSpread(folder);
  checkThinLobe(folder);
  checkDistance(folder);
  checkRegistration(folder);
  checkRefusals(folder);
  checkProperties(folder);
  return result();
}

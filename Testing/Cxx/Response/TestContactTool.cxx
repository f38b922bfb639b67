// SPDX-License-Identifier: BSD-3-Clause
// vtkContactTool against the tables of Data/Reference, and its messages on invalid parameters.
#include "FilterChecks.h"
#include "ReferenceTable.h"

#include "vtkContactTool.h"
#include "vtkNew.h"
#include "Mechanics/Numerics/Constants.h"

#include <map>

using palpate::NotANumber;

namespace
{
using palpate::testing::Messages;
using palpate::testing::ReferenceTable;

constexpr double Modulus = 3.45; // E* of the tables, MPa

// The tables have 12 to 14 digits; columns from quadrature have 10.
constexpr double Closed = 1e-11;
constexpr double Quadrature = 1e-10;

void near(double actual, double expected, double relative)
{
  PALPATE_CHECK_NEAR(actual, expected, relative * std::abs(expected));
}

void checkPunches()
{
  const std::map<std::string, std::string> known = { { "flat a=1.6", "flat:1.6" },
    { "sphere_par R=6.35", "paraboloid:6.35" }, { "sphere_par R=1.6", "paraboloid:1.6" },
    { "sphere_exact R=6.35", "sphere:6.35" }, { "sphere_exact R=1.6", "sphere:1.6" },
    { "cone 60deg", "cone:60" }, { "cone 30deg", "cone:30" },
    { "trunc_cone b=1 60deg", "truncated:1,60" }, { "blunt_cone_sph R=1 60deg", "blunted:1,60" },
    { "rounded_flat b=1.2 Re=.4", "rounded:1.2,0.4" }, { "power n=1.5 B=.1", "power:1.5,0.1" },
    { "power n=3 B=.02", "power:3,0.02" }, { "power n=4 B=.01", "power:4,0.01" } };
  const ReferenceTable table("punches.csv");
  vtkNew<vtkContactTool> tool;
  int rows = 0;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const auto found = known.find(table.text(row, "tool"));
    if (found == known.end())
    {
      continue; // the library has no cone blunted by a paraboloid
    }
    ++rows;
    tool->SetSpecification(found->second);
    const double depth = table.number(row, "delta_mm");
    const double a = table.number(row, "a_mm");
    near(tool->GetContactRadius(depth), a, Closed);
    near(tool->GetForce(depth, Modulus), table.number(row, "F_N(E*=3.45MPa)"), Closed);
    near(tool->GetStiffness(depth, Modulus), table.number(row, "dFddelta=2E*a_N/mm"), Closed);
    // Beyond an edge the table's quadrature is inaccurate (see PunchTableTest).
    const int shape = tool->GetShape();
    const bool edge =
      shape == vtkContactTool::TruncatedCone || shape == vtkContactTool::RoundedFlat;
    near(tool->GetPressure(0.5 * a, depth, Modulus), table.number(row, "p(a/2)_MPa"),
      edge ? 5e-3 : Quadrature);
    double u[2];
    tool->GetSurfaceDisplacement(2.0 * a, depth, 0.3, u);
    near(u[1], table.number(row, "uz(2a)_mm"), Quadrature);
    tool->GetSurfaceDisplacement(0.5 * a, depth, 0.3, u);
    near(u[0], table.number(row, "ur(a/2)_mm_nu0.3"), Quadrature);
    // under the tool the surface has the tool's shape
    near(u[1], depth - tool->GetProfile(0.5 * a), Closed);
  }
  PALPATE_CHECK(rows == 52);
}

void checkPaperFigure()
{
  const ReferenceTable table("paper_fig6_F_of_delta.csv");
  const std::map<std::string, std::string> columns = { { "F_flat3.2mm", "flat:1.6" },
    { "F_sphere12.7mm_parab", "paraboloid:6.35" }, { "F_sphere3.2mm_parab", "paraboloid:1.6" },
    { "F_sphere12.7_exact", "sphere:6.35" }, { "F_sphere3.2_exact", "sphere:1.6" } };
  vtkNew<vtkContactTool> tool;
  for (const auto& [column, specification] : columns)
  {
    tool->SetSpecification(specification);
    for (std::size_t row = 0; row < table.size(); ++row)
    {
      near(
        tool->GetForce(table.number(row, "delta_mm"), Modulus), table.number(row, column), Closed);
    }
  }
}

void checkLimits()
{
  vtkNew<vtkContactTool> tool; // a tool with its defaults
  PALPATE_CHECK(tool->GetSpecification() == "sphere:5" && tool->GetHalfAngle() == 60.0);
  PALPATE_CHECK(tool->GetEdgeRadius() == 1.0 && tool->GetProfilePoints() == nullptr);
  PALPATE_CHECK(tool->GetExponent() == 2.0 && tool->GetCoefficient() == 0.1);
  for (const double depth : { 0.0, -1.0 })
  {
    PALPATE_CHECK(tool->GetForce(depth, 1.0) == 0.0 && tool->GetStiffness(depth, 1.0) == 0.0);
    PALPATE_CHECK(tool->GetContactRadius(depth) == 0.0 && tool->GetPressure(0, depth, 1.0) == 0.0);
  }
  PALPATE_CHECK(
    std::isnan(tool->GetForce(NotANumber, 1.0)) && std::isnan(tool->GetContactRadius(NotANumber)));
  PALPATE_CHECK(tool->GetPressure(100.0, 1.0, 1.0) == 0.0);
  tool->SetShapeToFlat();
  PALPATE_CHECK(std::isinf(tool->GetPressure(5.0, 1.0, 1.0)));
  tool->SetShapeToCone();
  PALPATE_CHECK(std::isinf(tool->GetPressure(0.0, 1.0, 1.0)));
  tool->SetShapeToParaboloid();
  PALPATE_CHECK(tool->GetShape() == vtkContactTool::Paraboloid);
  const double before = tool->GetForce(1.0, 1.0);
  tool->SetRadius(20.0); // 4 times the radius, twice the force: the stored law must be renewed
  near(tool->GetForce(1.0, 1.0), 2.0 * before, 1e-15);
}

void checkSpecification()
{
  vtkNew<vtkContactTool> tool;
  Messages messages(tool.Get());
  for (const char* text :
    { "sphere:6.35", "cone:33.3", "flat:0.1", "paraboloid:1.6", "truncated:0.7,31.5",
      "blunted:0.8,44.4", "rounded:1.2,0.3", "power:2.5,0.07", "profile:0,0;0.1,0.02;3,1.7" })
  {
    PALPATE_CHECK(tool->SetSpecification(text) && tool->GetSpecification() == text);
  }
  tool->SetShapeToSphere();
  tool->SetRadius(0.1 + 0.2); // 0.1 + 0.2 is not a short decimal number
  vtkNew<vtkContactTool> other;
  PALPATE_CHECK(other->SetSpecification(tool->GetSpecification()));
  PALPATE_CHECK(other->GetRadius() == tool->GetRadius() && other->GetShape() == tool->GetShape());
  PALPATE_CHECK(messages.none());
  for (const char* text :
    { "", "sphere", "sphere:", "sphere:5x", "sphere:5,6", "ball:5", "sphere:-5", "cone:90",
      "sphere:nan", "truncated:1", "power:0.5,1", "profile:0,0;1,-1", "profile:nowhere.csv" })
  {
    PALPATE_CHECK(!tool->SetSpecification(text));
    PALPATE_CHECK_TEXT(messages.takeErrors(), text);
    PALPATE_CHECK(tool->GetRadius() == 0.1 + 0.2 && tool->GetShape() == vtkContactTool::Sphere);
  }
}

/// Every function of an invalid tool returns NaN and reports an error that names the value.
void checkSize()
{
  vtkNew<vtkContactTool> tool;
  tool->SetShapeToCone();
  tool->SetSize(45.0);
  PALPATE_CHECK(tool->HasSize() && tool->IsSizeAngle());
  PALPATE_CHECK(
    tool->GetSize() == 45.0 && tool->GetHalfAngle() == 45.0 && tool->GetRadius() == 5.0);
  tool->SetShapeToBluntedCone();
  tool->SetSize(2.0);
  PALPATE_CHECK(tool->HasSize() && !tool->IsSizeAngle());
  PALPATE_CHECK(tool->GetSize() == 2.0 && tool->GetHalfAngle() == 45.0 && tool->GetRadius() == 2.0);
  tool->SetShapeToPowerLaw();
  tool->SetSize(3.0);
  PALPATE_CHECK(!tool->HasSize() && tool->GetSize() == 0.0 && tool->GetRadius() == 2.0);
}

void checkInvalid(vtkContactTool* tool, Messages& messages, const char* name, const char* value)
{
  double u[2] = { 0.0, 0.0 };
  tool->GetSurfaceDisplacement(1.0, 1.0, 0.3, u);
  for (const double answer :
    { tool->GetForce(1.0, 1.0), tool->GetStiffness(1.0, 1.0), tool->GetContactRadius(1.0),
      tool->GetPressure(0.0, 1.0, 1.0), tool->GetProfile(1.0), u[0], u[1] })
  {
    PALPATE_CHECK(std::isnan(answer));
  }
  PALPATE_CHECK(tool->GetSpecification().empty());
  PALPATE_CHECK_TEXT(messages.takeErrors(), name, value);
}

void checkErrors()
{
  vtkNew<vtkContactTool> tool;
  Messages messages(tool.Get());
  tool->SetRadius(-1.5);
  checkInvalid(tool, messages, "radius", "-1.5");
  tool->SetRadius(NotANumber);
  checkInvalid(tool, messages, "radius", "nan");
  tool->SetRadius(5.0);
  tool->SetShape(9);
  checkInvalid(tool, messages, "Shape", "9");
  tool->SetShapeToRoundedFlat();
  tool->SetEdgeRadius(-0.25);
  checkInvalid(tool, messages, "edge radius", "-0.25");
  tool->SetShapeToPowerLaw();
  tool->SetExponent(0.75);
  checkInvalid(tool, messages, "exponent", "0.75");
  tool->SetExponent(2.0);
  tool->SetCoefficient(0.0);
  checkInvalid(tool, messages, "coefficient", "0");
  tool->SetShapeToProfile();
  checkInvalid(tool, messages, "two points or more", "0");
  tool->SetShapeToCone();
  tool->SetHalfAngle(95.0);
  checkInvalid(tool, messages, "half angle", "95");
  tool->SetShapeToSphere();
  PALPATE_CHECK(tool->GetForce(1.0, 1.0) > 0.0 && messages.none()); // the tool is valid again

  for (const double modulus : { 0.0, -2.5, NotANumber })
  {
    PALPATE_CHECK(std::isnan(tool->GetForce(1.0, modulus)));
    PALPATE_CHECK_TEXT(messages.errors(), "reduced modulus");
    PALPATE_CHECK(std::isnan(tool->GetStiffness(1.0, modulus)));
    PALPATE_CHECK(std::isnan(tool->GetPressure(0.0, 1.0, modulus)));
    PALPATE_CHECK_TEXT(messages.takeErrors(),
      std::isnan(modulus) ? "nan"
        : modulus < 0.0   ? "-2.5"
                          : "0.");
  }
  double u[2] = { 0.0, 0.0 };
  tool->GetSurfaceDisplacement(1.0, 1.0, 0.6, u);
  PALPATE_CHECK(std::isnan(u[0]) && std::isnan(u[1]));
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Poisson", "0.6");
}
} // namespace

int TestContactTool(int, char*[])
{
  checkPunches();
  checkPaperFigure();
  checkLimits();
  checkSize();
  checkSpecification();
  checkErrors();
  return palpate::testing::result();
}

// SPDX-License-Identifier: BSD-3-Clause
// A tilted tool: its arrays in a response, its force in the probe, its validity, the choice of
// terms, and rejected input.
#include "FilterChecks.h"
#include "ReferenceTable.h"
#include "TestBodies.h"

#include "Response/BodyConversion.h"
#include "Response/FlatBodyConversion.h"
#include "vtkFieldData.h"
#include "vtkReducedContactResponse.h"
#include "vtkResponseChoice.h"
#include "vtkToolContactProbe.h"

#include <cmath>
#include <string>
#include <vector>

namespace
{
using namespace palpate::testing;
using Filter = vtkSmartPointer<vtkToolContactResponse>;

constexpr double Degree = 0.017453292519943295;

/// A response with tilts on a half-space with E* = 1 MPa, as in the tables.
Filter tiltable(vtkPolyData* body, const std::string& tool, double range, double tilt)
{
  Filter filter = filterOf(body, tool.c_str(), range);
  filter->SetYoungsModulus(1.0);
  filter->SetPoissonRatio(0.0);
  makePlain(filter);
  filter->SetMaximumTilt(tilt);
  return filter;
}

/// Result for one tip at (1.1, 2.3) at this depth, with the tool tilted towards +x.
struct Felt
{
  double force = 0.0;
  double torque = 0.0; ///< about -y: positive if it turns the tool upright
  double tilt = 0.0;   ///< degrees
  int state = 0;
};

Felt felt(vtkPolyData* body, double depth, double degrees)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(1.1, 2.3, -depth);
  auto tips = Body::New();
  tips->SetPoints(points);
  vtkNew<vtkDoubleArray> axis;
  axis->SetName("ToolAxis");
  axis->SetNumberOfComponents(3);
  axis->InsertNextTuple3(std::sin(degrees * Degree), 0.0, std::cos(degrees * Degree));
  tips->GetPointData()->AddArray(axis);
  vtkNew<vtkToolContactProbe> probe;
  probe->SetInputData(body);
  probe->SetTipData(tips);
  probe->Update();
  vtkPointData* data = probe->GetOutput()->GetPointData();
  return { data->GetArray("NormalForce")->GetTuple1(0),
    -data->GetArray("Torque")->GetComponent(0, 1), data->GetArray("Tilt")->GetTuple1(0),
    static_cast<int>(data->GetArray("ContactState")->GetTuple1(0)) };
}

/// Compares with the table rows of one tool, for depths from a fifth of its size on and tilts up to
/// `tilt` degrees.
void checkAgainstTable(
  const char* name, const char* tool, double tilt, double forceTolerance, double torqueTolerance)
{
  const Filter filter = tiltable(planeBody(30.0, 6), tool, 1.2, tilt);
  filter->Update();
  const ReferenceTable table("tilt/tilt_bem.csv");
  int compared = 0;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double angle = table.number(row, "theta_deg");
    const double depth = table.number(row, "D");
    if (table.text(row, "tool") != name || angle == 0.0 || angle > tilt || depth < 0.2 ||
      depth > 1.0)
    {
      continue;
    }
    const double drop = -table.number(row, "z_deepest");
    const Felt tilted = felt(filter->GetOutput(), depth - drop, angle);
    const double force = table.number(row, "F_over_Estar");
    PALPATE_CHECK_NEAR(tilted.force, force, forceTolerance * force);
    PALPATE_CHECK_NEAR(tilted.torque, table.number(row, "Mtip_vertical"), torqueTolerance * force);
    PALPATE_CHECK_NEAR(tilted.tilt, angle, 1e-9);
    ++compared;
  }
  PALPATE_CHECK(compared > 3);
}

void checkTables()
{
  // For a flat end the table includes the wall, which is in contact as well: 1.7 % of the force up
  // to 30 degrees by the reference sheet, and slightly more of the torque because of the lever arm
  // a. Torques of the other tools are computed from the pressures without the couple of their
  // tangential part, which is 2 to 8 % for a cone. Tolerances of torques are in mm times the force;
  // the tools have a size of 1 mm.
  checkAgainstTable("flat", "flat:1", 20.0, 0.017, 0.025);
  checkAgainstTable("cone60", "cone:60", 25.0, 0.006, 0.15);
  checkAgainstTable("blunt45", "blunted:1,45", 30.0, 0.006, 0.03);
}

/// The force on a tilted sphere has a closed form, also if the tip is outside the body.
void checkSphere()
{
  const Filter filter = tiltable(planeBody(30.0, 6), "sphere:5", 1.0, 60.0);
  filter->Update();
  for (const double depth : { -0.1, 0.05, 0.4 })
  {
    for (const double angle : { 12.0, 25.0 })
    {
      const double deep = depth + 5.0 * (1.0 - std::cos(angle * Degree));
      const double force = deep > 0.0 ? filter->GetTool()->GetForce(deep, 1.0) : 0.0;
      const Felt tilted = felt(filter->GetOutput(), depth, angle);
      // curves are floats, drops have an error of 1e-8 R
      PALPATE_CHECK_NEAR(tilted.force, force, 1e-4 * force);
      PALPATE_CHECK_NEAR(tilted.torque, 5.0 * std::sin(angle * Degree) * force, 1e-4 * force);
    }
  }
  const Filter little = tiltable(planeBody(30.0, 6), "sphere:5", 1.0, 20.0);
  little->Update();
  // a larger tilt than the response has
  PALPATE_CHECK(felt(little->GetOutput(), 0.1, 21.0).state == 6);
  PALPATE_CHECK(felt(little->GetOutput(), 0.1, 19.0).state == 2);
}

/// A tilt of five degrees halves the force of a flat end at a small depth.
void checkHalved()
{
  const Filter filter = tiltable(planeBody(30.0, 6), "flat:1.6", 1.0, 10.0);
  filter->Update();
  const double drop = 1.6 * std::sin(5.0 * Degree);
  const double upright = felt(filter->GetOutput(), 0.32, 0.0).force;
  PALPATE_CHECK_NEAR(upright, 2.0 * 1.6 * 0.32, 1e-6);
  // tilt_bem.csv states 0.5757 for D = 0.2 of the radius.
  PALPATE_CHECK_NEAR(felt(filter->GetOutput(), 0.32 - drop, 5.0).force / upright, 0.5757, 0.003);
}

/// Without tilts no array of them remains, not even one from another response of the same name.
void checkOff()
{
  const auto body = planeBody(10.0, 4);
  const Filter on = tiltable(body, "flat:1", 1.0, 20.0);
  on->Update();
  const auto has = [](vtkPolyData* made, const char* name)
  { return made->GetFieldData()->HasArray(name) != 0; };
  for (const char* name : { "ResponseTilt", "ResponseTiltDrop", "ResponseTiltNode" })
  {
    PALPATE_CHECK(has(on->GetOutput(), name));
  }
  PALPATE_CHECK(!on->GetOutput()->GetPointData()->HasArray("ResponseTiltWeight"));
  const Filter off = tiltable(body, "flat:1", 1.0, 0.0);
  off->SetInputConnection(on->GetOutputPort());
  off->Update();
  PALPATE_CHECK(!has(off->GetOutput(), "ResponseTilt") &&
    !has(off->GetOutput(), "ResponseTiltDrop") && !has(off->GetOutput(), "ResponseTiltNode"));
  // Without tilts in the response the tool counts as upright and has no torque.
  const Felt upright = felt(off->GetOutput(), 0.5, 20.0);
  PALPATE_CHECK_NEAR(upright.force, 2.0 * 0.5, 1e-6);
  PALPATE_CHECK(upright.torque == 0.0);
}

/// On a layer the forces are those of tilts on a layer, and the validity is limited.
void checkLayer()
{
  const auto body = planeBody(30.0, 6);
  const auto layered = [&body](double tilt, double thickness)
  {
    Filter filter = tiltable(body, "flat:1", 0.5, tilt);
    filter->SetPoissonRatio(0.45);
    filter->SetYoungsModulus(1.0 - 0.45 * 0.45);
    filter->SetLayerThickness(thickness);
    filter->SetErrorTolerance(0.05);
    filter->Update();
    return filter;
  };
  // tilt_layer_nu0.45.csv: a flat end with a/h = 0.5, D = 0.2 and 5 degrees has 0.4052 of E*. The
  // equivalent profile has an error of 2.1 % by the reference sheet.
  const Filter half = layered(10.0, 2.0);
  const double drop = std::sin(5.0 * Degree);
  PALPATE_CHECK_NEAR(felt(half->GetOutput(), 0.2 - drop, 5.0).force, 0.4052, 0.025 * 0.4052);

  const auto validity = [](const Filter& filter, const char* name)
  { return filter->GetOutput()->GetPointData()->GetArray(name)->GetTuple1(24); }; // 24: the middle
  const Filter upright = layered(0.0, 1.0);
  const Filter tilted = layered(25.0, 1.0);
  PALPATE_CHECK(validity(tilted, "ResponseLimit") == 8.0);
  PALPATE_CHECK(validity(tilted, "ResponseValidity") < validity(upright, "ResponseValidity"));
  PALPATE_CHECK(validity(layered(25.0, 50.0), "ResponseLimit") != 8.0);
}

/// A thickness that varies from point to point: the laws and their weights are kept in every form
/// and in a file.
void checkKept(const std::string& folder)
{
  const auto body = planeBody(30.0, 6);
  vtkNew<vtkDoubleArray> thickness;
  thickness->SetName("Thickness");
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    thickness->InsertNextValue(2.0 + 0.2 * static_cast<double>(i % 20));
  }
  body->GetPointData()->AddArray(thickness);
  const Filter filter = tiltable(body, "cone:60", 0.5, 20.0);
  filter->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Thickness");
  filter->Update();
  vtkDataArray* weight = filter->GetOutput()->GetPointData()->GetArray("ResponseTiltWeight");
  PALPATE_CHECK(weight && weight->GetNumberOfComponents() > 1);
  const Felt direct = felt(filter->GetOutput(), 0.3, 12.0);

  vtkNew<vtkReducedContactResponse> compact;
  compact->SetInputConnection(filter->GetOutputPort());
  compact->SetTolerance(1e-5);
  compact->Update();
  PALPATE_CHECK_NEAR(
    felt(compact->GetOutput(), 0.3, 12.0).force, direct.force, 1e-4 * direct.force);

  const std::string path = folder + "/tilted.palpate";
  PALPATE_CHECK(palpate::writeFlatBody(filter->GetOutput(), "Response", path).empty());
  std::string error;
  const auto read = palpate::readFlatBody(path, "Response", error);
  PALPATE_CHECK(read != nullptr);
  const Felt again = felt(read, 0.3, 12.0);
  PALPATE_CHECK(again.force == direct.force && again.torque == direct.torque);
}

void checkChoice()
{
  const auto reasonOf = [](vtkAlgorithm* response)
  {
    vtkNew<vtkResponseChoice> choice;
    choice->SetInputConnection(response->GetOutputPort());
    choice->SetTolerance(0.01);
    choice->Update();
    const bool kept = choice->GetOutput()->GetFieldData()->HasArray("ResponseTilt") != 0;
    return std::string(kept ? "kept: " : "left: ") + choice->GetReason();
  };
  const Filter flat = tiltable(planeBody(10.0, 4), "flat:1", 0.5, 20.0);
  PALPATE_CHECK_TEXT(
    reasonOf(flat), "kept: ", "A tilt of ", "degrees changes the force by ", "N mm");
  // A tilt of a tenth of a degree has no effect on a needle.
  const Filter needle = tiltable(planeBody(10.0, 4), "cone:20", 0.5, 0.1);
  PALPATE_CHECK_TEXT(reasonOf(needle), "left: ", "Tilts of the tool are left out", "within 1 %");
}

void checkFaults()
{
  const auto faultOf = [](const char* tool, double tilt)
  {
    const Filter filter = tiltable(planeBody(10.0, 4), tool, 1.0, tilt);
    Messages messages(filter.Get());
    filter->Update();
    PALPATE_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
    return messages.takeErrors();
  };
  // The largest tilt of the cone is 90 - 60 - 4 degrees.
  PALPATE_CHECK_TEXT(faultOf("cone:60", 27.0), "Maximum Tilt", "27", "26");
  PALPATE_CHECK_TEXT(faultOf("flat:1", 85.0), "Maximum Tilt", "85");
  PALPATE_CHECK_TEXT(faultOf("flat:1", -1.0), "Maximum Tilt must be finite and not negative", "-1");
  PALPATE_CHECK_TEXT(faultOf("flat:1", std::nan("")), "Maximum Tilt", "nan");

  const Filter filter = tiltable(planeBody(10.0, 4), "flat:1", 1.0, 20.0);
  filter->Update();
  const auto errorWith = [&filter](const char* name, int value, double number)
  {
    auto broken = Body::New();
    broken->DeepCopy(filter->GetOutput());
    broken->GetFieldData()->GetArray(name)->SetComponent(0, value, number);
    palpate::ResponseArrays arrays;
    std::string error;
    PALPATE_CHECK(!palpate::viewResponse(broken, "Response", arrays, error));
    return error;
  };
  PALPATE_CHECK_TEXT(errorWith("ResponseTilt", 0, -1.0), "'ResponseTilt'", "range", "-1");
  PALPATE_CHECK_TEXT(errorWith("ResponseTilt", 1, 2.0), "'ResponseTilt'", "largest tilt", "2");
  PALPATE_CHECK_TEXT(errorWith("ResponseTilt", 3, 2.5), "number of depths");
  PALPATE_CHECK_TEXT(errorWith("ResponseTilt", 4, 20.0), "'ResponseTiltNode'", "tuples");
  PALPATE_CHECK_TEXT(errorWith("ResponseTilt", 6, 2.0), "'ResponseTiltNode'");
  PALPATE_CHECK_TEXT(errorWith("ResponseTiltDrop", 1, std::nan("")), "value 1 of the drops");
  PALPATE_CHECK_TEXT(errorWith("ResponseTiltNode", 2, INFINITY), "value 2 of the nodes");
}
} // namespace

int TestTilt(int argc, char* argv[])
{
  checkTables();
  checkSphere();
  checkHalved();
  checkOff();
  checkLayer();
  checkKept(argc > 1 ? argv[1] : ".");
  checkChoice();
  checkFaults();
  return palpate::testing::result();
}

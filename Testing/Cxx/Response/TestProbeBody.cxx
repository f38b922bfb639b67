// SPDX-License-Identifier: BSD-3-Clause
// The probe's copy of the body: progress while the copy is built, and one warning for all defects
// of the mesh.
#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkCallbackCommand.h"
#include "vtkToolContactProbe.h"

#include <limits>
#include <vector>

namespace
{
using namespace palpate::testing;

Body oneTip(double x, double y, double z)
{
  auto tips = Body::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(x, y, z);
  tips->SetPoints(points);
  return tips;
}

/// The progress values that a probe reports.
std::vector<double> progressOf(vtkToolContactProbe* probe)
{
  std::vector<double> told;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&told);
  listener->SetCallback([](vtkObject*, unsigned long, void* client, void* share)
    { static_cast<std::vector<double>*>(client)->push_back(*static_cast<double*>(share)); });
  const unsigned long tag = probe->AddObserver(vtkCommand::ProgressEvent, listener);
  probe->Update();
  probe->RemoveObserver(tag);
  return told;
}

void checkProgress()
{
  vtkNew<vtkToolContactProbe> probe;
  probe->SetInputData(withResponse(sphereBody(20.0, 5), "sphere:5"));
  probe->SetTipData(oneTip(0.0, 0.0, 19.5));
  const std::vector<double> told = progressOf(probe);
  PALPATE_CHECK(told.size() > 4); // begin, at least three steps in between, end
  PALPATE_CHECK(!told.empty() && told.front() == 0.0 && told.back() == 1.0);
  int between = 0;
  for (std::size_t i = 1; i < told.size(); ++i)
  {
    PALPATE_CHECK(told[i] >= told[i - 1]);
    between += told[i] > 0.0 && told[i] < 1.0;
  }
  PALPATE_CHECK(between >= 3);
  probe->SetTipData(
    // the copy of the body is kept, so no progress is reported for building it
    oneTip(0.0, 0.0, 19.4));
  PALPATE_CHECK(progressOf(probe).size() <= 2);
}

void checkSoundBodies()
{
  for (const Body& body : { sphereBody(10.0, 2), boxBody(5.0, 5.0, 5.0, 3), planeBody(5.0, 4) })
  {
    vtkNew<vtkToolContactProbe> probe;
    Messages messages(probe);
    probe->SetInputData(withResponse(body, "sphere:5"));
    probe->SetTipData(oneTip(0.1, 0.2, 0.3));
    probe->Update();
    PALPATE_CHECK(messages.none());
  }
}

/// A plate with two reversed triangles, one triangle without area, and three triangles at one edge.
Body unsoundPlate()
{
  const Body plate = withResponse(planeBody(5.0, 8), "flat:1");
  Body body = Body::New();
  body->DeepCopy(plate);
  const vtkIdType points = plate->GetNumberOfPoints();
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType cell = 0; cell < plate->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corner = nullptr;
    plate->GetCellPoints(cell, size, corner);
    const bool isTurned = cell == 40 || cell == 90;
    triangles->InsertNextCell({ corner[0], corner[isTurned ? 2 : 1], corner[isTurned ? 1 : 2] });
  }
  // a triangle without area
  triangles->InsertNextCell({ vtkIdType(0), vtkIdType(1), vtkIdType(1) });
  // a third triangle at its edge
  triangles->InsertNextCell({ vtkIdType(30), vtkIdType(31), points - 1 });
  body->SetPolys(triangles);
  return body;
}

void checkUnsoundBody()
{
  const Body body = unsoundPlate();
  vtkNew<vtkToolContactProbe> probe;
  Messages messages(probe);
  probe->SetInputData(body);
  probe->SetTipData(oneTip(2.1, -1.1, -0.5));
  probe->Update();
  const std::string warning = messages.warnings();
  PALPATE_CHECK_TEXT(warning, "mesh",
    "2 triangles wound inward or against their neighbours: turned over",
    "1 triangle without area: left out", "1 edge of more than two triangles");
  PALPATE_CHECK(messages.errors().empty());
  PALPATE_CHECK(warning.find("joined") == std::string::npos);
  // The plate is evaluated as a valid body: a punch of radius 1 has F = 2 E* δ.
  PALPATE_CHECK_NEAR(probe->GetOutput()->GetPointData()->GetArray("NormalForce")->GetTuple1(0),
    2.0 * 3.45 * 0.5, 1e-6); // stored as floats

  // The defects are reported once, and not again for other tips, other settings or another response
  // of the same body.
  messages.clear();
  probe->SetTipData(oneTip(2.1, -1.1, -0.4));
  probe->Update();
  probe->SetForceFormToPaper();
  probe->Update();
  probe->SetResponseName("Other");
  probe->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "no response 'Other'");
  probe->SetResponseName("Response");
  probe->Update();
  PALPATE_CHECK(messages.none());
  // They are reported again after the body has changed.
  body->GetPoints()->SetPoint(80, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  body->GetPoints()->Modified();
  probe->Update();
  PALPATE_CHECK_TEXT(messages.warnings(),
    "coordinate that is not finite or beyond 1e14 mm: left out",
    "2 triangles wound inward or against their neighbours");
}

/// Separate corners for each triangle, as in an STL file.
void checkSeparateTriangles()
{
  const Body whole = withResponse(boxBody(5.0, 5.0, 5.0, 2), "flat:1");
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType cell = 0; cell < whole->GetNumberOfCells(); ++cell)
  {
    triangles->InsertNextCell(3);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      triangles->InsertCellPoint(
        points->InsertNextPoint(whole->GetPoint(whole->GetCell(cell)->GetPointId(k))));
    }
  }
  Body soup = Body::New();
  soup->SetPoints(points);
  soup->SetPolys(triangles);
  vtkNew<vtkToolContactProbe> probe;
  Messages messages(probe);
  probe->SetInputData(withResponse(soup, "flat:1"));
  probe->SetTipData(oneTip(0.4, 0.3, 4.5));
  probe->Update();
  PALPATE_CHECK(messages.none()); // joining points is not a defect
  PALPATE_CHECK_NEAR(
    probe->GetOutput()->GetPointData()->GetArray("Deflection")->GetTuple1(0), 0.5, 1e-14);
}
} // namespace

int TestProbeBody(int, char*[])
{
  checkProgress();
  checkSoundBodies();
  checkUnsoundBody();
  checkSeparateTriangles();
  return palpate::testing::result();
}

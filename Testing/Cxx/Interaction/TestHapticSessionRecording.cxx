// SPDX-License-Identifier: BSD-3-Clause
// The recording of a session equals the output of vtkToolContactProbe for the same tips, bit by
// bit.
#include "Response/FilterChecks.h"
#include "SceneBodies.h"
#include "Haptics/Devices/TrajectoryFile.h"
#include "Haptics/Servo/ServoStep.h"

#include "vtkHapticSession.h"
#include "vtkSessionFiles.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <cstdio>
#include <cstring>

namespace
{
using namespace palpate::testing;

/// The bumpy sphere with a vertex cell and a line before its triangles, which shift the cell ids.
Body bodyWithOtherCells()
{
  Body body = withResponse(bumpySphere(), "sphere:6.35");
  vtkNew<vtkCellArray> vertex;
  vertex->InsertNextCell({ vtkIdType(0) });
  vtkNew<vtkCellArray> line;
  line->InsertNextCell({ vtkIdType(0), vtkIdType(1) });
  body->SetVerts(vertex);
  body->SetLines(line);
  return body;
}

void checkSameArray(vtkDataArray* one, vtkDataArray* other, const char* name)
{
  const bool alike = one && other && one->GetDataType() == other->GetDataType() &&
    one->GetNumberOfComponents() == other->GetNumberOfComponents() &&
    one->GetNumberOfTuples() == other->GetNumberOfTuples();
  PALPATE_CHECK(alike);
  if (alike)
  {
    const std::size_t bytes = static_cast<std::size_t>(one->GetNumberOfValues()) *
      static_cast<std::size_t>(one->GetDataTypeSize());
    const bool same = std::memcmp(one->GetVoidPointer(0), other->GetVoidPointer(0), bytes) == 0;
    PALPATE_CHECK(same);
    if (!same)
    {
      std::cerr << "  array " << name << std::endl;
    }
  }
}

void checkProbeAgrees(vtkPolyData* body, vtkPolyData* recording)
{
  Body tips = Body::New();
  tips->CopyStructure(recording);
  const Body expected = probed(body, tips);
  for (const char* name : { "Force", "NormalForce", "FrictionForce", "Deflection", "Normal",
         "ContactPoint", "ContactCell", "ContactState" })
  {
    checkSameArray(
      recording->GetPointData()->GetArray(name), expected->GetPointData()->GetArray(name), name);
  }
}

/// Compares the newest values and the statistics with the arrays.
void checkSummary(vtkHapticSession* session, vtkPolyData* recording)
{
  vtkPointData* data = recording->GetPointData();
  double peakForce = 0.0;
  double peakDeflection = 0.0;
  double inContact = 0.0;
  for (vtkIdType i = 0; i < recording->GetNumberOfPoints(); ++i)
  {
    peakForce = std::max(peakForce, vtkMath::Norm(data->GetArray("Force")->GetTuple3(i)));
    peakDeflection = std::max(peakDeflection, data->GetArray("Deflection")->GetTuple1(i));
    inContact += data->GetArray("ContactCell")->GetTuple1(i) >= 0.0 ? 1.0 : 0.0;
    // A sphere of 6.35 mm, 1 mm deep at E* = 3.45 MPa, exceeds the device's 10 N.
    const double applied = vtkMath::Norm(data->GetArray("AppliedForce")->GetTuple3(i));
    const double wanted = vtkMath::Norm(data->GetArray("Force")->GetTuple3(i));
    PALPATE_CHECK_NEAR(applied, std::min(wanted, 10.0), 1e-12);
  }
  PALPATE_CHECK(peakForce > 10.0 && peakDeflection > 0.9);
  vtkNew<vtkTable> statistics;
  session->GetRecorder()->GetStatistics(statistics);
  const auto value = [&statistics](const char* column)
  { return statistics->GetValueByName(0, column).ToDouble(); };
  PALPATE_CHECK(statistics->GetNumberOfRows() == 1);
  PALPATE_CHECK(value("Ticks") == static_cast<double>(recording->GetNumberOfPoints()));
  PALPATE_CHECK(value("TicksInContact") == inContact);
  PALPATE_CHECK_NEAR(value("PeakForce (N)"), peakForce, 1e-14 * peakForce);
  PALPATE_CHECK(value("PeakDeflection (mm)") == peakDeflection);
  PALPATE_CHECK(value("MedianTick (ns)") > 0.0);
  PALPATE_CHECK(value("Percentile99Tick (ns)") >= value("MedianTick (ns)"));

  const vtkIdType last = recording->GetNumberOfPoints() - 1;
  double tip[3];
  double contact[3];
  session->GetTip(tip);
  session->GetContactPoint(contact);
  PALPATE_CHECK(std::equal(tip, tip + 3, recording->GetPoint(last)));
  PALPATE_CHECK(std::equal(contact, contact + 3, data->GetArray("ContactPoint")->GetTuple3(last)));
  PALPATE_CHECK(session->GetDeflection() == data->GetArray("Deflection")->GetTuple1(last));
  PALPATE_CHECK(session->GetContactState() == data->GetArray("ContactState")->GetTuple1(last));
}

/// A record of a part of the session continues over a stop and a start, and has every change of the
/// setup at its time.
void checkFileOverTwoRuns(vtkPolyData* body)
{
  vtkNew<vtkHapticSession> session;
  session->SetBody(body);
  session->GetDevice()->SetPath(slidePath(body, { -0.5, -0.8, 0.6 }, { 0.6, -0.8, 0.5 }, 1.0));
  session->GetRecorder()->SetHistorySeconds(1.0);
  vtkNew<vtkSessionFiles> files;
  files->SetSession(session);
  PALPATE_CHECK(session->Start());
  session->Step(0.5);
  PALPATE_CHECK(files->StartRecording());
  session->Step(0.1);
  session->GetSettings()->SetFrictionCoefficient(0.5);
  PALPATE_CHECK(session->ApplyChanges());
  session->Step(0.1);
  session->Stop();
  session->GetSettings()->SetFrictionCoefficient(0.0);
  PALPATE_CHECK(session->Start());
  session->Step(0.2);
  const char* const file = "TestHapticSessionRecording.csv";
  PALPATE_CHECK(files->WriteRecording(file) == file);
  palpate::Trajectory record;
  PALPATE_CHECK(palpate::readTrajectory(file, record).empty());
  std::remove(file);
  PALPATE_CHECK(record.rows.size() == 400);
  for (std::size_t i = 1; i < record.rows.size(); ++i)
  {
    PALPATE_CHECK_NEAR(record.rows[i].time - record.rows[i - 1].time, 1e-3, 1e-9);
  }
  const auto frictionAt = [&record](double time) -> std::string
  {
    const palpate::RecordedSetup* setup = record.setups.at(time);
    return setup ? (*setup)[palpate::SetupPart::Friction].substr(0, 8) : std::string();
  };
  PALPATE_CHECK(frictionAt(0.55) == "none");
  PALPATE_CHECK(frictionAt(0.65) == "mu = 0.5");
  PALPATE_CHECK(frictionAt(0.75) == "none");
  PALPATE_CHECK(record.setups.all().size() == 3);
}
} // namespace

int TestHapticSessionRecording(int, char*[])
{
  const Body body = bodyWithOtherCells();
  vtkNew<vtkHapticSession> session;
  session->SetBody(body);
  session->GetDevice()->SetPath(slidePath(body, { -0.5, -0.8, 0.6 }, { 0.6, -0.8, 0.5 }, 1.0));

  // Before the start the recording is empty, without an error.
  vtkNew<vtkPolyData> recording;
  vtkNew<vtkTable> statistics;
  Messages messages(session);
  session->GetRecorder()->GetRecording(recording);
  session->GetRecorder()->GetStatistics(statistics);
  PALPATE_CHECK(recording->GetNumberOfPoints() == 0 && recording->GetNumberOfCells() == 0);
  PALPATE_CHECK(statistics->GetValueByName(0, "Ticks").ToDouble() == 0.0);
  PALPATE_CHECK(session->Start());

  // During the contact, and after the end of the path.
  for (const double seconds : { 1.7, session->GetDevice()->GetPathDuration() - 1.7 })
  {
    session->Step(seconds);
    session->GetRecorder()->GetRecording(recording);
    PALPATE_CHECK(recording->GetNumberOfLines() == 1);
    PALPATE_CHECK(recording->GetNumberOfPoints() ==
      static_cast<vtkIdType>(session->GetRecorder()->GetTicks().size()));
    for (vtkIdType i = 0; i < recording->GetNumberOfPoints(); ++i)
    {
      PALPATE_CHECK(recording->GetPointData()->GetArray("Time")->GetTuple1(i) ==
        session->GetRecorder()->GetTicks()[static_cast<std::size_t>(i)].time);
    }
    checkProbeAgrees(body, recording);
    checkSummary(session, recording);
  }
  PALPATE_CHECK(messages.none());
  checkFileOverTwoRuns(body);
  return palpate::testing::result();
}

// SPDX-License-Identifier: BSD-3-Clause
// The trajectory of a session is written and read again with time steps, and has the same bits as
// the recording.
#include "EventfulPath.h"
#include "Response/FilterChecks.h"

#include "Haptics/Devices/TrajectoryFile.h"
#include "vtkHapticSession.h"
#include "vtkTrajectoryReader.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <cstdio>
#include <fstream>

namespace
{
using namespace palpate::testing;

constexpr const char* File = "TestTrajectoryReader.csv";

void checkSame(vtkPolyData* read, vtkPolyData* recording, const char* name)
{
  vtkDataArray* one = read->GetPointData()->GetArray(name);
  vtkDataArray* other = recording->GetPointData()->GetArray(name);
  PALPATE_CHECK(one && other && one->GetNumberOfComponents() == other->GetNumberOfComponents());
  for (vtkIdType i = 0; one && other && i < read->GetNumberOfPoints(); ++i)
  {
    for (int k = 0; k < one->GetNumberOfComponents(); ++k)
    {
      PALPATE_CHECK(one->GetComponent(i, k) == other->GetComponent(i, k));
    }
  }
}

/// Compares the tips up to a time with the times of the recording.
void checkUpTo(vtkTrajectoryReader* reader, vtkPolyData* recording, double time)
{
  reader->UpdateTimeStep(time);
  vtkPolyData* read = reader->GetOutput();
  vtkDataArray* times = recording->GetPointData()->GetArray("Time");
  vtkIdType expected = 0;
  while (expected < times->GetNumberOfTuples() && times->GetTuple1(expected) <= time + 1e-8)
  {
    ++expected;
  }
  PALPATE_CHECK(read->GetNumberOfPoints() == expected);
  PALPATE_CHECK(read->GetNumberOfLines() == (expected > 0 ? 1 : 0));
  for (const char* name :
    { "Time", "ContactPoint", "Deflection", "NormalForce", "FrictionForce", "ContactState" })
  {
    checkSame(read, recording, name);
  }
  for (vtkIdType i = 0; i < expected; ++i)
  {
    double one[3];
    double other[3];
    read->GetPoint(i, one);
    recording->GetPoint(i, other);
    PALPATE_CHECK(std::equal(one, one + 3, other));
  }
}

void checkRecording()
{
  vtkNew<vtkHapticSession> session;
  session->SetBody(openBall());
  session->GetDevice()->SetPath(handPath());
  session->GetSettings()->SetFrictionCoefficient(0.3);
  PALPATE_CHECK(session->Start());
  session->Step(Duration);
  session->Stop();
  vtkNew<vtkPolyData> recording;
  session->GetRecorder()->GetRecording(recording);
  PALPATE_CHECK(palpate::writeTrajectory(
    File, session->GetRecorder()->GetTicks(), session->GetRecorder()->GetSetups())
                  .empty());

  vtkNew<vtkTrajectoryReader> reader;
  Messages messages(reader);
  PALPATE_CHECK(vtkTrajectoryReader::CanReadFile(File) == 1);
  reader->SetFileName(File);
  reader->SetFrameRate(50.0);
  reader->UpdateInformation();
  vtkInformation* info = reader->GetOutputInformation(0);
  const int steps = info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  const double* step = info->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  const double* range = info->Get(vtkStreamingDemandDrivenPipeline::TIME_RANGE());
  const double last =
    recording->GetPointData()->GetArray("Time")->GetTuple1(recording->GetNumberOfPoints() - 1);
  // The time steps are every 20 ms from 0 to 2.48 s, and the last tick.
  PALPATE_CHECK(range && range[0] == 0.0 && range[1] == last);
  PALPATE_CHECK(steps == 126);
  for (int i = 0; i + 1 < steps; ++i)
  {
    PALPATE_CHECK_NEAR(step[i], 0.02 * i, 1e-12);
  }
  PALPATE_CHECK(step[steps - 1] == last);

  for (const double time : { step[0], step[57], 1.2345, last, last + 1.0, -1.0 })
  {
    checkUpTo(reader, recording, time);
  }
  reader->WholePathOn();
  reader->UpdateInformation();
  PALPATE_CHECK(
    !reader->GetOutputInformation(0)->Has(vtkStreamingDemandDrivenPipeline::TIME_STEPS()));
  reader->UpdateTimeStep(0.0);
  PALPATE_CHECK(reader->GetOutput()->GetNumberOfPoints() == recording->GetNumberOfPoints());
  auto* setup = vtkStringArray::SafeDownCast(
    reader->GetOutput()->GetFieldData()->GetAbstractArray("RecordedSetup"));
  PALPATE_CHECK(setup && setup->GetNumberOfValues() == 3);
  for (vtkIdType i = 0; setup && i < setup->GetNumberOfValues(); ++i)
  {
    constexpr const char* names[] = { "tool: ", "model: ", "friction: mu = 0.3, " };
    PALPATE_CHECK(setup->GetValue(i).rfind(names[i], 0) == 0);
  }
  PALPATE_CHECK(messages.none());
}

void write(const char* text)
{
  std::ofstream(File) << text;
}

/// Reads a file with tips only, a changed file, an invalid file, a missing file, and a file of
/// another kind.
void checkFiles()
{
  vtkNew<vtkTrajectoryReader> reader;
  Messages messages(reader);
  reader->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "File Name is required");
  write("# a hand\n\"time_s\",tip_x_mm,tip_y_mm,tip_z_mm\n0,1,2,3\n0.5,1,2,4\n");
  PALPATE_CHECK(vtkTrajectoryReader::CanReadFile(File) == 1);
  reader->SetFileName(File);
  reader->Update();
  PALPATE_CHECK(reader->GetOutput()->GetNumberOfPoints() == 2);
  PALPATE_CHECK(reader->GetOutput()->GetPointData()->GetNumberOfArrays() == 1);
  PALPATE_CHECK(messages.none());

  write("time_s,tip_x_mm,tip_y_mm,tip_z_mm\n0,1,2,three\n");
  reader->SetFileName("missing.csv");
  reader->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "missing.csv");
  PALPATE_CHECK(reader->GetOutput()->GetNumberOfPoints() == 0);
  reader->SetFileName(File);
  reader->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "TestTrajectoryReader.csv:2", "three");
  PALPATE_CHECK(reader->GetOutput()->GetNumberOfPoints() == 0);

  PALPATE_CHECK(vtkTrajectoryReader::CanReadFile("missing.csv") == 0);
  PALPATE_CHECK(vtkTrajectoryReader::CanReadFile(nullptr) == 0);
  write("site,x_mm,y_mm,z_mm,deflection_mm,force_N\n");
  PALPATE_CHECK(vtkTrajectoryReader::CanReadFile(File) == 0);
  std::remove(File);
}
} // namespace

int TestTrajectoryReader(int, char*[])
{
  checkRecording();
  checkFiles();
  return result();
}

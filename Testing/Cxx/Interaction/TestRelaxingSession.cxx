// SPDX-License-Identifier: BSD-3-Clause
// A press on liver in a session: its force loop in the recording, the file and the history, a
// replay with the same bits, and the text of the caption.
#include "LiverSlab.h"
#include "SceneParts.h"

#include "Haptics/Devices/TrajectoryFile.h"
#include "Haptics/Servo/ServoStep.h"
#include "Interaction/Display/MemoryText.h"
#include "vtkContactHistory.h"
#include "vtkContactScene.h"
#include "vtkTrajectoryReader.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

namespace
{
using namespace palpate::testing;

constexpr const char* File = "TestRelaxingSession.csv";

/// Rows of two columns during contact.
std::vector<Row> columnsOf(vtkTable* table, const char* force)
{
  std::vector<Row> rows;
  for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
  {
    const double deflection = table->GetValueByName(i, "Deflection (mm)").ToDouble();
    if (deflection > 0.0)
    {
      rows.emplace_back(deflection, table->GetValueByName(i, force).ToDouble());
    }
  }
  return rows;
}

void checkSame(vtkPolyData* one, vtkPolyData* other, const char* name)
{
  vtkDataArray* left = one->GetPointData()->GetArray(name);
  vtkDataArray* right = other->GetPointData()->GetArray(name);
  PALPATE_CHECK(left && right && left->GetNumberOfTuples() == right->GetNumberOfTuples());
  for (vtkIdType i = 0; left && right && i < left->GetNumberOfTuples(); ++i)
  {
    PALPATE_CHECK(left->GetTuple1(i) == right->GetTuple1(i));
  }
}

void checkPress(double radius, double peak, double loss)
{
  const Body slab = liverSlab(radius);
  const auto session = slabSession(slab);
  PALPATE_CHECK(session->Start());
  session->Step(SlabDuration);
  vtkNew<vtkPolyData> recording;
  session->GetRecorder()->GetRecording(recording);
  vtkNew<vtkTable> statistics;
  session->GetRecorder()->GetStatistics(statistics);
  const auto peakOf = [&](const char* name)
  { return statistics->GetValueByName(0, name).ToDouble(); };
  PALPATE_CHECK_NEAR(peakOf("MemoryAtPeak (N)") / peakOf("PeakForce (N)"), 1.0 - 1.0 / peak, 0.005);

  PALPATE_CHECK(palpate::writeTrajectory(File, session->GetRecorder()->GetTicks()).empty());
  vtkNew<vtkTrajectoryReader> reader;
  reader->SetFileName(File);
  reader->WholePathOn();
  reader->Update();
  checkSame(reader->GetOutput(), recording, "MemoryForce");
  const Body again = probed(slab, reader->GetOutput()); // with the times of the file
  checkSame(again, recording, "NormalForce");
  checkSame(again, recording, "MemoryForce");

  vtkNew<vtkContactHistory> history;
  history->SetInputData(again);
  history->Update();
  vtkTable* table = history->GetOutput();
  checkLoop(Loop(columnsOf(table, "Normal Force (N)")), Loop(columnsOf(table, "Slow Force (N)")),
    peak, loss);
}

void checkWords()
{
  using palpate::memoryInWords;
  PALPATE_CHECK(memoryInWords(3.2, 0.9) == "of 3.20 N 0.900 N are memory (28 %)");
  PALPATE_CHECK(memoryInWords(2.3, -0.9) == "of 3.20 N memory takes 0.900 N (28 %)");
  PALPATE_CHECK(memoryInWords(3.2, 0.0).empty() && memoryInWords(0.0, 0.0).empty());

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(600, 400);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  vtkNew<vtkContactScene> scene;
  scene->SetRenderer(renderer);
  for (const bool relaxes : { true, false })
  {
    const Body slab = liverSlab(6.35, relaxes);
    const auto session = slabSession(slab);
    PALPATE_CHECK(session->Start());
    session->Step(SlabPress + SlabAbove);
    scene->SetBody(slab);
    scene->SetTool(makeTool("paraboloid:6.35"));
    scene->ShowSession(session);
    window->Render();
    // 1.21 N by Hertz with E* = 13.3 kPa, multiplied by 2.42 for the layer (liver_slab_h10.csv) and
    // by 1.514 for the memory.
    const std::string words = caption(renderer);
    PALPATE_CHECK((words.find("are memory (34 %)") != std::string::npos) == relaxes);
    PALPATE_CHECK((words.find("\nOf 1.8") != std::string::npos) == relaxes);
  }
}
} // namespace

int TestRelaxingSession(int, char*[])
{
  checkPress(6.35, 1.5144, 0.2434);
  checkPress(1.6, 1.4978, 0.2439);
  checkWords();
  return result();
}

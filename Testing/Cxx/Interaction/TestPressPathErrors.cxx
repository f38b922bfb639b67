// SPDX-License-Identifier: BSD-3-Clause
// Impossible paths give an error that names the direction and the number, and no output.
#include "Response/FilterChecks.h"
#include "Response/TestBodies.h"

#include "vtkAppendPolyData.h"
#include "vtkPressPath.h"

#include <limits>

namespace
{
using namespace palpate::testing;

void checkRefused(vtkPressPath* press, Messages& messages, std::initializer_list<const char*> words)
{
  press->Modified();
  press->Update();
  const std::string text = messages.takeErrors();
  for (const char* word : words)
  {
    PALPATE_CHECK_TEXT(text, word);
  }
  PALPATE_CHECK(press->GetOutput()->GetNumberOfPoints() == 0);
}

void checkDirections(vtkPolyData* body)
{
  vtkNew<vtkPressPath> press;
  Messages messages(press);
  press->SetInputData(body);
  checkRefused(press, messages, { "at least one direction" });
  press->AddDirection(0.0, 0.0, 0.0);
  checkRefused(press, messages, { "Direction (0, 0, 0)", "meets no surface" });
  press->RemoveAllDirections();
  press->AddDirection(std::nan(""), 0.0, 1.0);
  checkRefused(press, messages, { "meets no surface" });
  press->RemoveAllDirections();
  press->AddDirection(0.0, 1.0, 0.0);
  press->SetCenter(0.0, 60.0, 7.0); // outside the body: there is no surface in this direction
  checkRefused(press, messages, { "Direction (0, 1, 0) from (0, 60, 7)", "meets no surface" });
  press->SetCenter(0.0, 0.0, 0.0);
  press->Update();
  PALPATE_CHECK(messages.none() && press->GetOutput()->GetNumberOfPoints() == 5);
  press->SetInputData(Body::New());
  checkRefused(press, messages, { "body with triangles" });
}

/// Beyond the edge of a plate, the path would continue far below the plate.
void checkLeap()
{
  const Body plate = planeBody(20.0, 10, 30.0);
  const Body floor = planeBody(200.0, 10, 5.0);
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(plate);
  both->AddInputData(floor);
  vtkNew<vtkPressPath> press;
  Messages messages(press);
  press->SetInputConnection(both->GetOutputPort());
  press->AddDirection(0.0, 0.0, 1.0);
  press->AddDirection(1.0, 0.0, 0.8);
  checkRefused(press, messages, { "jumps", " mm at direction (0.55", "silhouette" });
}

void checkNumbers(vtkPolyData* body)
{
  vtkNew<vtkPressPath> press;
  Messages messages(press);
  press->SetInputData(body);
  press->AddDirection(0.0, 0.0, 1.0);
  const auto refuse = [&] { checkRefused(press, messages, { "PressSpeed", "positive" }); };
  press->SetPressSpeed(0.0);
  refuse();
  press->SetPressSpeed(5.0);
  press->SetSlideSpeed(-1.0);
  refuse();
  press->SetSlideSpeed(40.0);
  press->SetSmoothingLength(-1.0);
  refuse();
  press->SetSmoothingLength(0.0);
  press->SetApproach(-0.1);
  refuse();
  press->SetApproach(0.0);
  press->SetDepth(std::numeric_limits<double>::infinity());
  refuse();
  press->SetDepth(1.0);
  press->Update();
  PALPATE_CHECK(messages.none() && press->GetOutput()->GetNumberOfPoints() == 5);
}
} // namespace

int TestPressPathErrors(int, char*[])
{
  const Body body = sphereBody(40.0, 3);
  checkDirections(body);
  checkLeap();
  checkNumbers(body);
  return palpate::testing::result();
}

// SPDX-License-Identifier: BSD-3-Clause
#include "DrawingThread.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

#include <chrono>
#include <utility>

namespace palpate::endurance
{
namespace
{
constexpr int Size = 240;                         // pixels
constexpr std::chrono::milliseconds Period{ 33 }; // 30 frames a second
} // namespace

void DrawingThread::start()
{
  this->Stopping = false;
  this->Thread = std::thread([this] { this->run(); });
}

void DrawingThread::stop()
{
  if (this->Thread.joinable())
  {
    this->Stopping = true;
    this->Thread.join();
  }
}

void DrawingThread::show(vtkPolyData* body)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(body);
  const std::lock_guard<std::mutex> hold(this->Lock);
  this->Body = copy;
}

vtkSmartPointer<vtkPolyData> DrawingThread::takeBody()
{
  const std::lock_guard<std::mutex> hold(this->Lock);
  return std::exchange(this->Body, nullptr);
}

void DrawingThread::run()
{
  vtkNew<vtkPolyDataMapper> body;
  vtkNew<vtkActor> bodyActor;
  bodyActor->SetMapper(body);
  bodyActor->GetProperty()->SetOpacity(0.5);
  vtkNew<vtkSphereSource> tool;
  tool->SetRadius(6.0);
  vtkNew<vtkPolyDataMapper> toolMapper;
  toolMapper->SetInputConnection(tool->GetOutputPort());
  vtkNew<vtkActor> toolActor;
  toolActor->SetMapper(toolMapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(toolActor);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(Size, Size);
  window->AddRenderer(renderer);
  auto due = std::chrono::steady_clock::now();
  while (!this->Stopping)
  {
    if (const auto fresh = this->takeBody())
    {
      body->SetInputData(fresh);
      if (!renderer->HasViewProp(bodyActor))
      {
        renderer->AddActor(bodyActor);
        renderer->ResetCamera();
      }
    }
    toolActor->SetPosition(Vector3(this->Tip.read()).data());
    renderer->GetActiveCamera()->Azimuth(1.0);
    renderer->ResetCameraClippingRange();
    window->Render();
    window->WaitForCompletion();
    ++this->Frames;
    due += Period;
    const auto now = std::chrono::steady_clock::now();
    due = now > due ? now : due; // the time lost by a late frame is not made up
    std::this_thread::sleep_until(due);
  }
}
} // namespace palpate::endurance

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFrameClock.h"

#include "vtkObjectFactory.h"
#include "vtkRenderWindowInteractor.h"

namespace
{
constexpr unsigned long TimerPeriod = 33; // ms
} // namespace

vtkStandardNewMacro(vtkFrameClock);

vtkFrameClock::vtkFrameClock() = default;

vtkFrameClock::~vtkFrameClock()
{
  this->Stop();
}

void vtkFrameClock::SetInteractor(vtkRenderWindowInteractor* interactor)
{
  this->Stop();
  this->Interactor = interactor;
  this->Modified();
}

vtkRenderWindowInteractor* vtkFrameClock::GetInteractor()
{
  return this->Interactor;
}

void vtkFrameClock::Start()
{
  if (this->Interactor && this->Timer == 0)
  {
    this->Observer =
      this->Interactor->AddObserver(vtkCommand::TimerEvent, this, &vtkFrameClock::Tick);
    this->Timer = this->Interactor->CreateRepeatingTimer(TimerPeriod);
    this->Interactor->EnableRenderOff(); // only the timer draws frames
  }
}

void vtkFrameClock::Stop()
{
  if (this->Interactor && this->Timer != 0)
  {
    this->Interactor->RemoveObserver(this->Observer);
    this->Interactor->DestroyTimer(this->Timer);
    this->Interactor->EnableRenderOn();
  }
  this->Timer = 0;
}

void vtkFrameClock::Tick()
{
  const auto begin = std::chrono::steady_clock::now();
  if (begin < this->NextFrame)
  {
    return;
  }
  this->ShowFrame();
  const auto end = std::chrono::steady_clock::now();
  this->NextFrame = end + (end - begin);
}

void vtkFrameClock::ShowFrame()
{
  this->InvokeEvent(FrameEvent);
  if (!this->Interactor)
  {
    return;
  }
  this->Interactor->EnableRenderOn();
  this->Interactor->Render();
  if (this->Timer != 0)
  {
    this->Interactor->EnableRenderOff();
  }
}

void vtkFrameClock::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Interactor: " << this->Interactor.GetPointer() << "\n";
  os << indent << "Runs: " << (this->Timer != 0) << "\n";
}

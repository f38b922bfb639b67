// SPDX-License-Identifier: BSD-3-Clause
#include "BackgroundLoad.h"
#include "DrawnBody.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <csignal>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

namespace palpate::benchmarks
{
namespace
{
constexpr double Triangles = 200e3;

class Drawing
{
public:
  Drawing()
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(drawnBody(Triangles));
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
    this->Window->SetOffScreenRendering(1);
    this->Window->SetSize(1280, 1024);
    this->Window->AddRenderer(this->Renderer);
    this->draw(); // creates the window, compiles the shaders
  }
  void draw()
  {
    this->Renderer->GetActiveCamera()->Azimuth(3.0);
    this->Window->Render();
    this->Window->WaitForCompletion();
  }

private:
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

/// A second process of this program that draws.
class DrawingProcess
{
public:
  DrawingProcess()
  {
    std::string program = "/proc/self/exe";
    std::string option = DrawOption;
    const std::array<char*, 3> arguments{ program.data(), option.data(), nullptr };
    if (posix_spawn(&this->Id, program.c_str(), nullptr, nullptr, arguments.data(), environ) != 0)
    {
      this->Id = -1;
    }
  }
  ~DrawingProcess()
  {
    if (this->Id > 0)
    {
      kill(this->Id, SIGKILL);
      waitpid(this->Id, nullptr, 0);
    }
  }
  DrawingProcess(const DrawingProcess&) = delete;
  DrawingProcess& operator=(const DrawingProcess&) = delete;

private:
  pid_t Id = -1;
};

class RenderLoad final : public BackgroundLoad
{
public:
  void runFor(double seconds) override
  {
    while (this->Others.size() + 1 < std::thread::hardware_concurrency())
    {
      this->Others.push_back(std::make_unique<DrawingProcess>());
    }
    const auto begin = std::chrono::steady_clock::now();
    std::chrono::duration<double> passed{};
    while (passed.count() < seconds)
    {
      this->Own.draw();
      passed = std::chrono::steady_clock::now() - begin;
    }
  }
  std::string name() const override { return "rendering"; }
  std::string describe() const override
  {
    return "VTK draws 200 thousand triangles off screen, 1280 x 1024, frame after frame, once per "
           "processor";
  }

private:
  Drawing Own;
  std::vector<std::unique_ptr<DrawingProcess>> Others;
};
} // namespace

const char* const DrawOption = "--draw";

void drawForEver()
{
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  Drawing drawing;
  while (getppid() != 1) // the parent may have ended before the call of prctl
  {
    drawing.draw();
  }
  std::exit(0);
}

std::unique_ptr<BackgroundLoad> makeRenderLoad()
{
  const char* const display = std::getenv("DISPLAY");
  return display != nullptr && *display != '\0' ? std::make_unique<RenderLoad>() : nullptr;
}
} // namespace palpate::benchmarks

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSessionFiles.h"

#include "Haptics/Devices/TrajectoryFile.h"
#include "Interaction/Display/WindowPicture.h"
#include "Interaction/Session/TicksKept.h"
#include "vtkHapticSession.h"

#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"

#include <filesystem>

vtkStandardNewMacro(vtkSessionFiles);

vtkSessionFiles::vtkSessionFiles() = default;
vtkSessionFiles::~vtkSessionFiles() = default;

void vtkSessionFiles::SetSession(vtkHapticSession* session)
{
  this->Session = session;
  this->Modified();
}

void vtkSessionFiles::SetWindow(vtkRenderWindow* window)
{
  this->Window = window;
  this->Modified();
}

std::string vtkSessionFiles::FreeName(const char* ending)
{
  const std::filesystem::path folder(this->OutputFolder);
  std::error_code ignored; // the error code is not used, because writing the file reports the error
  std::filesystem::create_directories(folder, ignored);
  std::filesystem::path name;
  const auto isTaken = [&ignored](const std::filesystem::path& path)
  {
    return std::filesystem::exists(path, ignored) ||
      // A file with this name remains after a write to a full disk.
      std::filesystem::exists(path.string() + ".part", ignored);
  };
  for (int number = 1; name.empty() || isTaken(name); ++number)
  {
    name = folder / ("palpate-" + std::to_string(number) + ending);
  }
  return name.string();
}

std::string vtkSessionFiles::Finish(
  const std::string& what, const std::string& name, const std::string& error)
{
  this->Notice = error.empty() ? what + " " + name : error;
  return error.empty() ? name : std::string();
}

std::string vtkSessionFiles::WritePicture(const std::string& fileName)
{
  if (!this->Window)
  {
    vtkErrorMacro(<< "There is no window to write a picture of.");
    return {};
  }
  const std::string name = fileName.empty() ? this->FreeName(".png") : fileName;
  return this->Finish("picture", name, palpate::writeWindowPicture(this->Window, name));
}

bool vtkSessionFiles::StartRecording()
{
  vtkHapticRecorder* recorder = this->Session ? this->Session->GetRecorder() : nullptr;
  if (!recorder || !(recorder->GetHistorySeconds() > 0.0))
  {
    vtkErrorMacro(<< "A record is taken from the history of a session: set its HistorySeconds.");
    return false;
  }
  this->Tape = recorder->GetTape();
  const auto& setups = recorder->GetSetups().all();
  this->Tape->start(setups.empty() ? nullptr : &setups.back().setup);
  this->Notice = "recording";
  return true;
}

std::string vtkSessionFiles::WriteRecording(const std::string& fileName)
{
  if (!this->IsRecording())
  {
    vtkErrorMacro(<< "There is no record to write: call StartRecording.");
    return {};
  }
  // This collects the newly recorded ticks before the tape stops.
  this->Session->GetRecorder()->GetTape();
  this->Tape->stop();
  const std::string name = fileName.empty() ? this->FreeName(".csv") : fileName;
  const std::string error =
    palpate::writeTrajectory(name, this->Tape->ticks(), this->Tape->setups());
  if (!error.empty())
  {
    vtkErrorMacro(<< error << ".");
  }
  return this->Finish("record", name, error);
}

bool vtkSessionFiles::IsRecording() const
{
  return this->Tape && this->Tape->isRunning();
}

vtkIdType vtkSessionFiles::GetNumberOfRecordedTicks() const
{
  return this->Tape ? static_cast<vtkIdType>(this->Tape->ticks().size()) : 0;
}

void vtkSessionFiles::ToggleRecording()
{
  if (this->IsRecording())
  {
    this->WriteRecording();
  }
  else
  {
    this->StartRecording();
  }
}

void vtkSessionFiles::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OutputFolder: " << this->OutputFolder << "\n";
  os << indent << "Notice: " << this->Notice << "\n";
  os << indent << "Recording: " << this->IsRecording() << "\n";
}

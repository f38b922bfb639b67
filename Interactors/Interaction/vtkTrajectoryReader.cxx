// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTrajectoryReader.h"

#include "Haptics/Devices/TrajectoryFile.h"
#include "Mechanics/Files/CsvReader.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>

namespace
{
// Largest number of announced time steps. For a longer recording the time steps are larger.
constexpr double MostSteps = 1e6;

/// Adds a point array of `count` tuples with the value that `get` returns for each row.
template <typename Get>
void attach(vtkPolyData* output, const std::vector<palpate::TrajectoryRow>& rows, vtkIdType count,
  const char* name, int components, Get get)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    array->SetTypedTuple(i, get(rows[static_cast<std::size_t>(i)]));
  }
  output->GetPointData()->AddArray(array);
}
} // namespace

vtkStandardNewMacro(vtkTrajectoryReader);

vtkTrajectoryReader::vtkTrajectoryReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkTrajectoryReader::~vtkTrajectoryReader()
{
  delete[] this->FileName;
}

int vtkTrajectoryReader::CanReadFile(const char* fileName)
{
  palpate::CsvReader csv(fileName ? fileName : "");
  return csv.header({ "time_s", "tip_x_mm" }, 2) ? 1 : 0;
}

std::string vtkTrajectoryReader::Read()
{
  if (!this->FileName || !*this->FileName)
  {
    return "A File Name is required";
  }
  std::error_code missing; // the error is ignored here, because reading the file reports it
  const auto changed = std::filesystem::last_write_time(this->FileName, missing);
  if (this->Known && this->KnownFile == this->FileName && this->KnownTime == changed)
  {
    return {};
  }
  this->Known.reset();
  auto trajectory = std::make_unique<palpate::Trajectory>();
  std::string error = palpate::readTrajectory(this->FileName, *trajectory);
  if (!error.empty())
  {
    return error;
  }
  auto& rows = trajectory->rows;
  rows.erase(
    std::remove_if(rows.begin(), rows.end(), [](const auto& row) { return !row.hasTip(); }),
    rows.end());
  this->Known = std::move(trajectory);
  this->KnownFile = this->FileName;
  this->KnownTime = changed;
  return {};
}

int vtkTrajectoryReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  info->Remove(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  info->Remove(vtkStreamingDemandDrivenPipeline::TIME_RANGE());
  // A file that cannot be read has no time steps. RequestData reports the error and clears the
  // output.
  if (this->WholePath || !this->Read().empty() || this->Known->rows.empty())
  {
    return 1;
  }
  const auto& rows = this->Known->rows;
  const double range[2] = { rows.front().time, rows.back().time };
  const double frames =
    std::min(std::floor((range[1] - range[0]) * this->FrameRate * (1.0 + 1e-12)), MostSteps);
  const double period = frames < MostSteps ? 1.0 / this->FrameRate : (range[1] - range[0]) / frames;
  std::vector<double> steps;
  for (double frame = 0.0; frame <= frames; frame += 1.0)
  {
    steps.push_back(range[0] + frame * period);
  }
  if (steps.back() < range[1])
  {
    steps.push_back(range[1]);
  }
  info->Set(
    vtkStreamingDemandDrivenPipeline::TIME_STEPS(), steps.data(), static_cast<int>(steps.size()));
  info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
  return 1;
}

int vtkTrajectoryReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const std::string error = this->Read();
  if (!error.empty())
  {
    vtkErrorMacro(<< error << ".");
    return 0;
  }
  using Row = palpate::TrajectoryRow;
  const std::vector<Row>& rows = this->Known->rows;
  auto end = rows.end();
  vtkInformation* info = outputVector->GetInformationObject(0);
  if (!this->WholePath && info->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()))
  {
    const double time = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
    // The requested time is a sum of periods. Because of rounding, this sum may be smaller than the
    // time of the tick.
    const double last = time + 1e-9 * std::max(1.0, std::abs(time));
    end = std::upper_bound(
      rows.begin(), rows.end(), last, [](double t, const Row& row) { return t < row.time; });
  }
  const auto count = static_cast<vtkIdType>(end - rows.begin());
  vtkPolyData* output = vtkPolyData::GetData(info);
  if (info->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()))
  {
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(),
      info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()));
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(static_cast<int>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->SetPoint(i, rows[static_cast<std::size_t>(i)].tip.data());
    line->InsertCellPoint(i);
  }
  output->SetPoints(points);
  if (count > 0)
  {
    output->SetLines(line);
  }
  if (!this->Known->setups.isEmpty())
  {
    vtkNew<vtkStringArray> setups;
    setups->SetName("RecordedSetup");
    for (const std::string& text : this->Known->setups.lines())
    {
      setups->InsertNextValue(text);
    }
    output->GetFieldData()->AddArray(setups);
  }
  const auto give = [&](const char* name, int components, auto get)
  { attach(output, rows, count, name, components, get); };
  give("Time", 1, [](const Row& row) { return &row.time; });
  if (this->Known->hasAxis)
  {
    give("ToolAxis", 3, [](const Row& row) { return row.axis.data(); });
  }
  if (this->Known->hasTorque)
  {
    give("Torque", 3, [](const Row& row) { return row.contact.torque.data(); });
  }
  if (this->Known->hasContact)
  {
    give("ContactPoint", 3, [](const Row& row) { return row.contact.contactPoint.data(); });
    give("Deflection", 1, [](const Row& row) { return &row.contact.deflection; });
    give("NormalForce", 1, [](const Row& row) { return &row.contact.normalForce; });
    if (this->Known->hasMemory)
    {
      give("MemoryForce", 1, [](const Row& row) { return &row.contact.memory; });
    }
    give("FrictionForce", 3, [](const Row& row) { return row.contact.friction.data(); });
    give("IdealForce", 1, [](const Row& row) { return &row.idealForce; });
    vtkNew<vtkUnsignedCharArray> states;
    states->SetName("ContactState");
    states->SetNumberOfTuples(count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      states->SetValue(
        i, static_cast<unsigned char>(rows[static_cast<std::size_t>(i)].contact.state));
    }
    output->GetPointData()->AddArray(states);
  }
  if (this->Known->hasDevice)
  {
    give("DevicePosition", 3, [](const Row& row) { return row.sample.position.data(); });
    give("SentForce", 3, [](const Row& row) { return row.sentForce.data(); });
  }
  return 1;
}

void vtkTrajectoryReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "FrameRate: " << this->FrameRate << " /s\n";
  os << indent << "WholePath: " << this->WholePath << "\n";
}

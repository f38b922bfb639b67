// SPDX-License-Identifier: BSD-3-Clause
// Probe and deflection filter pass on the time steps of body and tips, and use the tips at the
// requested time.
#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkContactDeflection.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkToolContactProbe.h"

#include <vector>

namespace
{
using namespace palpate::testing;
using Pipeline = vtkStreamingDemandDrivenPipeline;

/// A source with the given data and times. If `Sinks`, the data move down by the time.
class TimedSource : public vtkPolyDataAlgorithm
{
public:
  static TimedSource* New();
  vtkTypeMacro(TimedSource, vtkPolyDataAlgorithm);

  Body Data;
  std::vector<double> Steps;
  bool Sinks = false;

protected:
  TimedSource() { this->SetNumberOfInputPorts(0); }
  ~TimedSource() override = default;
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    vtkInformation* info = outputVector->GetInformationObject(0);
    if (!this->Steps.empty())
    {
      const double range[2] = { this->Steps.front(), this->Steps.back() };
      info->Set(Pipeline::TIME_STEPS(), this->Steps.data(), static_cast<int>(this->Steps.size()));
      info->Set(Pipeline::TIME_RANGE(), range, 2);
    }
    return 1;
  }
  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    vtkInformation* info = outputVector->GetInformationObject(0);
    vtkPolyData* output = vtkPolyData::GetData(info);
    output->DeepCopy(this->Data);
    if (info->Has(Pipeline::UPDATE_TIME_STEP()) && !this->Steps.empty())
    {
      const double time = info->Get(Pipeline::UPDATE_TIME_STEP());
      output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
      for (vtkIdType i = 0; this->Sinks && i < output->GetNumberOfPoints(); ++i)
      {
        double x[3];
        output->GetPoint(i, x);
        output->GetPoints()->SetPoint(i, x[0], x[1], x[2] - time);
      }
    }
    return 1;
  }
};
vtkStandardNewMacro(TimedSource);

vtkSmartPointer<TimedSource> timed(vtkPolyData* data, const std::vector<double>& steps)
{
  auto source = vtkSmartPointer<TimedSource>::New();
  source->Data = data;
  source->Steps = steps;
  return source;
}

Body oneTip()
{
  auto tips = Body::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0.1, 0.2, 0.0);
  tips->SetPoints(points);
  return tips;
}

void checkSteps(vtkAlgorithm* filter, const std::vector<double>& expected)
{
  filter->UpdateInformation();
  vtkInformation* info = filter->GetOutputInformation(0);
  const int count = info->Has(Pipeline::TIME_STEPS()) ? info->Length(Pipeline::TIME_STEPS()) : 0;
  PALPATE_CHECK(count == static_cast<int>(expected.size()));
  for (std::size_t i = 0; i < expected.size() && count > static_cast<int>(i); ++i)
  {
    PALPATE_CHECK(info->Get(Pipeline::TIME_STEPS(), static_cast<int>(i)) == expected[i]);
  }
  PALPATE_CHECK((info->Has(Pipeline::TIME_RANGE()) != 0) == !expected.empty());
  if (info->Has(Pipeline::TIME_RANGE()) && !expected.empty())
  {
    PALPATE_CHECK(info->Get(Pipeline::TIME_RANGE(), 0) == expected.front());
    PALPATE_CHECK(info->Get(Pipeline::TIME_RANGE(), 1) == expected.back());
  }
}
} // namespace

int TestProbeTimes(int, char*[])
{
  const Body block = withResponse(planeBody(20.0, 20), "sphere:5");
  const auto body = timed(block, {});
  const auto tips = timed(oneTip(), { 0.0, 0.5, 1.0 });
  tips->Sinks = true;

  vtkNew<vtkToolContactProbe> probe;
  probe->SetInputConnection(0, body->GetOutputPort());
  probe->SetTipConnection(tips->GetOutputPort());
  vtkNew<vtkContactDeflection> dent;
  dent->SetInputConnection(0, body->GetOutputPort());
  dent->SetTipConnection(probe->GetOutputPort());
  for (vtkAlgorithm* filter :
    { static_cast<vtkAlgorithm*>(probe), static_cast<vtkAlgorithm*>(dent) })
  {
    checkSteps(filter, { 0.0, 0.5, 1.0 });
  }

  // The depth of the tip equals the time.
  for (const double time : { 0.5, 1.0, 0.5 })
  {
    dent->UpdateTimeStep(time);
    PALPATE_CHECK(
      probe->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()) == time);
    PALPATE_CHECK(
      dent->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()) == time);
    PALPATE_CHECK_NEAR(
      probe->GetOutput()->GetPointData()->GetArray("Deflection")->GetTuple1(0), time, 1e-6);
  }

  body->Steps = { 0.25, 0.5, 2.0 };
  body->Modified();
  for (vtkAlgorithm* filter :
    { static_cast<vtkAlgorithm*>(probe), static_cast<vtkAlgorithm*>(dent) })
  {
    checkSteps(filter, { 0.0, 0.25, 0.5, 1.0, 2.0 });
  }

  vtkNew<vtkToolContactProbe> timeless;
  timeless->SetInputData(0, block);
  timeless->SetTipData(oneTip());
  checkSteps(timeless, {});
  timeless->Update();
  PALPATE_CHECK(!timeless->GetOutput()->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()));
  return result();
}

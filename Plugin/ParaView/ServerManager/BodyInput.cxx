// SPDX-License-Identifier: BSD-3-Clause
#include "BodyInput.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

namespace palpate
{
void BodyInput::admit(vtkInformation* port)
{
  // The order of the types matters, because a composite must be passed as a whole. Data of other
  // types are passed to vtkBodySurface, which reports an error.
  port->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
}

void BodyInput::askForGhosts(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* input = inputs[0]->GetInformationObject(0);
  vtkInformation* output = outputs->GetInformationObject(0);
  if (input && output && output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1 &&
    !vtkPolyData::SafeDownCast(input->Get(vtkDataObject::DATA_OBJECT())))
  {
    input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(),
      std::max(1, input->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS())));
  }
}

bool BodyInput::isKept(vtkDataObject* data) const
{
  // The ranks must agree on whether vtkBodySurface runs. With several ranks it always runs.
  auto* ranks = vtkMultiProcessController::GetGlobalController();
  return this->Kept && data && data->GetMTime() == this->KeptFrom &&
    this->Surface->GetMTime() == this->KeptBy && (!ranks || ranks->GetNumberOfProcesses() == 1);
}

vtkInformationVector** BodyInput::replace(vtkInformationVector** inputs, int ports)
{
  vtkInformation* given = inputs[0]->GetInformationObject(0);
  vtkDataObject* data = given ? given->Get(vtkDataObject::DATA_OBJECT()) : nullptr;
  if (!this->isKept(data))
  {
    vtkNew<vtkInformation> request;
    request->Set(vtkDemandDrivenPipeline::REQUEST_DATA());
    vtkNew<vtkPolyData> made;
    vtkNew<vtkInformation> output;
    output->Set(vtkDataObject::DATA_OBJECT(), made);
    vtkNew<vtkInformationVector> outputs;
    outputs->Append(output);
    this->Kept = nullptr;
    if (!this->Surface->ProcessRequest(request, inputs, outputs))
    {
      return nullptr;
    }
    if (data && data->GetFieldData())
    {
      made->GetFieldData()->PassData(data->GetFieldData());
    }
    this->Kept = made;
    this->KeptFrom = data ? data->GetMTime() : 0;
    this->KeptBy = this->Surface->GetMTime();
  }

  vtkNew<vtkInformation> input;
  input->Copy(given);
  input->Set(vtkDataObject::DATA_OBJECT(), this->Kept);
  this->First = vtkSmartPointer<vtkInformationVector>::New();
  this->First->Append(input);
  this->Inputs.assign(inputs, inputs + ports);
  this->Inputs[0] = this->First;
  return this->Inputs.data();
}
} // namespace palpate

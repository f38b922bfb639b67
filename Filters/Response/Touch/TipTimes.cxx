// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Touch/TipTimes.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <vector>

namespace palpate
{
void passTimes(vtkInformationVector** inputs, vtkInformation* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  std::vector<double> steps;
  double range[2] = { std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() };
  for (int port = 0; port < 2; ++port)
  {
    vtkInformation* input = inputs[port]->GetInformationObject(0);
    if (!input)
    {
      continue;
    }
    if (input->Has(Pipeline::TIME_STEPS()))
    {
      const double* first = input->Get(Pipeline::TIME_STEPS());
      steps.insert(steps.end(), first, first + input->Length(Pipeline::TIME_STEPS()));
    }
    if (input->Has(Pipeline::TIME_RANGE()))
    {
      const double* of = input->Get(Pipeline::TIME_RANGE());
      range[0] = std::min(range[0], of[0]);
      range[1] = std::max(range[1], of[1]);
    }
  }
  std::sort(steps.begin(), steps.end());
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
  output->Remove(Pipeline::TIME_STEPS());
  output->Remove(Pipeline::TIME_RANGE());
  if (!steps.empty())
  {
    output->Set(Pipeline::TIME_STEPS(), steps.data(), static_cast<int>(steps.size()));
    range[0] = std::min(range[0], steps.front());
    range[1] = std::max(range[1], steps.back());
  }
  if (range[0] <= range[1])
  {
    output->Set(Pipeline::TIME_RANGE(), range, 2);
  }
}

void passDataTime(vtkDataObject* body, vtkDataObject* tips, vtkDataObject* output)
{
  output->GetInformation()->Remove(vtkDataObject::DATA_TIME_STEP());
  for (vtkDataObject* from : { tips, body })
  {
    if (from && from->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()))
    {
      output->GetInformation()->CopyEntry(from->GetInformation(), vtkDataObject::DATA_TIME_STEP());
      return;
    }
  }
}
} // namespace palpate

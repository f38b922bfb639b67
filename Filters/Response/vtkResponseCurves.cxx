// SPDX-License-Identifier: BSD-3-Clause
#include "vtkResponseCurves.h"

#include "BodyConversion.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <limits>

vtkStandardNewMacro(vtkResponseCurves);

void vtkResponseCurves::AddPointId(vtkIdType id)
{
  this->PointIds.push_back(id);
  this->Modified();
}

void vtkResponseCurves::RemoveAllPointIds()
{
  if (!this->PointIds.empty())
  {
    this->PointIds.clear();
    this->Modified();
  }
}

int vtkResponseCurves::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkResponseCurves::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* body = vtkPolyData::GetData(inputVector[0]);
  vtkTable* output = vtkTable::GetData(outputVector);
  if (!body || body->GetNumberOfPoints() == 0 || this->PointIds.empty())
  {
    return 1;
  }
  std::string error;
  const auto response = palpate::makeResponseField(body, this->ResponseName, error);
  if (!response)
  {
    vtkErrorMacro(<< "Wrong body: " << error << ".");
    return 0;
  }
  vtkDataArray* ranges = body->GetPointData()->GetArray((this->ResponseName + "Range").c_str());
  double longest = 0.0;
  for (const vtkIdType id : this->PointIds)
  {
    if (id < 0 || id >= body->GetNumberOfPoints() ||
      !response->isValid(static_cast<std::int32_t>(id)))
    {
      vtkErrorMacro(<< "Point " << id << " has no response '" << this->ResponseName << "'.");
      return 0;
    }
    longest = std::max(longest, ranges->GetTuple1(id));
  }

  vtkNew<vtkDoubleArray> deflection;
  deflection->SetName("Deflection (mm)");
  for (int row = 0; row < this->NumberOfRows; ++row)
  {
    deflection->InsertNextValue(longest * row / (this->NumberOfRows - 1));
  }
  output->AddColumn(deflection);
  for (const vtkIdType id : this->PointIds)
  {
    vtkNew<vtkDoubleArray> force;
    force->SetName((this->ResponseName + " at point " + std::to_string(id) + " (N)").c_str());
    for (int row = 0; row < this->NumberOfRows; ++row)
    {
      const double depth = deflection->GetValue(row);
      force->InsertNextValue(depth > ranges->GetTuple1(id)
          ? std::numeric_limits<double>::quiet_NaN()
          : response->evaluate(static_cast<std::int32_t>(id), depth).force);
    }
    output->AddColumn(force);
  }
  return 1;
}

void vtkResponseCurves::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PointIds: " << this->PointIds.size() << "\n";
  os << indent << "NumberOfRows: " << this->NumberOfRows << "\n";
  os << indent << "ResponseName: " << this->ResponseName << "\n";
}

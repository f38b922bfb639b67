// SPDX-License-Identifier: BSD-3-Clause
#include "vtkResponseCurves.h"

#include "Response/BodyConversion.h"
#include "Contact/ResponseField.h"
#include "Response/Curves/StoredError.h"

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkExtractSelection.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace
{
/// A response of the body that can be evaluated.
struct NamedResponse
{
  std::string name;
  std::unique_ptr<palpate::ResponseField> field;
  vtkDataArray* ranges;
  palpate::StoredError errors;

  bool covers(vtkIdType id) const { return this->field->isValid(static_cast<std::int32_t>(id)); }
};

/// Returns `count` of the ids, evenly spaced, including the first and the last id.
std::vector<vtkIdType> thinOut(const std::vector<vtkIdType>& ids, std::size_t count)
{
  std::vector<vtkIdType> kept;
  for (std::size_t i = 0; i < count; ++i)
  {
    kept.push_back(ids[count == 1 ? 0 : i * (ids.size() - 1) / (count - 1)]);
  }
  return kept;
}

/// Adds two columns with the bounds of the force that follow from the error of the force. The lower
/// bound is at least 0, and the upper bound is at most twice the force.
void addBand(const NamedResponse& response, vtkIdType id, vtkDoubleArray* deflection,
  vtkDoubleArray* force, vtkTable* table)
{
  vtkNew<vtkDoubleArray> least;
  vtkNew<vtkDoubleArray> most;
  const std::string where = response.name + " at point " + std::to_string(id);
  least->SetName((where + ", least (N)").c_str());
  most->SetName((where + ", most (N)").c_str());
  for (vtkIdType row = 0; row < deflection->GetNumberOfTuples(); ++row)
  {
    const double error = std::min(response.errors.at(id, deflection->GetValue(row)), 1.0);
    const double off = error * std::abs(force->GetValue(row));
    least->InsertNextValue(force->GetValue(row) - off);
    most->InsertNextValue(force->GetValue(row) + off);
  }
  table->AddColumn(least);
  table->AddColumn(most);
}
} // namespace

vtkStandardNewMacro(vtkResponseCurves);

vtkResponseCurves::vtkResponseCurves()
{
  this->SetNumberOfInputPorts(2);
  this->SelectionExtractor = vtkSmartPointer<vtkExtractSelection>::New();
}

vtkResponseCurves::~vtkResponseCurves() = default;

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

void vtkResponseCurves::SetSelectionConnection(vtkAlgorithmOutput* selection)
{
  this->SetInputConnection(1, selection);
}

void vtkResponseCurves::SetSelectionExtractor(vtkExtractSelection* extractor)
{
  if (extractor && this->SelectionExtractor != extractor)
  {
    this->SelectionExtractor = extractor;
    this->Modified();
  }
}

void vtkResponseCurves::AddMoreResponseName(const std::string& name)
{
  this->MoreResponseNames.push_back(name);
  this->Modified();
}

void vtkResponseCurves::RemoveAllMoreResponseNames()
{
  if (!this->MoreResponseNames.empty())
  {
    this->MoreResponseNames.clear();
    this->Modified();
  }
}

int vtkResponseCurves::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkSelection");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

/// Returns the ids of the selected points, in ascending order.
std::vector<vtkIdType> vtkResponseCurves::FindSelected(vtkPolyData* body, vtkSelection* selection)
{
  if (selection->GetNumberOfNodes() == 0)
  {
    return {}; // this avoids an error of the extractor of VTK 9.1
  }
  this->SelectionExtractor->SetInputData(0, body);
  this->SelectionExtractor->SetInputData(1, selection);
  this->SelectionExtractor->SetPreserveTopology(false);
  this->SelectionExtractor->Update();
  std::vector<vtkIdType> ids;
  auto* extracted = vtkDataSet::SafeDownCast(this->SelectionExtractor->GetOutputDataObject(0));
  auto* original = extracted
    ? vtkIdTypeArray::SafeDownCast(extracted->GetPointData()->GetArray("vtkOriginalPointIds"))
    : nullptr;
  for (vtkIdType i = 0; original && i < original->GetNumberOfTuples(); ++i)
  {
    ids.push_back(original->GetValue(i));
  }
  this->SelectionExtractor->SetInputDataObject(0, nullptr);
  this->SelectionExtractor->SetInputDataObject(1, nullptr);
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

int vtkResponseCurves::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* body = vtkPolyData::GetData(inputVector[0]);
  vtkTable* output = vtkTable::GetData(outputVector);
  if (!body || body->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  vtkSelection* selection = vtkSelection::GetData(inputVector[1]);
  std::vector<vtkIdType> ids = selection ? this->FindSelected(body, selection) : this->PointIds;
  if (ids.empty())
  {
    return 1;
  }
  std::vector<std::string> names = { this->ResponseName };
  for (const std::string& name : this->MoreResponseNames)
  {
    if (std::find(names.begin(), names.end(), name) == names.end())
    {
      names.push_back(name);
    }
  }
  std::vector<NamedResponse> responses;
  for (const std::string& name : names)
  {
    std::string error;
    auto field = palpate::makeResponseField(body, name, error);
    if (!field)
    {
      vtkErrorMacro(<< "Wrong body: " << error << ".");
      return 0;
    }
    vtkDataArray* ranges = body->GetPointData()->GetArray(
      palpate::arrayName(name, palpate::ResponseArray::Range).c_str());
    responses.push_back({ name, std::move(field), ranges, palpate::StoredError(body, name) });
  }

  if (selection)
  {
    const std::size_t selected = ids.size();
    ids.erase(std::remove_if(ids.begin(), ids.end(),
                [&responses](vtkIdType id)
                {
                  return std::none_of(responses.begin(), responses.end(),
                    [id](const NamedResponse& response) { return response.covers(id); });
                }),
      ids.end());
    if (ids.empty())
    {
      vtkErrorMacro(<< "None of the " << selected << " selected points has a response '"
                    << this->ResponseName << "'.");
      return 0;
    }
    if (ids.size() < selected)
    {
      vtkWarningMacro(<< selected - ids.size() << " of " << selected
                      << " selected points have no response and are left out.");
    }
    const auto most = static_cast<std::size_t>(this->MaximumNumberOfPoints);
    if (ids.size() > most)
    {
      vtkWarningMacro(<< ids.size() << " points are selected; the curves are of " << most
                      << " of them (Maximum Number Of Points).");
      ids = thinOut(ids, most);
    }
  }
  double longest = 0.0;
  for (const NamedResponse& response : responses)
  {
    for (const vtkIdType id : ids)
    {
      if (id >= 0 && id < body->GetNumberOfPoints() && response.covers(id))
      {
        longest = std::max(longest, response.ranges->GetTuple1(id));
      }
      else if (!selection)
      {
        // A selected point without this response is kept, because another response may be valid at
        // the point.
        vtkErrorMacro(<< "Point " << id << " has no response '" << response.name << "'.");
        return 0;
      }
    }
  }

  vtkNew<vtkDoubleArray> deflection;
  deflection->SetName("Deflection (mm)");
  for (int row = 0; row < this->NumberOfRows; ++row)
  {
    deflection->InsertNextValue(longest * row / (this->NumberOfRows - 1));
  }
  output->AddColumn(deflection);
  vtkNew<vtkTable> bands;
  for (const NamedResponse& response : responses)
  {
    for (const vtkIdType id : ids)
    {
      if (!response.covers(id))
      {
        continue;
      }
      vtkNew<vtkDoubleArray> force;
      force->SetName((response.name + " at point " + std::to_string(id) + " (N)").c_str());
      for (int row = 0; row < this->NumberOfRows; ++row)
      {
        const double depth = deflection->GetValue(row);
        force->InsertNextValue(depth > response.ranges->GetTuple1(id)
            ? std::numeric_limits<double>::quiet_NaN()
            : response.field->evaluate(static_cast<std::int32_t>(id), depth).force);
      }
      output->AddColumn(force);
      if (this->ErrorBand && response.errors.isKept())
      {
        addBand(response, id, deflection, force, bands);
      }
    }
  }
  for (vtkIdType column = 0; column < bands->GetNumberOfColumns(); ++column)
  {
    output->AddColumn(bands->GetColumn(column));
  }
  return 1;
}

void vtkResponseCurves::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PointIds: " << this->PointIds.size() << "\n";
  os << indent << "SelectionExtractor: " << this->SelectionExtractor.Get() << "\n";
  os << indent << "MaximumNumberOfPoints: " << this->MaximumNumberOfPoints << "\n";
  os << indent << "ErrorBand: " << this->ErrorBand << "\n";
  os << indent << "NumberOfRows: " << this->NumberOfRows << "\n";
  os << indent << "ResponseName: " << this->ResponseName << "\n";
  os << indent << "MoreResponseNames:";
  for (const std::string& name : this->MoreResponseNames)
  {
    os << " " << name;
  }
  os << "\n";
}

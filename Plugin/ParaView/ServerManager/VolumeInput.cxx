// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeInput.h"

#include "vtkAppendFilter.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <vector>

namespace palpate
{
namespace
{
std::vector<vtkDataObject*> leavesOf(vtkDataObject* data)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    return { data };
  }
  std::vector<vtkDataObject*> leaves;
  vtkSmartPointer<vtkCompositeDataIterator> leaf;
  leaf.TakeReference(composite->NewIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    leaves.push_back(leaf->GetCurrentDataObject());
  }
  return leaves;
}

double millimetresOf(int unit)
{
  return unit == 0 ? 1.0 : unit == 1 ? 10.0 : 1000.0;
}

void scaleImage(vtkImageData* image, int unit)
{
  const double scale = millimetresOf(unit);
  double origin[3];
  double spacing[3];
  image->GetOrigin(origin);
  image->GetSpacing(spacing);
  image->SetOrigin(scale * origin[0], scale * origin[1], scale * origin[2]);
  image->SetSpacing(scale * spacing[0], scale * spacing[1], scale * spacing[2]);
}

/// Converts the points of a body to mm in place. The body must be a copy.
void scalePoints(vtkPointSet* body, int unit)
{
  const double scale = millimetresOf(unit);
  if (scale == 1.0 || body->GetNumberOfPoints() == 0)
  {
    return;
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(body->GetPoints()->GetDataType());
  points->SetNumberOfPoints(body->GetNumberOfPoints());
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    double p[3];
    body->GetPoint(i, p);
    points->SetPoint(i, scale * p[0], scale * p[1], scale * p[2]);
  }
  body->SetPoints(points);
}

vtkSmartPointer<vtkInformationVector> withData(vtkInformation* given, vtkDataObject* data)
{
  vtkNew<vtkInformation> replaced;
  replaced->Copy(given);
  replaced->Set(vtkDataObject::DATA_OBJECT(), data);
  auto inputs = vtkSmartPointer<vtkInformationVector>::New();
  inputs->Append(replaced);
  return inputs;
}
} // namespace

vtkInformationVector** VolumeInput::replace(
  vtkInformationVector** inputs, int ports, std::string& fault)
{
  vtkInformation* given = inputs[0]->GetInformationObject(0);
  vtkDataObject* data = given->Get(vtkDataObject::DATA_OBJECT());
  const bool isKept = this->Kept && this->KeptData == data && this->KeptFrom == data->GetMTime() &&
    this->KeptUnit == this->LengthUnit;
  fault = isKept ? std::string() : this->makeMesh(data);
  if (!fault.empty())
  {
    this->Kept = nullptr;
    return nullptr;
  }
  this->First = withData(given, this->Kept);
  this->Inputs[0] = this->First;
  for (int port = 1; port < ports; ++port)
  {
    this->Inputs[port] = this->scaled(inputs[port], this->Others[port - 1]);
  }
  return this->Inputs;
}

vtkInformationVector* VolumeInput::scaled(vtkInformationVector* inputs, Other& other) const
{
  vtkDataObject* data = vtkDataObject::GetData(inputs);
  if (!data)
  {
    other = {};
    return inputs;
  }
  if (other.MadeOf != data || other.MadeFrom != data->GetMTime() || other.Unit != this->LengthUnit)
  {
    other.Made = vtkSmartPointer<vtkDataObject>::Take(data->NewInstance());
    other.Made->ShallowCopy(data);
    other.MadeOf = data;
    other.MadeFrom = data->GetMTime();
    other.Unit = this->LengthUnit;
    if (auto* image = vtkImageData::SafeDownCast(other.Made))
    {
      scaleImage(image, this->LengthUnit);
    }
    else if (auto* points = vtkPointSet::SafeDownCast(other.Made))
    {
      scalePoints(points, this->LengthUnit);
    }
  }
  other.Inputs = withData(inputs->GetInformationObject(0), other.Made);
  return other.Inputs;
}

std::string VolumeInput::makeMesh(vtkDataObject* data)
{
  vtkNew<vtkAppendFilter> all;
  all->MergePointsOn();
  for (vtkDataObject* leaf : leavesOf(data))
  {
    if (!vtkDataSet::SafeDownCast(leaf) || vtkPolyData::SafeDownCast(leaf))
    {
      return std::string("Wrong input: a ") + (leaf ? leaf->GetClassName() : "missing data set") +
        " has no volume: apply Voxel Body (vtkVoxelBody) to a closed surface first";
    }
    all->AddInputData(vtkDataSet::SafeDownCast(leaf));
  }
  auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    mesh->ShallowCopy(grid);
  }
  else if (all->GetNumberOfInputConnections(0) > 0)
  {
    all->Update();
    mesh->ShallowCopy(all->GetOutput());
  }
  scalePoints(mesh, this->LengthUnit);
  this->Kept = mesh;
  this->KeptFrom = data->GetMTime();
  this->KeptUnit = this->LengthUnit;
  this->KeptData = data;
  return {};
}
} // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVElasticCompliance.h"

#include "BodyInput.h"

#include "vtkAppendFilter.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <vector>

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
} // namespace

vtkStandardNewMacro(vtkPVElasticCompliance);

//------------------------------------------------------------------------------
int vtkPVElasticCompliance::FillInputPortInformation(int, vtkInformation* info)
{
  palpate::BodyInput::admit(info);
  return 1;
}

//------------------------------------------------------------------------------
int vtkPVElasticCompliance::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkInformation* given = input[0]->GetInformationObject(0);
  const auto mesh = this->MakeMesh(given->Get(vtkDataObject::DATA_OBJECT()));
  if (!mesh)
  {
    return 0;
  }
  vtkNew<vtkInformation> replaced;
  replaced->Copy(given);
  replaced->Set(vtkDataObject::DATA_OBJECT(), mesh);
  vtkNew<vtkInformationVector> first;
  first->Append(replaced);
  vtkInformationVector* inputs[] = { first };
  return this->Superclass::RequestData(request, inputs, output);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> vtkPVElasticCompliance::MakeMesh(vtkDataObject* data)
{
  vtkNew<vtkAppendFilter> all;
  all->MergePointsOn();
  for (vtkDataObject* leaf : leavesOf(data))
  {
    if (!vtkDataSet::SafeDownCast(leaf) || vtkPolyData::SafeDownCast(leaf))
    {
      vtkErrorMacro(
        << "Wrong input: a " << (leaf ? leaf->GetClassName() : "missing data set")
        << " has no volume: apply Voxel Body (vtkVoxelBody) to a closed surface first.");
      return nullptr;
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
  const double millimetres[] = { 1.0, 10.0, 1000.0 };
  const double scale = millimetres[this->LengthUnit];
  if (scale != 1.0 && mesh->GetNumberOfPoints() > 0)
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(mesh->GetPoints()->GetDataType());
    points->SetNumberOfPoints(mesh->GetNumberOfPoints());
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      double p[3];
      mesh->GetPoint(i, p);
      points->SetPoint(i, scale * p[0], scale * p[1], scale * p[2]);
    }
    mesh->SetPoints(points);
  }
  return mesh;
}

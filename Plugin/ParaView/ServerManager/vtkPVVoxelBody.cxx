// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVVoxelBody.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkPVVoxelBody);

//------------------------------------------------------------------------------
void vtkPVVoxelBody::SetLengthUnit(int unit)
{
  this->Body.surface()->SetLengthUnit(unit);
}

//------------------------------------------------------------------------------
int vtkPVVoxelBody::GetLengthUnit()
{
  return this->Body.surface()->GetLengthUnit();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPVVoxelBody::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Body.surface()->GetMTime());
}

//------------------------------------------------------------------------------
int vtkPVVoxelBody::FillInputPortInformation(int port, vtkInformation* info)
{
  const int known = this->Superclass::FillInputPortInformation(port, info);
  if (port == 0)
  {
    palpate::BodyInput::admit(info);
  }
  return known;
}

//------------------------------------------------------------------------------
int vtkPVVoxelBody::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  const int done = this->Superclass::RequestUpdateExtent(request, input, output);
  palpate::BodyInput::askForGhosts(input, output);
  return done;
}

//------------------------------------------------------------------------------
int vtkPVVoxelBody::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkInformationVector** replaced = this->Body.replace(input, this->GetNumberOfInputPorts());
  return replaced ? this->Superclass::RequestData(request, replaced, output) : 0;
}

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVMeasuredContactResponse.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkPVMeasuredContactResponse);

//------------------------------------------------------------------------------
void vtkPVMeasuredContactResponse::SetLengthUnit(int unit)
{
  this->Body.surface()->SetLengthUnit(unit);
}

//------------------------------------------------------------------------------
int vtkPVMeasuredContactResponse::GetLengthUnit()
{
  return this->Body.surface()->GetLengthUnit();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPVMeasuredContactResponse::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Body.surface()->GetMTime());
}

//------------------------------------------------------------------------------
int vtkPVMeasuredContactResponse::FillInputPortInformation(int port, vtkInformation* info)
{
  const int known = this->Superclass::FillInputPortInformation(port, info);
  if (port == 0)
  {
    palpate::BodyInput::admit(info);
  }
  return known;
}

//------------------------------------------------------------------------------
int vtkPVMeasuredContactResponse::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  const int done = this->Superclass::RequestUpdateExtent(request, input, output);
  palpate::BodyInput::askForGhosts(input, output);
  return done;
}

//------------------------------------------------------------------------------
int vtkPVMeasuredContactResponse::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkInformationVector** replaced = this->Body.replace(input, this->GetNumberOfInputPorts());
  return replaced ? this->Superclass::RequestData(request, replaced, output) : 0;
}

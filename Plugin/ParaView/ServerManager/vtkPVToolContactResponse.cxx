// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVToolContactResponse.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkPVToolContactResponse);

//------------------------------------------------------------------------------
void vtkPVToolContactResponse::SetLengthUnit(int unit)
{
  this->Body.surface()->SetLengthUnit(unit);
}

//------------------------------------------------------------------------------
int vtkPVToolContactResponse::GetLengthUnit()
{
  return this->Body.surface()->GetLengthUnit();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPVToolContactResponse::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Body.surface()->GetMTime());
}

//------------------------------------------------------------------------------
int vtkPVToolContactResponse::FillInputPortInformation(int port, vtkInformation* info)
{
  const int known = this->Superclass::FillInputPortInformation(port, info);
  if (port == 0)
  {
    palpate::BodyInput::admit(info);
  }
  return known;
}

//------------------------------------------------------------------------------
int vtkPVToolContactResponse::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  const int done = this->Superclass::RequestUpdateExtent(request, input, output);
  palpate::BodyInput::askForGhosts(input, output);
  return done;
}

//------------------------------------------------------------------------------
int vtkPVToolContactResponse::RequestData(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkInformationVector** replaced = this->Body.replace(input, this->GetNumberOfInputPorts());
  return replaced ? this->Superclass::RequestData(request, replaced, output) : 0;
}

//------------------------------------------------------------------------------
void vtkPVToolContactResponse::SetMaterial(int material)
{
  this->Preset.choose(material);
  this->TakeMaterial();
}

//------------------------------------------------------------------------------
int vtkPVToolContactResponse::GetMaterial()
{
  return this->Preset.chosen();
}

//------------------------------------------------------------------------------
void vtkPVToolContactResponse::SetYoungsModulus(double modulus)
{
  this->Preset.youngsModulus = modulus;
  this->TakeMaterial();
}

//------------------------------------------------------------------------------
void vtkPVToolContactResponse::SetPoissonRatio(double ratio)
{
  this->Preset.poissonRatio = ratio;
  this->TakeMaterial();
}

//------------------------------------------------------------------------------
void vtkPVToolContactResponse::TakeMaterial()
{
  this->Superclass::SetYoungsModulus(this->Preset.youngsModulusInForce());
  this->Superclass::SetPoissonRatio(this->Preset.poissonRatioInForce());
}

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVContactRegime.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPVContactRegime);

//------------------------------------------------------------------------------
void vtkPVContactRegime::SetMaterial(int material)
{
  this->Preset.choose(material);
  this->TakeMaterial();
}

//------------------------------------------------------------------------------
int vtkPVContactRegime::GetMaterial()
{
  return this->Preset.chosen();
}

//------------------------------------------------------------------------------
void vtkPVContactRegime::SetYoungsModulus(double modulus)
{
  this->Preset.youngsModulus = modulus;
  this->TakeMaterial();
}

//------------------------------------------------------------------------------
void vtkPVContactRegime::SetPoissonRatio(double ratio)
{
  this->Preset.poissonRatio = ratio;
  this->TakeMaterial();
}

//------------------------------------------------------------------------------
void vtkPVContactRegime::TakeMaterial()
{
  this->Superclass::SetYoungsModulus(this->Preset.youngsModulusInForce());
  this->Superclass::SetPoissonRatio(this->Preset.poissonRatioInForce());
}

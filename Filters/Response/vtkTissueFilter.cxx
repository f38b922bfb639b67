// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTissueFilter.h"

void vtkTissueFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "YoungsModulus: " << this->YoungsModulus << " MPa\n";
  os << indent << "PoissonRatio: " << this->PoissonRatio << "\n";
  os << indent << "StrainModel: " << this->StrainModel << "\n";
  os << indent << "OgdenExponent: " << this->OgdenExponent << "\n";
  os << indent << "DemirayExponent: " << this->DemirayExponent << "\n";
  os << indent << "MaximumDeflection: " << this->MaximumDeflection << " mm\n";
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n";
}

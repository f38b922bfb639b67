// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVElasticCompliance.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPVElasticCompliance);

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVNoduleMaterial.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPVNoduleMaterial);

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVScannedMaterial.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPVScannedMaterial);

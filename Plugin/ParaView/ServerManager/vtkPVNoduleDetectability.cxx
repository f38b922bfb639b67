// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVNoduleDetectability.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPVNoduleDetectability);

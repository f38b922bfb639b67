// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVMeasuredContactResponse.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPVMeasuredContactResponse);

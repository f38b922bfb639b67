// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVToolContactResponse.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPVToolContactResponse);

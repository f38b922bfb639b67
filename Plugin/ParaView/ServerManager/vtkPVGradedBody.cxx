// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVGradedBody.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPVGradedBody);

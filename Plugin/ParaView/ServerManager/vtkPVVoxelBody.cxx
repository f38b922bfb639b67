// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVVoxelBody.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPVVoxelBody);

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVElasticContactResponse.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPVElasticContactResponse);

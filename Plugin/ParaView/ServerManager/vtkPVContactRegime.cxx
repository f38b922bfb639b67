// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVContactRegime.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPVContactRegime);

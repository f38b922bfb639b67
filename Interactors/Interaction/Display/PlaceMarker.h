// SPDX-License-Identifier: BSD-3-Clause
#ifndef PlaceMarker_h
#define PlaceMarker_h

#include "vtkActor.h"
#include "vtkSmartPointer.h"

namespace palpate
{
/// A ball, not visible yet, for the place of a contact that is shown blind.
vtkSmartPointer<vtkActor> makePlaceMarker();
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef PlaceMarker_h
#define PlaceMarker_h

#include "Interaction/Display/ShownContact.h"

#include "vtkActor.h"
#include "vtkSmartPointer.h"

namespace palpate
{
/// A ball, not visible yet, for the place of a contact that is shown blind.
vtkSmartPointer<vtkActor> makePlaceMarker();

/// On the surface: how deep the hand gets would tell how hard the body pushes back.
void placeMarker(const ShownContact& contact, vtkActor* marker);
} // namespace palpate

#endif

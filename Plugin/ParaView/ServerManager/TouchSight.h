// SPDX-License-Identifier: BSD-3-Clause
#ifndef TouchSight_h
#define TouchSight_h

#include "Response/Touch/TouchStart.h" // For palpate::Sight

#include "palpateServerManagerModule.h" // For export macro

class vtkSMProxy;

namespace palpate
{
/// Returns the present view of a body in a render view. For null or any other proxy, returns the
/// default view. Only the client can call this function.
PALPATESERVERMANAGER_EXPORT Sight sightOf(vtkSMProxy* view);
} // namespace palpate

#endif

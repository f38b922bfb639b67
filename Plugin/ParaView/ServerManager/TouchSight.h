// SPDX-License-Identifier: BSD-3-Clause
#ifndef TouchSight_h
#define TouchSight_h

#include "Response/Touch/TouchStart.h" // For palpate::Sight

#include "palpateServerManagerModule.h" // For export macro

class vtkSMProxy;

namespace palpate
{
/// The present view of a body in a render view; the default sight for any other proxy, or null. For
/// the client.
PALPATESERVERMANAGER_EXPORT Sight sightOf(vtkSMProxy* view);
} // namespace palpate

#endif

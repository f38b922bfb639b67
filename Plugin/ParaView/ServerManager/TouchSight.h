// SPDX-License-Identifier: BSD-3-Clause
#ifndef TouchSight_h
#define TouchSight_h

#include "Response/Touch/TouchStart.h" // For palpate::Sight

#include "palpateServerManagerModule.h" // For export macro

class vtkSMProxy;

namespace palpate
{
/// How a render view looks at its bodies, as the user sees it now; the default for any other proxy,
/// or none. On the client.
PALPATESERVERMANAGER_EXPORT Sight sightOf(vtkSMProxy* view);
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef BodyRegime_h
#define BodyRegime_h

#include "Response/BodyLaws.h"

namespace palpate
{
/// Attaches the regime to the body; see vtkContactRegime. If the request has no tool, the tool of
/// the response is used. Collective; `body` is the piece of this process. Returns "" or an error
/// message.
PALPATERESPONSE_EXPORT std::string attachRegime(
  const Ranks& ranks, vtkPolyData* body, const LawRequest& request, vtkPolyData* output);
} // namespace palpate

#endif

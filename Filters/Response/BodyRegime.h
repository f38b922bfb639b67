// SPDX-License-Identifier: BSD-3-Clause
#ifndef BodyRegime_h
#define BodyRegime_h

#include "Response/BodyLaws.h"

namespace palpate
{
/// Attaches the regime to the body; see vtkContactRegime. If no tool is given, uses the tool of the
/// response. Collective; `body` is the piece of this process.
PALPATERESPONSE_EXPORT std::string attachRegime(
  const Ranks& ranks, vtkPolyData* body, const LawRequest& request, vtkPolyData* output);
} // namespace palpate

#endif

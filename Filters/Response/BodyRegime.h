// SPDX-License-Identifier: BSD-3-Clause
#ifndef BodyRegime_h
#define BodyRegime_h

#include "Response/BodyLaws.h"

namespace palpate
{
/// The body with its regime, see vtkContactRegime; without a tool, for that of the response.
/// Collective; `body` is the own piece.
PALPATERESPONSE_EXPORT std::string attachRegime(
  const Ranks& ranks, vtkPolyData* body, const LawRequest& request, vtkPolyData* output);
} // namespace palpate

#endif

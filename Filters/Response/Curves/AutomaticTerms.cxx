// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Curves/AutomaticTerms.h"

#include "Mechanics/JoinedText.h"
#include "Response/BodyConversion.h"
#include "Response/Terms/LawTerm.h"
#include "vtkContactTool.h"

#include "vtkFieldData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <cstdio>
#include <utility>

namespace palpate
{
AutomaticTerms::AutomaticTerms(const Ranks& all, vtkPolyData* piece, const LawRequest& asked,
  const SurfaceShape& shape, BodyMaterial of, StrainMaker make)
  : ranks(all)
  , body(piece)
  , request(asked)
  , pressed{ *asked.tool->GetKernel(), asked.deflection,
    static_cast<std::size_t>(piece->GetNumberOfPoints()), shape }
  , makeStrain(std::move(make))
  , terms(asked.terms)
  , material(std::move(of))
  , RestOfTolerance(asked.terms.changeTolerance)
{
}

std::string AutomaticTerms::choose()
{
  for (const LawTerm* term : lawTerms())
  {
    std::string fault = term->need(*this);
    if (!fault.empty())
    {
      return fault;
    }
  }
  return {};
}

double AutomaticTerms::change(const LawModel& whole, const LawModel& less) const
{
  return this->ranks.largest(this->hasPiece() ? changeOfForce(this->pressed, whole, less) : 0.0);
}

double AutomaticTerms::bound(const LawModel& model) const
{
  return this->ranks.largest(this->hasPiece() ? boundOfStrain(this->pressed, model) : 0.0);
}

void AutomaticTerms::addReason(const std::string& words)
{
  this->Reasons += (this->Reasons.empty() ? "" : "; ") + words;
}

std::string AutomaticTerms::reason() const
{
  return this->Reasons.empty() ? this->Reasons
                               : joined(this->Reasons, " (down to ", this->pressed.range,
                                   " mm, at ", 100.0 * this->pressed.share, " % of the points)");
}

std::string percentOf(double change)
{
  if (!std::isfinite(change))
  {
    return "all of it";
  }
  char words[32];
  std::snprintf(words, sizeof words, "%.2g %%", 100.0 * change);
  return words;
}

std::string termsReason(vtkPolyData* body, const std::string& responseName)
{
  return responseText(body, responseName, ResponseArray::Terms);
}
} // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Terms/LawTerm.h"

#include "Response/BodyConversion.h"

namespace palpate
{
std::string LawTerm::check(const TermBody&, vtkPolyData*) const
{
  return {};
}

std::string LawTerm::make(const TermBody&, vtkPolyData*) const
{
  return {};
}

std::string LawTerm::limit(const TermBody&, vtkPolyData*) const
{
  return {};
}

ResponseModel LawTerm::words(const TermBody&) const
{
  return {};
}

std::string LawTerm::need(AutomaticTerms&) const
{
  return {};
}

bool LawTerm::view(vtkPolyData*, const std::string&, ResponseArrays&, std::string&) const
{
  return true;
}

void LawTerm::describe(vtkPolyData*, const std::string&, const ResponseArrays&) const {}

const std::array<const LawTerm*, 7>& lawTerms()
{
  static const std::array<const LawTerm*, 7> terms = { &layerTerm(), &curvatureTerm(), &edgeTerm(),
    &strainTerm(), &relaxationTerm(), &couplingTerm(), &tiltTerm() };
  return terms;
}

std::string checkTerms(const TermBody& response, vtkPolyData* piece)
{
  for (const LawTerm* term : lawTerms())
  {
    const std::string fault = term->check(response, piece);
    if (!fault.empty())
    {
      return fault;
    }
  }
  return {};
}

std::string makeTerms(const TermBody& response, vtkPolyData* output)
{
  for (const LawTerm* term : lawTerms())
  {
    const bool isAsked = term->isAsked(response.request);
    std::string fault = isAsked ? term->make(response, output) : std::string();
    if (isAsked && fault.empty())
    {
      fault = term->limit(response, output);
    }
    if (!fault.empty())
    {
      return fault;
    }
  }
  return {};
}

ResponseModel termsInWords(const TermBody& response)
{
  ResponseModel model;
  for (const LawTerm* term : lawTerms())
  {
    if (term->isAsked(response.request))
    {
      const ResponseModel own = term->words(response);
      model.text += own.text;
      model.parts |= own.parts;
    }
  }
  return model;
}
} // namespace palpate

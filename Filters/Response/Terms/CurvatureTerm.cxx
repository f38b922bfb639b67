// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Terms/LawTerm.h"

#include "Response/BodyConversion.h"
#include "Response/Curves/AutomaticTerms.h"

namespace palpate
{
namespace
{
/// The curvature of the body under the tool. The term changes the curves (Laws/CurvedContact.h).
class CurvatureTerm : public LawTerm
{
public:
  bool isAsked(const LawRequest& request) const override { return request.terms.curvature; }
  ResponseModel words(const TermBody&) const override;
  std::string need(AutomaticTerms& choice) const override;
};
} // namespace

ResponseModel CurvatureTerm::words(const TermBody&) const
{
  return { ", curved as the body is", CurvaturePart };
}

std::string CurvatureTerm::need(AutomaticTerms& choice) const
{
  if (!choice.terms.curvature)
  {
    return {};
  }
  const double change = choice.change({ choice.material, true }, { choice.material, false });
  choice.terms.curvature = !choice.isNegligible(change);
  if (choice.terms.curvature)
  {
    choice.addReason(
      "the body's curvature is in the law: without it the force is off by " + percentOf(change));
    return {};
  }
  choice.leaveOut(change);
  choice.addReason(
    "the body counts as flat: its curvature changes the force by " + percentOf(change));
  return {};
}

const LawTerm& curvatureTerm()
{
  static const CurvatureTerm term;
  return term;
}
} // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_ResponseModels_h
#define palpate_testing_ResponseModels_h

#include "Contact/ContactBody.h"
#include "Mechanics/IndentationLaw.h"
#include "SampleResponses.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace palpate::testing
{
/// A force-deflection law of the study. mm, N.
struct ResponseModel
{
  std::string name;
  std::function<IndentationPoint(double deflection)> law;
  double exponent = 1.0; ///< m of its stored form (ResponseSampling)
  double range = 2.0;    ///< range of its stored form, mm

  /// The depth at which the law has this force, at most the range.
  double depthOf(double force) const;
};

/// A linear spring that does not depend on a tool.
ResponseModel linearModel(const std::string& name, double stiffness, double range);
/// A tool (ToolSpecification) on a half-space of this reduced modulus (MPa). The range ends at
/// `force`.
ResponseModel toolModel(const std::string& tool, double modulus, double force);
/// All laws of the study: a point spring with the secant stiffness of the 6.35 mm sphere at 1 mm,
/// the sphere on a body with a global compliance of 1 mm/N, tools on a half-space, and the sphere
/// on a bonded layer of 10 mm (ν = 0.5). Each range ends at `force` or at 8 mm.
std::vector<ResponseModel> allModels(double modulus, double force);

/// The response in 8 samples at every point of a surface, as a filter stores it; normals along z.
ResponseStore storedAt(const Surface& surface, const ResponseModel& model);
/// The surface with these responses. `model` gives the exponent.
std::shared_ptr<const ContactBody> bodyOf(
  const Surface& surface, const ResponseStore& store, const ResponseModel& model);
/// A plate in z = 0, centred at the origin, with this response.
std::shared_ptr<const ContactBody> plateOf(const ResponseModel& model);
/// The plate of plateOf() on a half-space of this reduced modulus (MPa), which couples the tools.
std::shared_ptr<const ContactBody> coupledPlate(const ResponseModel& model, double modulus);
} // namespace palpate::testing

#endif

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
/// A force-deflection law that is pressed in the study. mm, N.
struct ResponseModel
{
  std::string name;
  std::function<IndentationPoint(double deflection)> law;
  double exponent = 1.0; ///< m of its stored form (ResponseSampling)
  double range = 2.0;    ///< of its stored form, mm

  /// The depth of a force, or the range.
  double depthOf(double force) const;
};

/// A spring without a shape.
ResponseModel linearModel(const std::string& name, double stiffness, double range);
/// A tool (ToolSpecification) on a half-space of this reduced modulus (MPa), ranging to `force`.
ResponseModel toolModel(const std::string& tool, double modulus, double force);
/// All of the study: a point spring as stiff as the 6.35 mm sphere's secant at 1 mm, the sphere on
/// a body that gives way by 1 mm/N as a whole, tools on a half-space, the sphere on a bonded layer
/// of 10 mm (ν = 0.5). Each ranges to `force`, or to 8 mm.
std::vector<ResponseModel> allModels(double modulus, double force);

/// In 8 samples at every point of a surface, as a filter stores it; normals along z.
ResponseStore storedAt(const Surface& surface, const ResponseModel& model);
/// The surface with these, of which `model` gives the exponent.
std::shared_ptr<const ContactBody> bodyOf(
  const Surface& surface, const ResponseStore& store, const ResponseModel& model);
/// A plate in z = 0, its middle in the origin, with this response.
std::shared_ptr<const ContactBody> plateOf(const ResponseModel& model);
/// The same as a half-space of this reduced modulus (MPa), through which tools feel one another.
std::shared_ptr<const ContactBody> coupledPlate(const ResponseModel& model, double modulus);
} // namespace palpate::testing

#endif

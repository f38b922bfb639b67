// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_CoupledPlate_h
#define palpate_testing_CoupledPlate_h

#include "Contact/ContactBody.h"
#include "Contact/Contact.h"
#include "SampleBodies.h"
#include "SampleResponses.h"

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace palpate::testing
{
/// A half-space as a plate at z = 0, 60 mm wide. The tool is a ball of 5 mm with F = 10 δ^1.5 (N,
/// mm), as for E* = 3.35 MPa, or a flat end of 2 mm with F = 4E* δ on 1 MPa. This object owns the
/// memory of the arrays.
struct CoupledPlate
{
  static constexpr double Radius = 5.0;
  static constexpr double Flat = 2.0;

  explicit CoupledPlate(bool isFlat = false)
    : surface(openPlate(60.0, 12))
    , store(surface.points.size())
    , isLinear(isFlat)
  {
    constexpr std::size_t samples = 8;
    for (std::size_t i = 0; isFlat && i < this->store.force.size(); ++i)
    {
      const double s = static_cast<double>(i % samples + 1) / samples;
      this->store.force[i] = static_cast<float>(2.0 * Flat * 2.0 * s * s);
      this->store.stiffness[i] = static_cast<float>(2.0 * Flat);
    }
    this->terms.modulus = isFlat ? 1.0 : 7.5 / std::sqrt(Radius);
  }

  /// The body with or without coupling.
  std::unique_ptr<ContactBody> body(bool isCoupled = true) const
  {
    ResponseArrays arrays = this->store.arrays();
    arrays.exponent = this->isLinear ? 1.0 : 1.5;
    arrays.relaxation = this->relaxation;
    if (isCoupled)
    {
      arrays.coupling = this->terms;
    }
    return contactBody(this->surface, arrays);
  }

  Surface surface;
  ResponseStore store;
  CouplingTerms terms;
  RelaxationTerms relaxation; ///< no relaxation by default
  bool isLinear;
};

/// A tip at (x, y), pressed `depth` mm into the plate.
struct PressedTip
{
  double x, y, depth;
};

inline std::vector<ToolPose> posesOf(const std::vector<PressedTip>& tips)
{
  std::vector<ToolPose> poses;
  for (const PressedTip& tip : tips)
  {
    poses.emplace_back(Vector3(tip.x, tip.y, -tip.depth));
  }
  return poses;
}
} // namespace palpate::testing

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RegimeLaw_h
#define palpate_RegimeLaw_h

#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Mechanics/ContactRegime.h"
#include "Contact/ResponseField.h"
#include "Laws/ContactSpot.h"
#include "Laws/MaterialRange.h"
#include "Mechanics/PalpateExport.h"
#include "Laws/ResponseLaw.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace palpate
{
class BodyMaterial;

/// How local a contact is, and whether the tool's shape matters (ContactRegime.h). Without a stable
/// contact the numbers are NaN and the verdict is ShapeMatters.
struct SpotRegime
{
  double index = 0.0;       ///< λ
  double sensitivity = 0.0; ///< dlnF/dln(size) at fixed deflection
  RegimeVerdict verdict = RegimeVerdict::ShapeMatters;
};

/**
 * The regime of one tool, from its own law and the laws of a slightly smaller and a slightly larger
 * tool. Safe to use from any number of threads.
 */
class PALPATE_EXPORT RegimeLaw
{
public:
  /// `tool` must outlive this. Valid for depths up to `deepest` (mm) at spots within `range`.
  RegimeLaw(const AxisymmetricTool& tool, const MaterialRange& range, double deepest);

  /// Whether the tool can be scaled. If not, the functions below must not be called.
  bool complete() const noexcept { return !this->Laws.empty(); }

  /// Force, N.
  double force(const ContactSpot& spot, double depth) const;
  /// `force` is the force at `depth`, N.
  SpotRegime regime(const ContactSpot& spot, double depth, double force) const;

private:
  double sensitivity(const ContactSpot& spot, double depth) const;

  const AxisymmetricTool& Tool;
  std::unique_ptr<AxisymmetricTool> Smaller;
  std::unique_ptr<AxisymmetricTool> Larger;
  std::vector<ResponseLaw> Laws;
};

/// The output arrays of a body's regime, one value per point.
struct RegimeSpans
{
  float* index;
  float* sensitivity;
  std::uint8_t* verdict;
};

/// A response of a body, its name, and the curvatures in its law. `curvature` is empty if the law
/// is that of a flat surface.
struct ComparedResponse
{
  ResponseArrays arrays;
  std::string name;
  std::function<SpotCurvature(std::size_t)> curvature = {};
  std::function<double(std::size_t)> error = {}; ///< stated relative error of a force at a point
};

/**
 * Computes the regime of a tool that is pressed to the depth `depths[i]` (mm, > 0) at each point i
 * of a body. `stored`, unless null, is the response of the same tool on the body. The regime must
 * belong to the same body. Therefore the force of `stored` must agree to 2 % (its storage error in
 * series) or to its stated error if that is larger. Depths below a hundredth of its range are not
 * compared. Returns "" if all is valid, else a message that names the point. The bits do not depend
 * on the number of threads.
 */
PALPATE_EXPORT std::string regime(const AxisymmetricTool& tool, const BodyMaterial& material,
  const std::vector<double>& depths, double deepest, const ComparedResponse* stored,
  const RegimeSpans& spans);
} // namespace palpate

#endif

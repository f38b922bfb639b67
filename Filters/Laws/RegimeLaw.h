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

/// How local a contact is, and whether the shape of the tool has an effect (ContactRegime.h). If
/// there is no stable contact, the numbers are NaN and the verdict is ShapeMatters.
struct SpotRegime
{
  double index = 0.0;       ///< regime index λ
  double sensitivity = 0.0; ///< dlnF/dln(size) at fixed deflection
  RegimeVerdict verdict = RegimeVerdict::ShapeMatters;
};

/**
 * Computes the regime of one tool from its own law and the laws of a slightly smaller and a
 * slightly larger tool. Can be used from any number of threads.
 */
class PALPATE_EXPORT RegimeLaw
{
public:
  /// The laws are valid for depths up to `deepest` (mm) at spots within `range`. `tool` must
  /// outlive this object.
  RegimeLaw(const AxisymmetricTool& tool, const MaterialRange& range, double deepest);

  /// Returns whether the tool can be scaled. If not, the following functions must not be called.
  bool complete() const noexcept { return !this->Laws.empty(); }

  /// Returns the force at `depth` (mm), N.
  double force(const ContactSpot& spot, double depth) const;
  /// Returns the regime at `depth` (mm). `force` is the force at this depth, N.
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

/// A response of a body with its name, and the curvatures that its law includes. `curvature` is
/// empty if the law is that of a flat surface.
struct ComparedResponse
{
  ResponseArrays arrays;
  std::string name;
  std::function<SpotCurvature(std::size_t)> curvature = {};
  /// Relative error of the force that the response states at a point.
  std::function<double(std::size_t)> error = {};
};

/**
 * Computes the regime of a tool that is pressed to the depth `depths[i]` (mm, > 0) at each point i
 * of a body. `stored`, unless null, is the response of the same tool on the body. To check that
 * both belong to the same body, the force of `stored` is compared with that of the law: it must
 * agree to 2 % (its storage error in series) or to its stated error if that is larger. Depths below
 * a hundredth of its range are not compared. Returns "" if all values are valid, else a message
 * that names the point. The result is bit for bit the same for any number of threads.
 */
PALPATE_EXPORT std::string regime(const AxisymmetricTool& tool, const BodyMaterial& material,
  const std::vector<double>& depths, double deepest, const ComparedResponse* stored,
  const RegimeSpans& spans);
} // namespace palpate

#endif

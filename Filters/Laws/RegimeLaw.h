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

/// How local a contact is, and whether the tool's shape matters (ContactRegime.h). NaN where there
/// is no stable contact; the verdict is ShapeMatters there.
struct SpotRegime
{
  double index = 0.0;       ///< λ
  double sensitivity = 0.0; ///< dlnF/dln(size) at fixed deflection
  RegimeVerdict verdict = RegimeVerdict::ShapeMatters;
};

/**
 * The laws of one tool, and of it a little smaller and larger, which tell its regime. Safe to use
 * from any number of threads.
 */
class PALPATE_EXPORT RegimeLaw
{
public:
  /// `tool` must outlive this; it is asked for depths up to `deepest` (mm) at spots within `range`.
  RegimeLaw(const AxisymmetricTool& tool, const MaterialRange& range, double deepest);

  /// Whether the tool can be made smaller and larger; if not, nothing below may be called.
  bool complete() const noexcept { return !this->Laws.empty(); }

  /// F, N.
  double force(const ContactSpot& spot, double depth) const;
  /// `force` is that at `depth`.
  SpotRegime regime(const ContactSpot& spot, double depth, double force) const;

private:
  double sensitivity(const ContactSpot& spot, double depth) const;

  const AxisymmetricTool& Tool;
  std::unique_ptr<AxisymmetricTool> Smaller;
  std::unique_ptr<AxisymmetricTool> Larger;
  std::vector<ResponseLaw> Laws;
};

/// Where the regime of a body goes, one value per point.
struct RegimeSpans
{
  float* index;
  float* sensitivity;
  std::uint8_t* verdict;
};

/// A response that a body has, and its name; the curvatures that are in its law, none if it is that
/// of a flat surface.
struct ComparedResponse
{
  ResponseArrays arrays;
  std::string name;
  std::function<SpotCurvature(std::size_t)> curvature = {};
};

/**
 * The regime of a tool pressed `depths[i]` (mm, > 0) deep at each point of a body. `stored`, unless
 * null, is the response of the same tool on it: its force there must agree to 2 % (its storage
 * error in series; depths below a hundredth of its range are not compared), since a regime of
 * another body than the one that is felt is worse than none. Returns what is wrong, naming the
 * point, or "". The same bits for any number of threads.
 */
PALPATE_EXPORT std::string regime(const AxisymmetricTool& tool, const BodyMaterial& material,
  const std::vector<double>& depths, double deepest, const ComparedResponse* stored,
  const RegimeSpans& spans);
} // namespace palpate

#endif

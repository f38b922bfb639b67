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

/// How local a contact is, and whether the tool's shape matters (ContactRegime.h). Without stable
/// contact NaN, with the verdict ShapeMatters.
struct SpotRegime
{
  double index = 0.0;       ///< λ
  double sensitivity = 0.0; ///< dlnF/dln(size) at fixed deflection
  RegimeVerdict verdict = RegimeVerdict::ShapeMatters;
};

/**
 * The regime of one tool, from its law and those of slightly smaller and larger ones. Safe to use
 * from any number of threads.
 */
class PALPATE_EXPORT RegimeLaw
{
public:
  /// `tool` must outlive this; valid for depths up to `deepest` (mm) at spots within `range`.
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

/// The output arrays of a body's regime, one value per point.
struct RegimeSpans
{
  float* index;
  float* sensitivity;
  std::uint8_t* verdict;
};

/// A body's response, and its name; the curvatures in its law, none if it is that of a flat
/// surface.
struct ComparedResponse
{
  ResponseArrays arrays;
  std::string name;
  std::function<SpotCurvature(std::size_t)> curvature = {};
};

/**
 * The regime of a tool pressed `depths[i]` (mm, > 0) deep at each point of a body. `stored`, unless
 * null, is the response of the same tool on it: its force there must agree to 2 % (its storage
 * error in series; depths below a hundredth of its range are not compared), since the regime must
 * be that of the body that is felt. Returns what is wrong, naming the point, or "". The same bits
 * for any number of threads.
 */
PALPATE_EXPORT std::string regime(const AxisymmetricTool& tool, const BodyMaterial& material,
  const std::vector<double>& depths, double deepest, const ComparedResponse* stored,
  const RegimeSpans& spans);
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LayerCurves_h
#define palpate_LayerCurves_h

#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace palpate
{
/// The parameters that differ between the points of a layered body.
struct LayerPlace
{
  double thickness = 0.0;     ///< of the layer, or the first of a stack, mm
  double second = 0.0;        ///< of the layer below it in a stack, mm
  double poissonsRatio = 0.0; ///< of a single layer
};

/// One tool at fixed depths on all layered places of a body. Safe to use from any number of
/// threads.
class PALPATE_EXPORT LayerCurves
{
public:
  virtual ~LayerCurves() = default;

  /// F/E* (mm²), (dF/dδ)/E* (mm) and contact radius (mm) at each depth, one column each; E* is that
  /// of the layer, or of the first of a stack.
  using Curve = Eigen::Matrix<double, Eigen::Dynamic, 3>;

  /// Whether a place has a curve down to the last depth: the contact radius must stay within
  /// LayerKernel::LargestRatio thicknesses.
  virtual bool answers(const LayerPlace& place) const noexcept = 0;
  /// NaN unless answers(place).
  virtual Curve sample(const LayerPlace& place) const = 0;

  const std::vector<double>& depths() const noexcept { return this->Depths; }

protected:
  explicit LayerCurves(std::vector<double> depths)
    : Depths(std::move(depths))
  {
  }

  std::vector<double> Depths; ///< mm, ascending
};
} // namespace palpate

#endif

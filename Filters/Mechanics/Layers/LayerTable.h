// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LayerTable_h
#define palpate_LayerTable_h

#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Mechanics/Numerics/ChebyshevRule.h"
#include "Mechanics/Layers/LayerKernel.h"
#include "Mechanics/Layers/StackKernels.h"
#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

#include <memory>
#include <utility>
#include <vector>

namespace palpate
{
/// The properties of a layered body that can vary from point to point.
struct LayerPlace
{
  double thickness = 0.0;    ///< thickness of the layer, or of a stack's first layer, mm
  double second = 0.0;       ///< thickness of the second layer of a stack, mm
  double poissonRatio = 0.0; ///< Poisson's ratio of a single layer; unused for a stack
};

/// Curves of one tool at fixed depths, for all layered points of a body. Can be used from any
/// number of threads.
class PALPATE_EXPORT LayerCurves
{
public:
  virtual ~LayerCurves() = default;

  /// One row per depth, with the columns F/E* (mm²), (dF/dδ)/E* (mm) and contact radius (mm). E* is
  /// that of the layer or, for a stack, of its first layer.
  using Curve = Eigen::Matrix<double, Eigen::Dynamic, 3>;

  /// Returns whether the curve of a point is valid down to the last depth. The contact radius must
  /// not exceed LayerKernel::LargestRatio thicknesses.
  virtual bool answers(const LayerPlace& place) const noexcept = 0;
  /// Returns the curve of a point; NaN if answers(place) is false.
  virtual Curve sample(const LayerPlace& place) const = 0;

  const std::vector<double>& depths() const noexcept { return this->Depths; }

protected:
  explicit LayerCurves(std::vector<double> depths)
    : Depths(std::move(depths))
  {
  }

  std::vector<double> Depths; ///< mm, ascending
};

/**
 * Curves of one tool at fixed depths on layers of many thicknesses. The exact solution is computed
 * at Chebyshev points of x = c/(c + h), where c is the contact radius at the last depth. Between
 * these points it is interpolated by polynomials. If Poisson's ratio varies continuously, it is
 * interpolated in the same way.
 *
 * The table is intended for a body with a different thickness at each point. The constructor takes
 * about 20 ms per Poisson's ratio, for any tool. The curve of a point then takes less than a
 * microsecond. F and dF/dδ agree with LayerContact to 1e-7, or to 1e-5 for a < 2h if Poisson's
 * ratio has more than DistinctRatios values. Immutable; can be used from any number of threads.
 */
class PALPATE_EXPORT LayerTable final : public LayerCurves
{
public:
  /// Largest number of values of Poisson's ratio that are tabulated separately.
  static constexpr int DistinctRatios = 32;
  /// Number of thicknesses for which the contact is solved.
  static constexpr int ThicknessPoints = 40;

  /// The layers of a body: the range of thickness (mm, 0 < thinnest <= thickest, +inf allowed), the
  /// values of Poisson's ratio that occur, ascending, and for a stack its kernels.
  struct Layers
  {
    LayerBase base = LayerBase::Bonded;
    double thinnest = 0.0;
    double thickest = 0.0;
    std::vector<double> poissonRatios;
    std::shared_ptr<const StackKernels> stack = {};
  };

  /// `depths` (mm) must be ascending.
  LayerTable(const AxisymmetricTool& tool, const Layers& layers, std::vector<double> depths);

  bool answers(const LayerPlace& place) const noexcept override
  {
    return this->answers(place.thickness);
  }
  bool answers(double thickness) const noexcept { return thickness >= this->Thinnest; }

  Curve sample(const LayerPlace& place) const override
  {
    return this->sample(place.thickness, place.poissonRatio);
  }
  Curve sample(double thickness, double poissonRatio) const;

private:
  using ThicknessRule = ChebyshevRule<ThicknessPoints>;
  using RatioRule = ChebyshevRule<DistinctRatios>;
  using Curves = Eigen::Matrix<double, Eigen::Dynamic, ThicknessPoints>;

  double thicknessAt(int point) const;
  ThicknessRule::Values thicknessFactors(double thickness) const;
  Eigen::ArrayXd ratioFactors(double poissonRatio) const;

  double Thinnest = 0.0;
  double Scale = 1.0;
  double Begin = 0.0; ///< lower end of the interval of x = c/(c + h)
  double End = 0.0;
  std::vector<double> Ratios;
  double FirstRatio;
  double LastRatio;
  bool RatiosAreChebyshev = false;
  std::vector<Curves> Tables; ///< F, dF/dδ and a for each depth; one table per Poisson's ratio
};

/// Returns the curves of the tool on given layers at given depths (mm, ascending): a LayerTable, or
/// a StackTable for a stack. The process caches the last 64 tables by their input, because a law is
/// prepared several times for one body. Thread-safe.
PALPATE_EXPORT std::shared_ptr<const LayerCurves> makeLayerCurves(const AxisymmetricTool& tool,
  const LayerTable::Layers& layers, const std::vector<double>& depths);
} // namespace palpate

#endif

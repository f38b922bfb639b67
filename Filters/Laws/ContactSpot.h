// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactSpot_h
#define palpate_ContactSpot_h

#include "Mechanics/Layers/LayerTable.h"

#include <algorithm>
#include <cstddef>

namespace palpate
{
/// Curvature of the body's surface at a point, 1/mm: the two principal curvatures, positive if the
/// surface is convex, and their error.
struct SpotCurvature
{
  double first = 0.0;
  double second = 0.0;
  double error = 0.0;

  double mean() const noexcept { return 0.5 * (this->first + this->second); }
  bool isFlat() const noexcept { return this->first == 0.0 && this->second == 0.0; }
};

/// The material and shape of the body under one point of its surface.
struct ContactSpot
{
  double reducedModulus = 0.0;  ///< E*, MPa
  double poissonRatio = 0.0;    ///< Poisson's ratio of the layer; not needed on a half-space
  double compliance = 0.0;      ///< global compliance in series with the local contact, mm/N
  double thickness = 0.0;       ///< thickness of the layer, mm; 0 for a half-space
  SpotCurvature curvature = {}; ///< curvature that the law includes; 0 if the law includes none
  double second = 0.0;          ///< thickness of the second layer of a stack, mm
  double thinnest = 0.0;        ///< thickness of the thinnest layer of a stack, mm
  double complianceError = 0.0; ///< error of the compliance, mm/N
  double thicknessError = 0.0;  ///< error of 1/thickness, 1/mm; on a half-space 1/thickness is 0
  double secondError = 0.0;     ///< error of 1/second, 1/mm

  LayerPlace place() const noexcept
  {
    return { this->thickness, this->second, this->poissonRatio };
  }
  bool hasThicknessError() const noexcept
  {
    return this->thicknessError > 0.0 || this->secondError > 0.0;
  }
  /// Returns the layers with the smallest thicknesses within the errors of the thicknesses.
  LayerPlace thinnestPlace() const noexcept
  {
    const auto thinner = [](double given, double error) {
      return !(error > 0.0) ? given : given > 0.0 ? given / (1.0 + given * error) : 1.0 / error;
    };
    return { thinner(this->thickness, this->thicknessError),
      thinner(this->second, this->secondError), this->poissonRatio };
  }
};

/// The body under each point, given by constants and by arrays that override the constants. If an
/// array is null, the constant applies to all points.
struct ContactSpots
{
  ContactSpot constant;
  const double* reducedModulus = nullptr;
  const double* poissonRatio = nullptr;
  const double* compliance = nullptr;
  const double* thickness = nullptr;
  const double* second = nullptr;
  /// Thickness of the thinnest layer below the first two, mm; 0 if the body is not a stack.
  double deeperThinnest = 0.0;
  const double* complianceError = nullptr;
  const double* thicknessError = nullptr;
  const double* secondError = nullptr;

  ContactSpot at(std::size_t i) const
  {
    const auto pick = [i](const double* array, double otherwise)
    { return array ? array[i] : otherwise; };
    ContactSpot spot{ pick(this->reducedModulus, this->constant.reducedModulus),
      pick(this->poissonRatio, this->constant.poissonRatio),
      pick(this->compliance, this->constant.compliance),
      pick(this->thickness, this->constant.thickness) };
    spot.complianceError = pick(this->complianceError, this->constant.complianceError);
    spot.thicknessError = pick(this->thicknessError, this->constant.thicknessError);
    if (this->deeperThinnest > 0.0)
    {
      spot.second = pick(this->second, this->constant.second);
      spot.secondError = pick(this->secondError, this->constant.secondError);
      spot.thinnest = std::min(
        { spot.thickness, spot.second > 0.0 ? spot.second : spot.thickness, this->deeperThinnest });
    }
    return spot;
  }
};
} // namespace palpate

#endif

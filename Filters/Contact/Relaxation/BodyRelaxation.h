// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BodyRelaxation_h
#define palpate_BodyRelaxation_h

#include "Contact/LargePages.h"
#include "Contact/PackedMesh.h"
#include "Contact/ResponseField.h"
#include "Mechanics/PalpateExport.h"
#include "Mechanics/Relaxation/RelaxationStep.h"

#include <cmath>
#include <memory>

namespace palpate
{
/**
 * The relaxation data of a body for the servo tick, either one set for all points or one set per
 * point.
 *
 * A part of the compliance may be elastic and in series (RelaxationTerms::elasticCompliance). Then
 * only the remaining part of the curve relaxes: δ = δ_local + C F. The curves of this local part
 * are stored in addition to those of the response (80 bytes more per point).
 *
 * Immutable; can be used from any number of threads.
 */
class PALPATE_EXPORT BodyRelaxation
{
public:
  /// `response` is the response of the body at the points of the same mesh; it must outlive this
  /// object.
  BodyRelaxation(
    const PackedMesh& mesh, const ResponseField& response, const ResponseArrays& arrays);

  const PronySeries& series() const noexcept { return this->Series; }
  /// Returns the curves that relax: those of the local part, or those of the response if there is
  /// no elastic compliance.
  const ResponseField& curves() const noexcept { return this->Local ? *this->Local : this->Whole; }
  bool isInSeries() const noexcept { return this->Local != nullptr; }
  /// The longest range of curves(), mm.
  double range() const noexcept { return this->Range; }
  /// Whether the stiffness of all these curves increases with depth, except for noise. Other curves
  /// can only be used with one element (QuasiLinearElement).
  bool areConvex() const noexcept { return this->AreConvex; }
  /// Returns a point that has a curve if the curves of all points are the same; else -1.
  std::int32_t sameEverywhere() const noexcept { return this->Same; }
  bool isPerPoint() const noexcept { return !this->Strength.empty(); }

  /// Returns the approximate exponent m of F ∝ δ^m.
  double exponent() const noexcept { return this->Exponent; }
  /// Returns the contact radius at a depth, mm; 0 if it is unknown.
  double contactRadius(double depth) const noexcept
  {
    if (this->Exponent == 1.5)
    {
      return this->Radius * std::sqrt(depth);
    }
    return this->Radius > 0.0 ? this->Radius * std::pow(depth, this->Exponent - 1.0) : 0.0;
  }
  /// Returns the largest Σ p_i of all points.
  double strongest() const noexcept;
  /// Returns the strengths p_i at a point.
  RelaxationStep::Branches strength(std::int32_t point) const noexcept;
  /// Returns the strengths p_i interpolated between three points.
  RelaxationStep::Branches strength(
    const TriangleCorners& points, const Vector3& weights) const noexcept;
  /// Returns the interpolated elastic compliance, mm/N; 0 if the whole curve relaxes.
  double elasticCompliance(const TriangleCorners& points, const Vector3& weights) const noexcept;

private:
  void separate(const PackedMesh& mesh, const ResponseArrays& arrays);
  void compareCurves();

  const ResponseField& Whole;
  std::unique_ptr<const ResponseField> Local;
  PronySeries Series;
  /// Series.count values per point of the mesh; empty if all points have the same values.
  LargeVector<float> Strength;
  /// One value per point of the mesh; empty if the whole compliance relaxes.
  LargeVector<float> Compliance;
  double Exponent;
  double Radius;
  double Range;
  bool AreConvex = true;
  std::int32_t Same = -1;
};
} // namespace palpate

#endif

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
 * How a body relaxes, as a tick asks for it: of all points, or of each.
 *
 * Where a part of the compliance is elastic and in series (RelaxationTerms::elasticCompliance),
 * only the rest of the curve relaxes: δ = δ_local + C F, and the curves of the local part are kept
 * beside those of the response (80 bytes per point more).
 *
 * Immutable, safe from any number of threads.
 */
class PALPATE_EXPORT BodyRelaxation
{
public:
  /// `response` is the body's, of the same mesh, and must outlive this.
  BodyRelaxation(
    const PackedMesh& mesh, const ResponseField& response, const ResponseArrays& arrays);

  const PronySeries& series() const noexcept { return this->Series; }
  /// The curves that relax.
  const ResponseField& curves() const noexcept { return this->Local ? *this->Local : this->Whole; }
  bool isInSeries() const noexcept { return this->Local != nullptr; }
  /// The longest range of these curves, mm.
  double range() const noexcept { return this->Range; }
  /// Whether all of these get stiffer with depth, by more than noise would have it: others are only
  /// felt as one element (QuasiLinearElement).
  bool areConvex() const noexcept { return this->AreConvex; }
  /// A point with a curve, where all have the same; else -1.
  std::int32_t sameEverywhere() const noexcept { return this->Same; }
  bool isPerPoint() const noexcept { return !this->Strength.empty(); }

  /// m of F ∝ δ^m, about.
  double exponent() const noexcept { return this->Exponent; }
  /// Contact radius at a depth, mm; 0: unknown.
  double contactRadius(double depth) const noexcept
  {
    if (this->Exponent == 1.5)
    {
      return this->Radius * std::sqrt(depth);
    }
    return this->Radius > 0.0 ? this->Radius * std::pow(depth, this->Exponent - 1.0) : 0.0;
  }
  /// The largest Σ p_i of a point.
  double strongest() const noexcept;
  /// p_i at a point.
  RelaxationStep::Branches strength(std::int32_t point) const noexcept;
  /// The same, blended.
  RelaxationStep::Branches strength(
    const TriangleCorners& points, const Vector3& weights) const noexcept;
  /// mm/N, blended; 0 where all relaxes.
  double elasticCompliance(const TriangleCorners& points, const Vector3& weights) const noexcept;

private:
  void separate(const PackedMesh& mesh, const ResponseArrays& arrays);
  void compareCurves();

  const ResponseField& Whole;
  std::unique_ptr<const ResponseField> Local;
  PronySeries Series;
  LargeVector<float> Strength;   ///< k per point of the mesh, or none
  LargeVector<float> Compliance; ///< 1 per point of the mesh, or none
  double Exponent;
  double Radius;
  double Range;
  bool AreConvex = true;
  std::int32_t Same = -1;
};
} // namespace palpate

#endif

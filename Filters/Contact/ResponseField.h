// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ResponseField_h
#define palpate_ResponseField_h

#include "Contact/Coupled/CouplingTerms.h"
#include "Contact/Edges/EdgeLaw.h"
#include "Contact/LargePages.h"
#include "Contact/PackedMesh.h"
#include "Contact/Relaxation/RelaxationTerms.h"
#include "Contact/Tilt/TiltViews.h"
#include "Mechanics/PalpateExport.h"
#include "Contact/ResponseContract.h"
#include "Contact/ResponseSampling.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
class ResponseField;
class RisingStiffness;

/**
 * The response arrays of a body. The views do not own their memory. There are two forms. In the
 * form per point, force and stiffness have n floats per point. In the compact form with k >= 1
 * laws, `basis` has k rows of n forces followed by n stiffnesses, `coefficient` has k floats per
 * point, and the curve is Σ_k coefficient_k basis_k. In both forms, each point has a normal (3
 * floats), a range (1 float) and a status (1 byte).
 */
struct ResponseArrays
{
  std::size_t points = 0;
  int samples = 0;
  double exponent = 1.0;
  const float* force = nullptr;
  const float* stiffness = nullptr;
  int laws = 0;
  const float* basis = nullptr;
  const float* coefficient = nullptr;
  const float* normal = nullptr;
  const float* range = nullptr;
  const std::uint8_t* status = nullptr;
  EdgeTerms edges;            ///< terms for contacts over sharp edges; the same at all points
  RelaxationTerms relaxation; ///< terms for the relaxation of the body
  CouplingTerms coupling;     ///< terms for the coupling of contacts on the body
  TiltViews tilt;             ///< the effect of tilting the tool, if it is known
  /// A field of which the curves of this response are multiples; null if there is none. The
  /// information whether the stiffness increases is copied from this field. The field is only used
  /// during construction.
  const ResponseField* multipleOf = nullptr;

  /// Returns the largest range δ_max of all points, mm; 0 if no point has a response.
  double longestRange() const noexcept
  {
    float longest = 0.0F;
    for (std::size_t i = 0; i < this->points; ++i)
    {
      longest = this->isUsable(i) && this->range[i] > longest ? this->range[i] : longest;
    }
    return static_cast<double>(longest);
  }

  /// Whether the point has a response.
  bool isUsable(std::size_t point) const noexcept
  {
    const auto is = static_cast<ResponseStatus>(this->status[point]);
    return (is == ResponseStatus::Valid || is == ResponseStatus::Edge) && this->range[point] > 0.0F;
  }
};

/**
 * A packed copy of a response for the servo tick: one record per point, in the order of the mesh's
 * points, so that a tick reads one block of memory per vertex. A record has 80 bytes with 8
 * samples. In the compact form it has 16 bytes plus 4 bytes per law, or only 16 bytes if all points
 * share one law and its coefficient. Immutable; can be used from any number of threads.
 */
class PALPATE_EXPORT ResponseField
{
public:
  /// With a mesh, the records are in the order of the mesh's points, and the arrays are in the
  /// order of the mesh's input. Without a mesh, both are in the order of the arrays. For points on
  /// creases of the mesh, the normals of the mesh are used.
  explicit ResponseField(const ResponseArrays& arrays, const PackedMesh* mesh = nullptr);

  std::size_t pointCount() const noexcept { return this->Points; }
  const ResponseSampling& sampling() const noexcept { return this->Sampling; }

  /// Whether the point has a response.
  bool isValid(std::int32_t point) const noexcept { return this->range(point) > 0.0; }
  /// Returns the range δ_max, mm; 0 if the point has no response.
  double range(std::int32_t point) const noexcept { return this->record(point)[0]; }
  Vector3 normal(std::int32_t point) const noexcept
  {
    const float* head = this->record(point);
    return { head[1], head[2], head[3] };
  }
  ResponseValue evaluate(std::int32_t point, double deflection) const noexcept;
  /// Evaluates the curve at the position that sampling() has found for the point's range.
  ResponseValue evaluate(std::int32_t point, const ResponseSampling::Place& at) const noexcept;

  /// Returns F and K of sample `lower`, then F and K of the next sample, interpolated between three
  /// points.
  Eigen::Vector4d blendSamples(
    const TriangleCorners& points, const Vector3& weights, int lower) const noexcept;

  /// Returns the work ∫₀^δ F, N mm; 0 for a point without response. Takes O(samples).
  double energy(std::int32_t point, double deflection) const noexcept;
  /// Whether two points have the same curve, bit for bit.
  bool haveSameCurve(std::int32_t point, std::int32_t other) const noexcept;

  /// Prefetches the memory of a point.
  void prefetch(std::int32_t point) const noexcept
  {
    prefetchLine(this->record(point));
    prefetchLine(this->record(point) + this->Stride - 1);
  }
  /// Returns whether the stiffness of every point's curve, and therefore of every interpolated
  /// curve, increases with the deflection (RisingStiffness).
  bool hasRisingStiffness() const noexcept { return this->IsRising; }
  /// Returns the memory used, bytes.
  std::size_t memory() const noexcept { return this->Records.size() * sizeof(float); }

private:
  static constexpr std::size_t HeadSize = 4;

  const float* record(std::int32_t point) const noexcept
  {
    return this->Records.data() + this->Stride * static_cast<std::size_t>(point);
  }
  template <class Use>
  auto withCurve(std::int32_t point, const Use& use) const noexcept;
  Eigen::Vector4d combineLaws(
    const TriangleCorners& points, const Vector3& weights, int lower) const noexcept;
  void shareCoefficient(const ResponseArrays& arrays);
  void pack(const ResponseArrays& arrays, std::size_t input, std::size_t point);
  /// Returns whether the stiffness increases at all points from `first` to `last` - 1.
  bool areRising(const RisingStiffness& rising, std::size_t first, std::size_t last) const noexcept;

  ResponseSampling Sampling;
  std::size_t Points;
  int Laws;
  std::size_t Stride;
  bool IsRising = false;
  /// For each point: range (0 if it has no response), normal, then either force and stiffness of
  /// each sample in turn, or the coefficients.
  LargeVector<float> Records;
  std::vector<float> Basis;
  /// The coefficient, if all points share one law and one coefficient. The records then have no
  /// coefficients.
  float Shared = 0.0F;
  ResponseEnergy Energy; ///< the last member, because a tick reads the other members
};

inline Eigen::Vector4d ResponseField::blendSamples(
  const TriangleCorners& points, const Vector3& weights, int lower) const noexcept
{
  if (this->Laws > 0)
  {
    return this->combineLaws(points, weights, lower);
  }
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (std::size_t k = 0; k < 3; ++k)
  {
    const float* samples = this->record(points[k]) + HeadSize + 2 * static_cast<std::size_t>(lower);
    sum += weights[static_cast<Eigen::Index>(k)] *
      Eigen::Map<const Eigen::Vector4f>(samples).cast<double>();
  }
  return sum;
}

/// The curve of a contact: the curves of three points, interpolated with area coordinates.
class PALPATE_EXPORT BlendedResponse
{
public:
  /// Points of weight 0 have no effect; the other points must have a response.
  BlendedResponse(
    const ResponseField& field, const TriangleCorners& points, const Vector3& weights) noexcept
    : Field(field)
    , Points(points)
    , Weights(weights)
  {
  }

  /// Returns the interpolated range δ_max, mm.
  double range() const noexcept;
  /// Returns the value of each point's curve; zero for points of weight 0. The deflection must be >
  /// 0.
  std::array<ResponseValue, 3> evaluateEach(double deflection) const noexcept;
  ResponseValue evaluate(double deflection) const noexcept
  {
    ResponseValue sum;
    return !(deflection > 0.0) || this->evaluateTogether(deflection, sum)
      ? sum
      : this->evaluateApart(deflection);
  }
  /// Returns the work ∫₀^δ F of each point, N mm, up to an additive constant common to all three.
  /// If the curves are the same, the values are zero. A point without response, which has weight 0,
  /// has the work of the interpolated curve.
  Vector3 energies(double deflection) const noexcept;
  /// Returns the work ∫₀^δ F of the interpolated curve, N mm.
  double energy(double deflection) const noexcept;

  /// Returns whether all three curves have the range `range`.
  bool hasRange(double range) const noexcept
  {
    return this->Field.range(this->Points[0]) == range &&
      this->Field.range(this->Points[1]) == range && this->Field.range(this->Points[2]) == range;
  }
  /// Returns whether the stiffness is known to increase with the deflection: true if it increases
  /// at all points of the field.
  bool hasRisingStiffness() const noexcept { return this->Field.hasRisingStiffness(); }
  /// Returns F and K of sample `lower`, then F and K of the next sample, interpolated; for three
  /// curves with the same range.
  Eigen::Vector4d samples(int lower) const noexcept
  {
    return this->Field.blendSamples(this->Points, this->Weights, lower);
  }

private:
  /// Evaluates the interpolated samples, which is only possible if the three curves have the same
  /// range. Otherwise returns false.
  bool evaluateTogether(double deflection, ResponseValue& sum) const noexcept;
  ResponseValue evaluateApart(double deflection) const noexcept;
  bool areAlike() const noexcept
  {
    return this->Field.haveSameCurve(this->Points[0], this->Points[1]) &&
      this->Field.haveSameCurve(this->Points[1], this->Points[2]);
  }

  const ResponseField& Field;
  TriangleCorners Points;
  Vector3 Weights;
};
[[gnu::hot]] inline bool BlendedResponse::evaluateTogether(
  double deflection, ResponseValue& sum) const noexcept
{
  const double range = this->Field.range(this->Points[0]);
  if (!(range > 0.0) || !this->hasRange(range))
  {
    return false;
  }
  const ResponseSampling::Place at = this->Field.sampling().place(range, deflection);
  if (at.lower < 0)
  {
    return false;
  }
  const Eigen::Vector4d samples = this->Field.blendSamples(this->Points, this->Weights, at.lower);
  sum = this->Field.sampling().between({ samples[0], samples[1], samples[2], samples[3] }, at);
  return true;
}
} // namespace palpate

#endif

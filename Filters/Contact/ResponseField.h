// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ResponseField_h
#define palpate_ResponseField_h

#include "ResponseSampling.h"
#include "TriangleProjection.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/// Status of the response of one point.
enum class ResponseStatus : std::uint8_t
{
  Valid,
  Degenerate,
  NotFinite,
  Folded,
  OutOfReach,
  Edge ///< interpolated from its neighbours; usable
};

/**
 * The response arrays of a body, as views of somebody else's memory. One of two forms:
 * per point (force and stiffness, n floats per point) or compact (laws k >= 1: `basis` of k rows of
 * n forces then n stiffnesses, `coefficient` of k floats per point, curve = Σ_k coefficient_k
 * basis_k). normal (3 floats), range (1) and status (1 byte) are per point in both.
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
};

/**
 * The kernel's own packed copy of a response: one record per point, so that a tick reads one place
 * for each of its three vertices. Immutable, safe from any number of threads.
 */
class ResponseField
{
public:
  explicit ResponseField(const ResponseArrays& arrays);

  std::size_t pointCount() const noexcept { return this->Points; }
  const ResponseSampling& sampling() const noexcept { return this->Sampling; }

  /// Whether the point has a response.
  bool isValid(std::int32_t point) const noexcept { return this->record(point)[0] > 0.0F; }
  Vector3 normal(std::int32_t point) const noexcept;
  ResponseValue evaluate(std::int32_t point, double deflection) const noexcept;

private:
  const float* record(std::int32_t point) const noexcept
  {
    return this->Records.data() + this->Stride * static_cast<std::size_t>(point);
  }

  ResponseSampling Sampling;
  std::size_t Points;
  int Laws;
  std::size_t Stride;
  std::vector<float> Records; ///< range (0: no response), normal, then curve or coefficients
  std::vector<float> Basis;
};
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BodyTilt_h
#define palpate_BodyTilt_h

#include "Contact/MeshOrder.h"
#include "Contact/ResponseField.h"
#include "Contact/Tilt/TiltViews.h"
#include "Mechanics/Tilt/TiltTable.h"

#include <array>
#include <cstddef>

namespace palpate
{
/// Response of a body to a tilted tool, for the servo tick: the table of the laws, and the weights
/// of the laws at each point. Immutable; can be used from any number of threads.
class BodyTilt
{
public:
  using Weights = std::array<double, TiltTerms::MostLaws>;

  BodyTilt(const PackedMesh& mesh, const TiltViews& views)
    : Table(views.terms, views.drops, views.nodes)
    , Laws(static_cast<std::size_t>(views.terms.laws))
    , Weight(inMeshOrder(this->Laws > 1 ? views.weight : nullptr, this->Laws, mesh))
  {
  }

  const TiltTable& table() const noexcept { return this->Table; }
  /// Returns the largest drop, that is, the depth of the tool's deepest point below its tip at the
  /// largest tilt, mm.
  double largestDrop() const noexcept
  {
    return this->Table.deepest(this->Table.terms().largest).drop;
  }
  bool isPerPoint() const noexcept { return !this->Weight.empty(); }

  /// Returns the weights of the laws at a point.
  Weights weights(std::int32_t point) const noexcept
  {
    Weights all{};
    all[0] = 1.0;
    if (this->isPerPoint())
    {
      const float* of = this->Weight.data() + this->Laws * static_cast<std::size_t>(point);
      std::copy_n(of, this->Laws, all.begin());
    }
    return all;
  }
  /// Returns the weights of the laws at a point of a triangle, interpolated from its three corners.
  Weights weights(const TriangleCorners& points, const Vector3& areas) const noexcept
  {
    if (!this->isPerPoint())
    {
      return this->weights(points[0]);
    }
    Weights all{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      const float* of = this->Weight.data() + this->Laws * static_cast<std::size_t>(points[k]);
      for (std::size_t law = 0; law < this->Laws; ++law)
      {
        all[law] += areas[static_cast<Eigen::Index>(k)] * static_cast<double>(of[law]);
      }
    }
    return all;
  }

private:
  TiltTable Table;
  std::size_t Laws;
  LargeVector<float> Weight;
};
} // namespace palpate

#endif

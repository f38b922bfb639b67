// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SegmentDistance_h
#define palpate_SegmentDistance_h

#include <algorithm>

namespace palpate
{
/// Square of the distance from the origin to the segment between two points, in a plane or in
/// space. For a segment without length, the distance to its ends.
template <class Vector>
double squareToSegment(const Vector& from, const Vector& to)
{
  const Vector along = to - from;
  const double square = along.squaredNorm();
  const double part = square > 0.0 ? std::clamp(-from.dot(along) / square, 0.0, 1.0) : 0.0;
  return (from + part * along).squaredNorm();
}
} // namespace palpate

#endif

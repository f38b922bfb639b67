// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SegmentDistance_h
#define palpate_SegmentDistance_h

#include <algorithm>

namespace palpate
{
/// Returns the squared distance from the origin to the segment between two points, in a plane or in
/// space. If the segment has no length, returns the squared distance to its end.
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

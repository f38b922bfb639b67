// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_RestingDepth_h
#define palpate_testing_RestingDepth_h

#include "VirtualLoop.h"

#include <cmath>

/// The rest position of a rendering without control and without memory, straight below the origin.
namespace palpate::testing
{
/// Force in N at a depth in m.
inline double forceAt(Rendering& rendering, double depth)
{
  DeviceSample sample;
  sample.valid = true;
  sample.position.z() = -depth;
  return rendering.force(sample, 0.0).z();
}

/// The depth (m) at which a rendering without control carries the push. It uses the rendered force,
/// which differs slightly from the law beyond the range and before the first sample.
inline double restingDepth(Rendering& rendering, double push)
{
  double low = 1e-9;
  double high = 0.2;
  for (int i = 0; i < 60; ++i)
  {
    const double middle = std::sqrt(low * high);
    (forceAt(rendering, middle) < push ? low : high) = middle;
  }
  return high;
}

/// Stiffness in N/m.
inline double stiffnessAt(Rendering& rendering, double depth)
{
  return (forceAt(rendering, 1.001 * depth) - forceAt(rendering, depth)) / (0.001 * depth);
}
} // namespace palpate::testing

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef ResponseReach_h
#define ResponseReach_h

#include <string>

class vtkPolyData;

namespace palpate
{
/// The ranges of a body's response, from which the axes of a chart are chosen.
struct ResponseReach
{
  double deflection = 0.0; ///< mm
  double force = 0.0;      ///< largest of any point there, N
  double halfForce = 0.0;  ///< and half as deep

  /// Down to `deflection`, or for 0 to the largest Range; zeros if the body has no such response.
  /// The forces are those of the stored samples at or beyond these depths. O(points).
  static ResponseReach of(vtkPolyData* body, const std::string& name, double deflection);
};
} // namespace palpate

#endif

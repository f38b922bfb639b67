// SPDX-License-Identifier: BSD-3-Clause
#ifndef ResponseReach_h
#define ResponseReach_h

#include <string>

class vtkPolyData;

namespace palpate
{
/// Depth and largest forces of a body's response, from which the initial axes of a chart are
/// chosen.
struct ResponseReach
{
  double deflection = 0.0; ///< mm
  double force = 0.0;      ///< largest force of any point at `deflection`, N
  double halfForce = 0.0;  ///< largest force of any point at half of `deflection`, N

  /// Evaluates the response at `deflection` (mm). If `deflection` is 0, the largest Range is used.
  /// All values are zero if the body has no such response. The forces are those of the stored
  /// samples at or beyond these depths. The cost is proportional to the number of points.
  static ResponseReach of(vtkPolyData* body, const std::string& name, double deflection);
};
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef ResponseReach_h
#define ResponseReach_h

#include <string>

class vtkPolyData;

namespace palpate
{
/// Depth and forces of a body's response. The initial axes of a chart are chosen from them.
struct ResponseReach
{
  double deflection = 0.0; ///< mm
  double force = 0.0;      ///< largest force of any point at `deflection`, N
  double halfForce = 0.0;  ///< largest force of any point at half of `deflection`, N

  /// Evaluates the response at `deflection` (mm); 0 means the largest Range. All values are zero if
  /// the body has no such response. The forces are those of the stored samples at or beyond these
  /// depths. Cost: O(points).
  static ResponseReach of(vtkPolyData* body, const std::string& name, double deflection);
};
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef FeltContact_h
#define FeltContact_h

#include "Haptics/Servo/ServoStep.h"

#include "vtkType.h"

#include <limits>

class vtkPointData;
class vtkPolyData;

namespace palpate
{
/// One tick of a session or tip of a probe, in the numbers that charts show.
struct FeltContact
{
  static constexpr double None = std::numeric_limits<double>::quiet_NaN();

  double time = None; ///< s; None: not told
  double ideal = 0.0; ///< N, as the three below
  double applied = None;
  double friction = 0.0;
  double normalForce = 0.0;
  double deflection = 0.0; ///< mm
  vtkIdType triangle = -1; ///< of the body's polygons; -1: no contact
  Vector3 contactPoint = Vector3::Zero();

  FeltContact() = default;
  explicit FeltContact(const ServoTick& tick);

  bool touches() const { return this->triangle >= 0; }
};

/// The tips of a probe's output or a recording.
class FeltTips
{
public:
  explicit FeltTips(vtkPolyData* probed);

  /// Whether they have the arrays of vtkToolContactProbe.
  bool isComplete() const;
  /// `firstPoly` is the cell id of the body's first triangle. AppliedForce and Time are read where
  /// they are.
  FeltContact at(vtkIdType index, vtkIdType firstPoly) const;

private:
  double number(const char* name, vtkIdType index, double otherwise) const;
  double length(const char* name, vtkIdType index, double otherwise) const;

  vtkPointData* Data;
};
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShownContact_h
#define ShownContact_h

#include "Haptics/Servo/ServoStep.h"

#include "vtkType.h"

#include <Eigen/Core>

#include <cmath>
#include <limits>
#include <string>

class vtkHapticSession;
class vtkPolyData;

namespace palpate
{
/// Whether `part` is large enough to be shown: more than 2 % of the force. `part` is a part of the
/// force, or a difference from the force.
inline bool isNoticeable(const Eigen::Vector3d& part, const Eigen::Vector3d& force)
{
  return part.norm() > 0.02 * force.norm();
}

/// One contact to draw, from a live session or from a tip of a probe (body's frame, mm, N).
struct ShownContact
{
  /// The tick. If there is no contact, its contact normal is the direction of the tool.
  Tick tick;
  bool hasApplied = false; ///< whether the tick has an applied force
  /// Reasons why the applied force differs, as text. "" if it does not differ or the reason is
  /// unknown.
  std::string safety;
  vtkIdType cell = -1; ///< cell of the body; -1 without contact

  /// Depth at which the first assumption of the response fails at the contact, mm. The member below
  /// is the number of this assumption (ResponseLimit).
  double validity = std::numeric_limits<double>::infinity();
  int limit = 0;
  /// Estimated relative error of the force; NaN if the response has no error array.
  double error = std::numeric_limits<double>::quiet_NaN();

  /// Whether other tools of the session can lower or raise the surface at this contact.
  bool hasOthers = false;

  bool touches() const { return this->cell >= 0; }
  /// Depth of the tip below the undeformed surface, mm.
  double tipDepth() const
  {
    return (this->tick.contact.contactPoint - this->tick.tip).dot(this->tick.contact.normal);
  }
  /// Whether other tools visibly change the depth of this tool's own dent.
  bool isLowered() const
  {
    constexpr double seen = 0.005; // smallest visible difference, mm
    return this->hasOthers && this->touches() && !(this->tick.contact.tilt > 0.0) &&
      std::abs(this->tipDepth() - this->tick.contact.deflection) > seen;
  }
  bool isValid() const
  {
    return !this->touches() || this->tick.contact.deflection <= this->validity;
  }

  bool appliedDiffers() const
  {
    return this->hasApplied &&
      isNoticeable(this->tick.appliedForce - this->tick.idealForce, this->tick.idealForce);
  }
  bool hasFriction() const
  {
    return isNoticeable(this->tick.contact.friction, this->tick.idealForce);
  }
};

/// Reads the tip with index `index` from the output of vtkToolContactProbe or
/// vtkHapticRecorder::GetRecording. The arrays FrictionForce, ContactState, AppliedForce and
/// SafetyLinks are optional. Returns false if another array is missing, or if there is no such tip.
bool readTip(vtkPolyData* probed, vtkIdType index, ShownContact& contact);

/// Reads the newest tick of one device of a session, with the validity of its contact. Without
/// contact, the direction of the tool is `freeDirection`. The result has no applied force if the
/// session does not run or if the device outputs no force.
ShownContact readSession(vtkHapticSession* session, int hand, const Eigen::Vector3d& freeDirection);

/// Makes a contact from a tick of the session's first device, with its validity.
ShownContact contactOfTick(vtkHapticSession* session, const Tick& tick);

/// Makes a contact from the arguments of vtkContactScene::ShowContact.
ShownContact contactOfNumbers(const double tip[3], const double contactPoint[3],
  const double normal[3], const double force[3], double deflection, vtkIdType cell);

/// Sets validity, limit and error of a contact from the arrays Validity, Limit and Error of the
/// response with this prefix. The validity is the smallest one of the three corners of the cell. It
/// is infinite if these arrays are missing or if there is no contact.
void findValidity(vtkPolyData* body, const std::string& responseName, ShownContact& contact);
} // namespace palpate

#endif

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
/// Whether a part of a force, or a difference from it, is worth showing: more than 2 %.
inline bool isNoticeable(const Eigen::Vector3d& part, const Eigen::Vector3d& force)
{
  return part.norm() > 0.02 * force.norm();
}

/// One contact as it is drawn, of a live session or of a probe's tip. Body frame, mm, N.
struct ShownContact
{
  /// Where nothing is touched, the contact's normal is the direction the tool stands along.
  Tick tick;
  bool hasApplied = false; ///< the tick tells what the device is told
  std::string safety; ///< why the applied force is another, in words; "" if it is not, or not known
  vtkIdType cell = -1; ///< of the body; -1: no contact

  /// Depth at which the first assumption of the response breaks at the contact, mm, and which one:
  /// the contract's code.
  double validity = std::numeric_limits<double>::infinity();
  int limit = 0;
  /// Estimated relative error of the force; NaN where the response keeps none.
  double error = std::numeric_limits<double>::quiet_NaN();

  bool hasOthers = false; ///< other tools of the session may have let the surface down here, or up

  bool touches() const { return this->cell >= 0; }
  /// Of the tip below the undeformed surface, mm.
  double tipDepth() const
  {
    return (this->tick.contact.contactPoint - this->tick.tip).dot(this->tick.contact.normal);
  }
  /// Whether others have changed what is left of the tip's depth for its own dent.
  bool isLetDown() const
  {
    constexpr double seen = 0.005; // mm
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

/// Tip `index` of the output of vtkToolContactProbe or vtkHapticRecorder::GetRecording.
/// FrictionForce, ContactState, AppliedForce and its SafetyLinks are read where they are; false if
/// any other array is missing or there is no such tip.
bool readTip(vtkPolyData* probed, vtkIdType index, ShownContact& contact);

/// Of one of a session's devices, the newest tick, with its validity; where it touches nothing, the
/// tool stands along `freeDirection`. A session that does not run, and a device without force,
/// apply none that could be shown.
ShownContact readSession(vtkHapticSession* session, int hand, const Eigen::Vector3d& freeDirection);

/// As vtkContactScene::ShowContact takes them.
ShownContact contactOfNumbers(const double tip[3], const double contactPoint[3],
  const double normal[3], const double force[3], double deflection, vtkIdType cell);

/// Sets validity, limit and error of a contact from Validity, Limit and Error of the response with
/// this prefix: of the three corners of its cell the weakest. Infinite without those arrays, or
/// without a contact.
void findValidity(vtkPolyData* body, const std::string& responseName, ShownContact& contact);
} // namespace palpate

#endif

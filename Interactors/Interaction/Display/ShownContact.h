// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShownContact_h
#define ShownContact_h

#include "vtkType.h"

#include <Eigen/Core>

#include <limits>
#include <string>

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
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();
  Eigen::Vector3d contactPoint = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();   ///< outward, unit; where nothing is touched
                                                      ///< the direction the tool is to stand along
  Eigen::Vector3d force = Eigen::Vector3d::Zero();    ///< on the tool, friction included: the ideal
  Eigen::Vector3d friction = Eigen::Vector3d::Zero(); ///< in it
  Eigen::Vector3d applied = Eigen::Vector3d::Zero();  ///< what the device is told, if hasApplied
  bool hasApplied = false;
  std::string safety; ///< why the applied force is another, in words; "" if it is not, or not known
  double deflection = 0.0;
  vtkIdType cell = -1; ///< of the body; -1: no contact
  int state = 0;       ///< ContactState of vtkToolContactProbe

  /// Depth at which the first assumption of the response breaks at the contact, mm, and which one:
  /// the contract's code.
  double validity = std::numeric_limits<double>::infinity();
  int limit = 0;

  bool touches() const { return this->cell >= 0; }
  bool isValid() const { return !this->touches() || this->deflection <= this->validity; }

  bool appliedDiffers() const
  {
    return this->hasApplied && isNoticeable(this->applied - this->force, this->force);
  }
  bool hasFriction() const { return isNoticeable(this->friction, this->force); }
};
} // namespace palpate

#endif

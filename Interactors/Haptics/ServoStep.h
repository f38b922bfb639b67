// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ServoStep_h
#define palpate_ServoStep_h

#include "HapticDevice.h"
#include "ToolContact.h"
#include "WorkspaceMapping.h"

namespace palpate
{
/// What one step of the servo loop saw and did.
struct ServoTick
{
  double time = 0.0;                                     ///< s
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();         ///< body frame, mm
  ToolContactForce contact;                              ///< body frame; the ideal force
  Eigen::Vector3d deviceForce = Eigen::Vector3d::Zero(); ///< device frame, N; what is sent
};

/**
 * One step of the servo loop, as a plain function of a sample and a time: device sample → body
 * frame → contact → force on the device. For a loop of our own or of somebody else's.
 *
 * The force sent is zero for an invalid sample or a force that is not finite, and its magnitude is
 * limited to what the device is specified for, keeping its direction; a limit that is negative or
 * NaN sends none. step() neither allocates nor locks nor throws. One ServoStep serves one thread;
 * the body must outlive it.
 */
class ServoStep
{
public:
  ServoStep(const ContactBody& body, const WorkspaceMapping& mapping, double maximumForce,
    const ContactSettings& settings = {});

  ServoTick step(const DeviceSample& sample, double time) noexcept;
  void reset() noexcept { this->Contact.reset(); }

private:
  ToolContact Contact;
  WorkspaceMapping Mapping;
  double MaximumForce;
};
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DeviceFit_h
#define palpate_DeviceFit_h

#include "Haptics/Devices/HapticDevice.h"
#include "Mechanics/PalpateExport.h"

#include <string>

namespace palpate
{
class ResponseField;
struct ContactBody;

/**
 * One common force factor for all compared tools. With this factor a device can render the
 * strongest and the stiffest of the tools, and the ratios of their forces are kept:
 *   min(1, F_max/F_peak, K_max/K_peak),
 * where the peaks are over all tools, all points and all depths up to a given one.
 *
 * Without the factor the limits of the device would remove the differences between tools. The three
 * tools of Mahvash and Hayward (2002), pressed 1 mm deep into rubber, differ by 52 % (11.4, 11.0,
 * 5.45 N). If only the stiffness is capped at 2 N/mm, they differ by 2 % (1.99, 2.00, 1.96 N); with
 * the common factor 0.115 again by 52 %.
 */
class PALPATE_EXPORT DeviceFit
{
public:
  /// `scale` is that of the WorkspaceMapping: a stiffness K of the body is `scale` K for the hand.
  explicit DeviceFit(const DeviceSpecification& device, double scale = 1.0) noexcept;

  /// Includes a tool with a given force (N) and stiffness (N/mm, of the body).
  void include(double force, double stiffness) noexcept;
  /// Includes a tool by its response: at all points that have a response, at the samples and
  /// halfway between samples up to `depth` (mm, > 0), and at `depth`. Depths below the first sample
  /// are ignored, because a law may begin with infinite stiffness. Runs in parallel; not for the
  /// tick.
  void include(const ResponseField& response, double depth);
  /// Includes a tool on a body. If the body relaxes, its instantaneous response is used: 1 + Σ p_i
  /// times the slow response.
  void include(const ContactBody& body, double depth);

  double peakForce() const noexcept { return this->PeakForce; }         ///< N
  double peakStiffness() const noexcept { return this->PeakStiffness; } ///< N/mm
  /// The factor for all included tools; 1 if no tool was included, 0 if a peak is not finite.
  double factor() const noexcept;
  /// Why the factor is below 1: "the device is too weak: 10 N of 52.3 N", or "the device is too
  /// soft: 1.5 N/mm of 7.91 N/mm", with its maximum and the peak; "" if the factor is 1.
  std::string reason() const;

private:
  double MaximumForce;
  double MaximumStiffness; ///< N/mm, of the body
  double PeakForce = 0.0;
  double PeakStiffness = 0.0;
};
} // namespace palpate

#endif

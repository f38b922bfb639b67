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
 * Computes one common force factor for all compared tools. With this factor a device can render the
 * strongest and the stiffest of the tools, and the ratios of the forces of the tools are kept. The
 * factor is
 *   min(1, F_max/F_peak, K_max/K_peak).
 * The peaks are taken over all tools, all points and all depths up to a given depth.
 *
 * Without the factor, the limits of the device would remove the differences between tools. The
 * three tools of Mahvash and Hayward (2002), pressed 1 mm deep into rubber, differ by 52 % (11.4,
 * 11.0, 5.45 N). If only the stiffness is capped at 2 N/mm, the forces differ by 2 % (1.99, 2.00,
 * 1.96 N). With the common factor 0.115 they differ by 52 % again.
 */
class PALPATE_EXPORT DeviceFit
{
public:
  /// `scale` is the scale of the WorkspaceMapping: the stiffness at the hand is `scale` times the
  /// stiffness of the body.
  explicit DeviceFit(const DeviceSpecification& device, double scale = 1.0) noexcept;

  /// Includes a tool by its force (N) and its stiffness at the body (N/mm).
  void include(double force, double stiffness) noexcept;
  /// Includes a tool by its response. The response is evaluated at all points that have one: at its
  /// samples and halfway between samples up to `depth` (mm, > 0), and at `depth`. Depths below the
  /// first sample are ignored, because a law may begin with infinite stiffness. Runs in parallel
  /// and must not be called from the servo tick.
  void include(const ResponseField& response, double depth);
  /// Includes a tool on a body. If the body relaxes, the instantaneous response is used, which is 1
  /// + Σ p_i times the slow response.
  void include(const ContactBody& body, double depth);

  double peakForce() const noexcept { return this->PeakForce; }         ///< N
  double peakStiffness() const noexcept { return this->PeakStiffness; } ///< N/mm
  /// The common factor for all included tools. It is 1 if no tool was included, and 0 if a peak is
  /// not finite.
  double factor() const noexcept;
  /// Returns the reason why the factor is below 1, with the limit of the device and the peak: "the
  /// device is too weak: 10 N of 52.3 N", or "the device is too soft: 1.5 N/mm of 7.91 N/mm".
  /// Returns "" if the factor is 1.
  std::string reason() const;

private:
  double MaximumForce;
  double MaximumStiffness; ///< largest stiffness of the body that the device can render, N/mm
  double PeakForce = 0.0;
  double PeakStiffness = 0.0;
};
} // namespace palpate

#endif

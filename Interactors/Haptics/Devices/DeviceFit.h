// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DeviceFit_h
#define palpate_DeviceFit_h

#include "Haptics/Devices/HapticDevice.h"
#include "Mechanics/PalpateExport.h"

namespace palpate
{
class ResponseField;
struct ContactBody;

/**
 * One common force factor for all tools that are compared. With it a device can render the
 * strongest and the stiffest of them, and their ratios are kept:
 *   min(1, F_max/F_peak, K_max/K_peak),
 * where the peaks are over all tools, all points and all depths up to a given one.
 *
 * Without the factor the limits of the device make the tools alike. The three tools of Mahvash and
 * Hayward (2002), 1 mm deep in rubber, differ by 52 % (11.4, 11.0, 5.45 N). If only the stiffness
 * is capped at 2 N/mm, they differ by 2 % (1.99, 2.00, 1.96 N); with the common factor 0.115 again
 * by 52 %.
 */
class PALPATE_EXPORT DeviceFit
{
public:
  /// `scale` is that of the WorkspaceMapping: for the hand, a stiffness K of the body is scale K.
  explicit DeviceFit(const DeviceSpecification& device, double scale = 1.0) noexcept;

  /// Includes a tool with this force (N) and this stiffness (N/mm, of the body).
  void include(double force, double stiffness) noexcept;
  /// Includes a tool by its response: at all points that have one, at the samples and halfway
  /// between them up to `depth` (mm, > 0), and at `depth`. Depths below the first sample are left
  /// out, because a law may begin with infinite stiffness. Runs in parallel; not for the tick.
  void include(const ResponseField& response, double depth);
  /// Includes a tool on a body. If the body relaxes, its instantaneous response is used: 1 + Σ p_i
  /// times the slow one.
  void include(const ContactBody& body, double depth);

  double peakForce() const noexcept { return this->PeakForce; }         ///< N
  double peakStiffness() const noexcept { return this->PeakStiffness; } ///< N/mm
  /// The factor for all tools that were included; 1 if there are none. 0 if a peak is not finite.
  double factor() const noexcept;

private:
  double MaximumForce;
  double MaximumStiffness; ///< N/mm, of the body
  double PeakForce = 0.0;
  double PeakStiffness = 0.0;
};
} // namespace palpate

#endif

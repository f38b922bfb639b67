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
 * One force factor for all tools that are compared, so that a device can render the strongest and
 * the stiffest of them and their ratios are kept:
 *   min(1, F_max/F_peak, K_max/K_peak),
 * the peaks over all tools, all points and all depths up to one.
 *
 * Without it the limits of the device make the tools alike. The three tools of Mahvash and Hayward
 * (2002), 1 mm deep in rubber, differ by 52 % (11.4, 11.0, 5.45 N); with the stiffness capped at
 * 2 N/mm alone by 2 % (1.99, 2.00, 1.96 N); with the common factor 0.115 by 52 % again.
 */
class PALPATE_EXPORT DeviceFit
{
public:
  /// `scale` is that of the WorkspaceMapping: a stiffness K of the body is felt as scale K.
  explicit DeviceFit(const DeviceSpecification& device, double scale = 1.0) noexcept;

  /// Includes a tool with this force (N) and this stiffness (N/mm, of the body).
  void include(double force, double stiffness) noexcept;
  /// Includes a tool by its response: at all points that have one, at the samples and halfway
  /// between them up to `depth` (mm, > 0), and at `depth`. Below the first sample, where a law may
  /// begin infinitely stiff, the first sample counts. In parallel; not for the tick.
  void include(const ResponseField& response, double depth);
  /// Includes a tool on a body; if that relaxes, its instantaneous response, 1 + Σ p_i times the
  /// slow one.
  void include(const ContactBody& body, double depth);

  double peakForce() const noexcept { return this->PeakForce; }         ///< N
  double peakStiffness() const noexcept { return this->PeakStiffness; } ///< N/mm
  /// The factor for all that was included; 1 if nothing was. 0 if a peak is not finite.
  double factor() const noexcept;

private:
  double MaximumForce;
  double MaximumStiffness; ///< N/mm, of the body
  double PeakForce = 0.0;
  double PeakStiffness = 0.0;
};
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SpaceMouseDevice_h
#define palpate_SpaceMouseDevice_h

#include "Haptics/Devices/HapticDevice.h"
#include "Transports/Hid/HidBus.h"
#include "Transports/Hid/HidReader.h"
#include "Mechanics/PalpateExport.h"
#include "Transports/Hid/SpaceMouseReport.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <string>

namespace palpate
{
enum class SpaceMouseMode : std::uint8_t
{
  /// The displacement of the cap sets the velocity of the tip. The tip stops when the cap is
  /// released.
  Rate,
  /// The displacement of the cap sets the position of the tip. The tip returns to 0 when the cap is
  /// released.
  Position
};

/// The settings that determine how the cap of a SpaceMouse moves the tip.
struct SpaceMouseSettings
{
  double fullSpeed = 0.05; ///< speed at full deflection in rate mode, m/s
  /// Limit of the tip's coordinates, m. In position mode, it is reached at full deflection.
  double halfExtent = 0.05;
  double deadZone = 0.05; ///< fraction of full deflection within which the cap counts as at rest
  /// Time constant of the low-pass filter between reports, s. Reports arrive at 60 to 125 Hz.
  double filterTime = 0.02;
  /// Time without a report, s, after which the tip stops in rate mode. While the cap is pushed, the
  /// device sends reports continuously; at rest it sends none.
  double longestSilence = 0.25;
};

/**
 * A 3Dconnexion SpaceMouse, an input device without force output. Supports the classic and the
 * wireless report layouts (SpaceMouseReport.h).
 *
 * In the device frame, x is to the right, y up and z towards the user. A reader thread decouples
 * the tick from the driver. Missing reports are not a fault: sampleTimeOut is infinite, and every
 * reading counts as fresh. After the device is unplugged, the samples of read are not valid from
 * the next call on. When the device is plugged in again, the tip continues at its last position.
 */
class PALPATE_EXPORT SpaceMouseDevice final : public HapticDevice
{
public:
  /// Opens the device at `path`, such as "/dev/hidraw0". On failure, returns null and sets `error`
  /// to the reason.
  static std::unique_ptr<SpaceMouseDevice> open(const std::string& path, SpaceMouseMode mode,
    std::string& error, HidBus& bus = systemHidBus(), const SpaceMouseSettings& settings = {});
  ~SpaceMouseDevice() override;

  const DeviceSpecification& specification() const noexcept override { return this->Limits; }
  DeviceSample read(double time) noexcept override;
  /// Accepts any force but has no effect, because the device outputs no force.
  bool write(const Eigen::Vector3d&) noexcept override { return true; }

  std::string status() const override { return this->Reader->status(); }
  DeviceErrors errors() const noexcept override;

private:
  class Link;
  SpaceMouseDevice(HidBus& bus, const HidEntry& entry, std::unique_ptr<HidPort> port,
    SpaceMouseMode mode, const SpaceMouseSettings& settings);
  Eigen::Vector3d pushed(double time) noexcept;
  void move(const Eigen::Vector3d& push, double elapsed) noexcept;

  SpaceMouseMode Mode;
  SpaceMouseSettings Settings;
  DeviceSpecification Limits;
  std::shared_ptr<Link> Connection;
  std::unique_ptr<HidReader> Reader;

  std::uint64_t Seen = 0; ///< number of the last report that was used
  double SeenTime = 0.0;  ///< time at which the last report was used, s
  double LastTime = std::numeric_limits<double>::quiet_NaN();
  Eigen::Vector3d Position = Eigen::Vector3d::Zero();
  Eigen::Vector3d Velocity = Eigen::Vector3d::Zero();
};
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_HidReader_h
#define palpate_HidReader_h

#include "Haptics/Servo/BoundedThread.h"
#include "Transports/Hid/HidBus.h"
#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace palpate
{
/// An interface that receives the events of a HidReader, in the thread of the reader.
class PALPATE_EXPORT HidListener
{
public:
  virtual ~HidListener() = default;
  /// Called when a device has been plugged in again and is open on `port`. Returns the reason why
  /// the device must not be used, or an empty text if it may be used.
  virtual std::string returned(HidPort& port, const HidEntry& entry) = 0;
  virtual void received(const std::uint8_t* report, std::size_t size) noexcept = 0;
  virtual void lost() noexcept = 0;
};

/**
 * Reads a HID device in a separate thread. After the device has been unplugged, the thread waits
 * until it is plugged in again.
 *
 * The path of the device may have changed. The device is recognised by vendor, product and serial
 * number. Without a serial number it is recognised by vendor and product, and the old path is
 * preferred. The search runs four times per second. The destructor waits at most one second, even
 * if the driver hangs.
 */
class PALPATE_EXPORT HidReader
{
public:
  /// `port` must be open on `entry`. At most `reportSize` bytes of a report are read.
  HidReader(HidBus& bus, HidEntry entry, std::unique_ptr<HidPort> port,
    std::shared_ptr<HidListener> listener, std::size_t reportSize);
  ~HidReader();
  HidReader(const HidReader&) = delete;
  HidReader& operator=(const HidReader&) = delete;

  bool connected() const noexcept;
  std::uint64_t disconnections() const noexcept;
  /// The state as text: "connected", "unplugged, waiting for it to return", or the reason why a
  /// device that was plugged in again is not used.
  std::string status() const;

private:
  struct Shared;
  std::shared_ptr<Shared> Work;
  BoundedThread Thread;
};

/// Returns the entry of the bus for the same device as `entry`. Its path is empty if there is no
/// such device.
PALPATE_EXPORT HidEntry findAgain(HidBus& bus, const HidEntry& entry);
} // namespace palpate

#endif

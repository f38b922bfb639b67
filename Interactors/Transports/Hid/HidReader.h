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
/// Receives the events of a HidReader, in the reader's thread.
class PALPATE_EXPORT HidListener
{
public:
  virtual ~HidListener() = default;
  /// Called when a device has returned and is open on `port`. Returns the reason why it must not be
  /// used; empty if it may be used.
  virtual std::string returned(HidPort& port, const HidEntry& entry) = 0;
  virtual void received(const std::uint8_t* report, std::size_t size) noexcept = 0;
  virtual void lost() noexcept = 0;
};

/**
 * Reads a HID device in a separate thread, and waits for its return after it has been unplugged.
 *
 * The device may return with another path. It is recognised by vendor, product and serial number
 * (without a serial number by vendor and product; the old path is preferred). The search runs four
 * times a second. The destructor waits at most a second, even if the driver hangs.
 */
class PALPATE_EXPORT HidReader
{
public:
  /// `port` is open on `entry`. Reports are read with at most `reportSize` bytes.
  HidReader(HidBus& bus, HidEntry entry, std::unique_ptr<HidPort> port,
    std::shared_ptr<HidListener> listener, std::size_t reportSize);
  ~HidReader();
  HidReader(const HidReader&) = delete;
  HidReader& operator=(const HidReader&) = delete;

  bool connected() const noexcept;
  std::uint64_t disconnections() const noexcept;
  /// The state as text: "connected", "unplugged, waiting for it to return", or the reason why the
  /// returned device is not used again.
  std::string status() const;

private:
  struct Shared;
  std::shared_ptr<Shared> Work;
  BoundedThread Thread;
};

/// The entry of the bus for the same device as `entry`; its path is empty if there is none.
PALPATE_EXPORT HidEntry findAgain(HidBus& bus, const HidEntry& entry);
} // namespace palpate

#endif

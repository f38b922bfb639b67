// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BridgeSocket_h
#define palpate_BridgeSocket_h

#include "Mechanics/PalpateExport.h"

#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace palpate
{
/**
 * The host's end of a local datagram socket to the program of one device. It never waits for the
 * program.
 *
 * The address is "unix:/PATH" if the program has bound a Unix datagram socket to exactly this path,
 * or "udp:PORT" if the program has bound 127.0.0.1:PORT. No data leave or enter this machine. The
 * host's socket has an address of its own, to which the program answers. The socket is not
 * connected, so that datagrams reach a restarted program.
 */
class PALPATE_EXPORT BridgeSocket
{
public:
  /// Opens a socket. If the address is invalid or the system refuses the socket, returns null and
  /// sets `error` to the reason.
  static std::unique_ptr<BridgeSocket> open(const std::string& address, std::string& error);
  ~BridgeSocket();
  BridgeSocket(const BridgeSocket&) = delete;
  BridgeSocket& operator=(const BridgeSocket&) = delete;

  /// Sends a datagram without waiting. Returns false if there is no receiver, or if the receiver's
  /// buffer is full.
  bool send(const std::uint8_t* bytes, std::size_t size) noexcept;

  enum class Arrival : std::uint8_t
  {
    None,
    Datagram,
    Foreign ///< the datagram is from another sender; its bytes must not be used
  };
  /// Receives a datagram without waiting. Before the call, `size` must be the size of the buffer.
  /// After the call, `size` is the size of the datagram, which may be larger.
  Arrival receive(std::uint8_t* bytes, std::size_t& size) noexcept;

  /// Waits at most `milliseconds` for a datagram. Must not be called from the servo tick.
  void wait(int milliseconds) noexcept;

private:
  union Address
  {
    sockaddr any;
    sockaddr_un local;
    sockaddr_in internet;
    sockaddr_storage space;
  };
  struct Name
  {
    Address address{};
    socklen_t size = 0;
  };
  static std::string parse(const std::string& text, Name& peer, Name& own);
  BridgeSocket(int file, const Name& peer);
  bool isPeer(const Address& sender, socklen_t size) const noexcept;

  int File;
  Name Peer;
};
} // namespace palpate

#endif

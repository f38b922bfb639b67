// SPDX-License-Identifier: BSD-3-Clause
#include "Transports/Bridge/BridgeSocket.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <system_error>

namespace palpate
{
namespace
{
sockaddr_in loopback(std::uint16_t port)
{
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(port);
  return address;
}

/// Returns the port number, or 0 if the text is invalid.
std::uint16_t portOf(const std::string& text)
{
  if (text.empty() || text.size() > 5 || text.find_first_not_of("0123456789") != std::string::npos)
  {
    return 0;
  }
  const int port = std::stoi(text);
  return port <= 65535 ? static_cast<std::uint16_t>(port) : std::uint16_t{ 0 };
}

std::string lastError()
{
  return std::error_code(errno, std::system_category()).message();
}
} // namespace

/// Returns "" if `text` is a valid address, else the reason why it is not. Sets `peer` to the
/// address of the program, and `own` to the address of the host's end, which is any free name.
std::string BridgeSocket::parse(const std::string& text, Name& peer, Name& own)
{
  const std::string what = "'" + text + "': ";
  const std::size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  const std::string rest = colon == std::string::npos ? std::string() : text.substr(colon + 1);
  if (kind == "unix" && colon != std::string::npos)
  {
    if (rest.empty() || rest.front() != '/')
    {
      return what + "the path of a Unix socket must begin with '/'";
    }
    if (rest.size() >= sizeof peer.address.local.sun_path)
    {
      return what + "the path of a Unix socket has at most " +
        std::to_string(sizeof peer.address.local.sun_path - 1) + " bytes, this one " +
        std::to_string(rest.size());
    }
    peer.address.local.sun_family = AF_UNIX;
    std::memcpy(static_cast<char*>(peer.address.local.sun_path), rest.data(), rest.size());
    peer.size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + rest.size() + 1);
    own.address.local.sun_family = AF_UNIX;
    own.size = sizeof(sa_family_t); // Linux chooses an abstract name
    return {};
  }
  if (kind == "udp" && colon != std::string::npos)
  {
    const std::uint16_t port = portOf(rest);
    if (port == 0)
    {
      return what + "a port is a number from 1 to 65535";
    }
    const sockaddr_in there = loopback(port);
    const sockaddr_in here = loopback(0);
    std::memcpy(&peer.address, &there, sizeof there);
    std::memcpy(&own.address, &here, sizeof here);
    peer.size = own.size = sizeof there;
    return {};
  }
  return what + "is neither unix:/PATH nor udp:PORT";
}

std::unique_ptr<BridgeSocket> BridgeSocket::open(const std::string& address, std::string& error)
{
  Name peer;
  Name own;
  error = parse(address, peer, own);
  if (!error.empty())
  {
    return nullptr;
  }
  const int file = socket(peer.address.any.sa_family, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (file < 0 || bind(file, &own.address.any, own.size) != 0)
  {
    error = "'" + address + "': no socket: " + lastError();
    if (file >= 0)
    {
      close(file);
    }
    return nullptr;
  }
  return std::unique_ptr<BridgeSocket>(new BridgeSocket(file, peer));
}

BridgeSocket::BridgeSocket(int file, const Name& peer)
  : File(file)
  , Peer(peer)
{
}

BridgeSocket::~BridgeSocket()
{
  close(this->File);
}

bool BridgeSocket::send(const std::uint8_t* bytes, std::size_t size) noexcept
{
  return sendto(this->File, bytes, size, MSG_DONTWAIT | MSG_NOSIGNAL, &this->Peer.address.any,
           this->Peer.size) == static_cast<ssize_t>(size);
}

BridgeSocket::Arrival BridgeSocket::receive(std::uint8_t* bytes, std::size_t& size) noexcept
{
  Address sender{};
  socklen_t length = sizeof sender;
  const ssize_t count =
    recvfrom(this->File, bytes, size, MSG_DONTWAIT | MSG_TRUNC, &sender.any, &length);
  if (count < 0)
  {
    return Arrival::None;
  }
  size = static_cast<std::size_t>(count);
  return this->isPeer(sender, length) ? Arrival::Datagram : Arrival::Foreign;
}

bool BridgeSocket::isPeer(const Address& sender, socklen_t size) const noexcept
{
  if (size < sizeof(sa_family_t) || sender.any.sa_family != this->Peer.address.any.sa_family)
  {
    return false;
  }
  if (sender.any.sa_family == AF_INET)
  {
    return sender.internet.sin_port == this->Peer.address.internet.sin_port &&
      sender.internet.sin_addr.s_addr == this->Peer.address.internet.sin_addr.s_addr;
  }
  // The unused bytes of the program's name are zero. Therefore a sender without a path or with an
  // abstract name compares as different.
  return std::strncmp(static_cast<const char*>(sender.local.sun_path),
           static_cast<const char*>(this->Peer.address.local.sun_path),
           sizeof sender.local.sun_path) == 0;
}

void BridgeSocket::wait(int milliseconds) noexcept
{
  pollfd ready{ this->File, POLLIN, 0 };
  poll(&ready, 1, milliseconds);
}
} // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_BridgePeer_h
#define palpate_testing_BridgePeer_h

#include "Transports/Hid/HapticReport.h"

#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

namespace palpate::testing
{
/// A temporary folder for sockets. Its name is short, because paths of sockets must be short. It is
/// removed at the end.
class SocketFolder
{
public:
  SocketFolder()
  {
    if (mkdtemp(this->Path.data()) == nullptr)
    {
      throw std::runtime_error("no folder " + this->Path);
    }
  }
  ~SocketFolder() { rmdir(this->Path.c_str()); }
  SocketFolder(const SocketFolder&) = delete;
  SocketFolder& operator=(const SocketFolder&) = delete;
  std::string socket(const std::string& name) const { return this->Path + "/" + name; }

private:
  std::string Path = ::testing::TempDir() + "palpate-XXXXXX";
};

/// A device's program at its socket, which the test controls step by step.
class BridgePeer
{
public:
  /// Binds "unix:/PATH", or "udp:PORT" of the loopback address; udp:0 takes a free port.
  explicit BridgePeer(const std::string& address)
    : Unix(address.rfind("unix:", 0) == 0)
    , File(socket(this->Unix ? AF_UNIX : AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0))
  {
    Any own{};
    socklen_t size = sizeof own.udp;
    if (this->Unix)
    {
      this->Path = address.substr(5);
      own.local.sun_family = AF_UNIX;
      std::memcpy(own.local.sun_path, this->Path.data(), this->Path.size());
      size = sizeof own.local;
      unlink(this->Path.c_str());
    }
    else
    {
      own.udp.sin_family = AF_INET;
      own.udp.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
      own.udp.sin_port = htons(static_cast<std::uint16_t>(std::stoi(address.substr(4))));
    }
    if (bind(this->File, &own.any, size) != 0)
    {
      throw std::runtime_error("cannot bind " + address);
    }
    getsockname(this->File, &own.any, &size);
    this->Name = this->Unix ? address : "udp:" + std::to_string(ntohs(own.udp.sin_port));
  }
  ~BridgePeer()
  {
    close(this->File);
    if (this->Unix)
    {
      unlink(this->Path.c_str());
    }
  }
  BridgePeer(const BridgePeer&) = delete;
  BridgePeer& operator=(const BridgePeer&) = delete;

  const std::string& address() const { return this->Name; }

  /// Receives the next datagram; its sender becomes the host. Returns its size, or -1.
  long receive(HapticReportBytes& bytes)
  {
    Any from{};
    socklen_t size = sizeof from;
    const long count =
      recvfrom(this->File, bytes.data(), bytes.size(), MSG_DONTWAIT, &from.any, &size);
    if (count >= 0)
    {
      this->Host = from;
      this->HostSize = size;
    }
    return count;
  }
  void send(const std::uint8_t* bytes, std::size_t size)
  {
    sendto(this->File, bytes, size, MSG_DONTWAIT, &this->Host.any, this->HostSize);
  }
  /// From now on, sends to the host of another peer.
  void imitate(const BridgePeer& other)
  {
    this->Host = other.Host;
    this->HostSize = other.HostSize;
  }

private:
  union Any
  {
    sockaddr any;
    sockaddr_un local;
    sockaddr_in udp;
  };
  bool Unix;
  int File;
  std::string Path;
  std::string Name;
  Any Host{};
  socklen_t HostSize = 0;
};
} // namespace palpate::testing

#endif

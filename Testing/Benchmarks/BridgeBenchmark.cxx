// SPDX-License-Identifier: BSD-3-Clause
// The delay of a bridge, from a written force to the first state that acknowledges it, at 1 kHz.
// BridgeDevice communicates over a Unix and a UDP socket with a program that answers immediately.
// For comparison, the same run measures 64 bytes sent and returned over a plain socket of the same
// kind. See README.md.
#include "Transports/Bridge/BridgeDevice.h"
#include "Haptics/Servo/RealTimeGrant.h"

#include <CLI/CLI.hpp>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace
{
using namespace palpate;
using Clock = std::chrono::steady_clock;
constexpr int WarmUp = 100;

union Name
{
  sockaddr any;
  sockaddr_un local;
  sockaddr_in udp;
};

/// A bound datagram socket with its program: a thread answers each datagram immediately.
class Answering
{
public:
  /// An empty `path` selects UDP on a free port of the loopback address.
  Answering(const std::string& path, bool bare)
    : Path(path)
    , Bare(bare)
    , File(socket(path.empty() ? AF_INET : AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0))
  {
    this->Own.any.sa_family = path.empty() ? AF_INET : AF_UNIX;
    this->Size = path.empty() ? sizeof this->Own.udp : sizeof this->Own.local;
    if (path.empty())
    {
      this->Own.udp.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    }
    else
    {
      std::memcpy(this->Own.local.sun_path, path.data(), path.size());
    }
    if (bind(this->File, &this->Own.any, this->Size) != 0)
    {
      std::perror("palpateBridgeBenchmark: bind");
      std::exit(1);
    }
    getsockname(this->File, &this->Own.any, &this->Size);
    this->Thread = std::thread([this] { this->run(); });
  }
  ~Answering()
  {
    this->Stopping = true;
    this->Thread.join();
    close(this->File);
    unlink(this->Path.c_str());
  }
  Answering(const Answering&) = delete;
  Answering& operator=(const Answering&) = delete;

  const Name& name() const { return this->Own; }
  socklen_t size() const { return this->Size; }
  std::string address() const
  {
    return this->Path.empty() ? "udp:" + std::to_string(ntohs(this->Own.udp.sin_port))
                              : "unix:" + this->Path;
  }

private:
  void run()
  {
    while (!this->Stopping)
    {
      pollfd ready{ this->File, POLLIN, 0 };
      HapticReportBytes bytes{};
      Name from{};
      socklen_t size = sizeof from;
      if (poll(&ready, 1, 50) <= 0 ||
        recvfrom(this->File, bytes.data(), bytes.size(), MSG_DONTWAIT, &from.any, &size) < 0)
      {
        continue;
      }
      const auto send = [&]
      { sendto(this->File, bytes.data(), bytes.size(), MSG_DONTWAIT, &from.any, size); };
      HelloReport hello;
      if (!this->Bare && parse(bytes.data(), bytes.size(), hello) == ReportDefect::None)
      {
        describe(hello.nonce, bytes);
        send();
      }
      if (!this->Bare)
      {
        this->answer(bytes);
      }
      send();
    }
  }
  static void describe(std::uint32_t nonce, HapticReportBytes& bytes)
  {
    DescriptionReport description;
    description.maximumForce = 1.0;
    description.maximumStiffness = 1000.0;
    description.maximumForceRate = 1000.0;
    description.maximumDamping = 1.0;
    description.workspace.setConstant(0.1);
    description.rate = 1000.0;
    description.sampleTimeOut = 0.1;
    description.nonce = nonce;
    pack(description, bytes);
  }
  void answer(HapticReportBytes& bytes)
  {
    ForceReport force;
    parse(bytes.data(), bytes.size(), force);
    StateReport state;
    state.sequence = ++this->Sequence;
    state.amplifiersOn = force.enable;
    state.forceSequence = force.sequence;
    state.position = force.force;
    pack(state, bytes);
  }

  std::string Path;
  bool Bare;
  int File;
  Name Own{};
  socklen_t Size = 0;
  std::uint32_t Sequence = 0;
  std::atomic<bool> Stopping{ false };
  std::thread Thread;
};

struct Times
{
  std::vector<double> microseconds;
  int unanswered = 0;
};

/// Calls `send` at 1 kHz. After each call, calls `arrived` until it returns true, for at most one
/// period.
template <class Send, class Arrived>
Times measure(int ticks, const Send& send, const Arrived& arrived)
{
  Times times;
  auto deadline = Clock::now();
  for (int i = 0; i < ticks + WarmUp; ++i)
  {
    deadline = std::max(deadline + std::chrono::milliseconds(1), Clock::now());
    std::this_thread::sleep_until(deadline);
    const auto begin = Clock::now();
    send(i);
    bool back = false;
    while (!back && Clock::now() < begin + std::chrono::milliseconds(1))
    {
      back = arrived(i);
    }
    if (i < WarmUp)
    {
      continue;
    }
    if (back)
    {
      times.microseconds.push_back(
        std::chrono::duration<double, std::micro>(Clock::now() - begin).count());
    }
    else
    {
      ++times.unanswered;
    }
  }
  std::sort(times.microseconds.begin(), times.microseconds.end());
  return times;
}

Times throughBridge(const std::string& path, int ticks)
{
  const Answering program(path, false);
  std::string error;
  const auto device = BridgeDevice::open(program.address(), error);
  if (!device)
  {
    std::fprintf(stderr, "palpateBridgeBenchmark: %s\n", error.c_str());
    std::exit(1);
  }
  const auto seconds = [begin = Clock::now()]
  { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  while (!device->read(seconds()).valid) // the state comes with the second greeting
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return measure(
    ticks,
    [&](int i) {
      device->write({ 1e-3 * (i % 512), 0.0, 0.0 });
    },
    [&](int)
    {
      const DeviceSample sample = device->read(seconds());
      return sample.valid && sample.fresh;
    });
}

Times bare(const std::string& path, int ticks)
{
  const Answering program(path, true);
  const int file = socket(program.name().any.sa_family, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  Name own{};
  own.any.sa_family = program.name().any.sa_family;
  if (path.empty())
  {
    own.udp.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  }
  bind(file, &own.any, path.empty() ? sizeof own.udp : sizeof(sa_family_t));
  std::array<char, HapticReportSize> bytes{};
  const Times times = measure(
    ticks,
    [&](int) {
      sendto(file, bytes.data(), bytes.size(), MSG_DONTWAIT, &program.name().any, program.size());
    },
    [&](int) { return recv(file, bytes.data(), bytes.size(), MSG_DONTWAIT) > 0; });
  close(file);
  return times;
}

struct Row
{
  std::string way;
  Times times;
};

double at(const std::vector<double>& sorted, double share)
{
  return sorted.empty()
    ? 0.0
    : sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

bool writeCsv(const std::string& path, const std::vector<Row>& rows)
{
  std::ofstream file(path);
  file << "way,median_us,p99_us,p999_us,max_us,answered,unanswered\n";
  for (const Row& row : rows)
  {
    const std::vector<double>& all = row.times.microseconds;
    file << row.way << ',' << at(all, 0.5) << ',' << at(all, 0.99) << ',' << at(all, 0.999) << ','
         << at(all, 1.0) << ',' << all.size() << ',' << row.times.unanswered << '\n';
  }
  file.close();
  return file.good();
}
} // namespace

int main(int argc, char* argv[])
{
  std::string output = ".";
  double seconds = 5.0;
  CLI::App app{ "What a bridge adds: there and back at 1 kHz.", "palpateBridgeBenchmark" };
  app.add_option("--output", output, "folder for bridge.csv")->check(CLI::ExistingDirectory);
  app.add_option("--seconds", seconds, "per row")->check(CLI::Range(0.1, 600.0));
  CLI11_PARSE(app, argc, argv);

  std::string folder = (std::filesystem::temp_directory_path() / "palpate-XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr)
  {
    std::perror("palpateBridgeBenchmark: no folder for a socket");
    return 1;
  }
  std::printf("There and back at 1 kHz, µs: %s\n", requestRealTime({ 80 }).describe().c_str());
  const int ticks = static_cast<int>(1000.0 * seconds);
  const std::string path = folder + "/s";
  const std::vector<Row> rows{ { "unix bare socket", bare(path, ticks) },
    { "unix bridge", throughBridge(path, ticks) }, { "udp bare socket", bare("", ticks) },
    { "udp bridge", throughBridge("", ticks) } };
  std::filesystem::remove(folder);
  std::printf("%-18s %8s %8s %8s %8s %9s %11s\n", "", "median", "p99", "p99.9", "max", "answered",
    "unanswered");
  for (const Row& row : rows)
  {
    const std::vector<double>& all = row.times.microseconds;
    std::printf("%-18s %8.1f %8.1f %8.1f %8.1f %9zu %11d\n", row.way.c_str(), at(all, 0.5),
      at(all, 0.99), at(all, 0.999), at(all, 1.0), all.size(), row.times.unanswered);
  }
  const std::string csv = (std::filesystem::path(output) / "bridge.csv").string();
  if (!writeCsv(csv, rows))
  {
    std::fprintf(stderr, "palpateBridgeBenchmark: cannot write '%s'\n", csv.c_str());
    return 1;
  }
  std::printf("results in %s\n", csv.c_str());
  return 0;
}

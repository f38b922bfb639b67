// SPDX-License-Identifier: BSD-3-Clause
// Arbitrary bytes as a body file, also with a correct checksum. The file is rejected with a reason,
// or gives a body on which a tick can run. Input: a choice (bit 0: correct the checksum), the file,
// and tips, which are read from the end.
#include "AnyTips.h"
#include "Contact/FlatBodyFile.h"
#include "MemoryFile.h"

#include <cstring>
#include <vector>

using namespace palpate;
using namespace palpate::testing;

namespace
{
constexpr std::size_t HeaderSizes[] = { 408, 416, 456, 560, 616 };
constexpr std::size_t SizeAt = 16; // offset of the file size in the header, see FlatBodyHeader.h
constexpr std::size_t ChecksumAt = 24;
constexpr std::size_t CountsAt = 32;
constexpr std::size_t OffsetsAt = 64;
constexpr std::size_t BranchesAt = 456;
constexpr std::size_t LaterOffsetsAt = 544;
constexpr std::size_t CouplingAt = 560;
constexpr std::size_t CouplingOffsetsAt = 584;

std::uint64_t wordAt(const std::vector<std::uint8_t>& bytes, std::size_t place)
{
  std::uint64_t word = 0;
  std::memcpy(&word, bytes.data() + place, sizeof word);
  return word;
}

void mix(std::uint64_t& sum, std::uint64_t word)
{
  sum = (sum ^ word) * 0x100000001b3ULL;
  sum ^= sum >> 32;
}

void add(
  std::uint64_t& sum, const std::vector<std::uint8_t>& bytes, std::size_t begin, std::size_t count)
{
  std::size_t i = 0;
  for (; i + 8 <= count; i += 8)
  {
    mix(sum, wordAt(bytes, begin + i));
  }
  for (; i < count; ++i)
  {
    mix(sum, bytes[begin + i]);
  }
}

/// Corrects size and checksum, so that the file is read. Does not change a file whose sections do
/// not fit, because the reader rejects it for that reason.
void mend(std::vector<std::uint8_t>& bytes)
{
  const std::uint64_t size = bytes.size();
  std::memcpy(bytes.data() + SizeAt, &size, sizeof size);
  std::memset(bytes.data() + ChecksumAt, 0, 8);
  const std::uint64_t n = wordAt(bytes, CountsAt);
  const std::uint64_t triangles = wordAt(bytes, CountsAt + 8);
  const std::uint64_t samples = wordAt(bytes, CountsAt + 16) & 0xffffffffU;
  const std::uint64_t laws = wordAt(bytes, CountsAt + 16) >> 32;
  if (n > size || triangles > size || samples > size || laws > size)
  {
    return;
  }
  const std::uint64_t version = wordAt(bytes, 8) & 0xffffffffU;
  const std::size_t header = version >= 1 && version <= 5 ? HeaderSizes[version - 1] : size + 1;
  if (header > size)
  {
    return;
  }
  const std::uint64_t relaxation = version < 4 ? 0 : wordAt(bytes, BranchesAt);
  const std::uint64_t branches = relaxation & 0xffU;
  const std::uint64_t parts = relaxation >> 32;
  const std::uint64_t coupling = version < 5 ? 0 : wordAt(bytes, CouplingAt);
  const std::uint64_t modes = (coupling >> 32) & 0xffU;
  const std::uint64_t curves = laws > 0 ? 0 : 4 * n * samples;
  const std::uint64_t sizes[] = { 24 * n, 12 * triangles, curves, curves, 8 * laws * samples,
    4 * n * laws, 12 * n, 4 * n, n, 4 * n, n, (parts & 1U) != 0 ? 4 * n * branches : 0,
    (parts & 2U) != 0 ? 4 * n : 0, (coupling & 1U) != 0 ? std::uint64_t{ 79 * 24 } : 0,
    (coupling & 2U) != 0 ? 4 * n : 0, (coupling & 4U) != 0 ? 4 * n : 0, 4 * n * modes };
  std::uint64_t sum = 0xcbf29ce484222325ULL;
  add(sum, bytes, 0, header);
  for (std::size_t k = 0; k < 17; ++k)
  {
    const std::size_t place = k < 11 ? OffsetsAt + 8 * k
      : k < 13                       ? LaterOffsetsAt + 8 * (k - 11)
                                     : CouplingOffsetsAt + 8 * (k - 13);
    const std::uint64_t offset = sizes[k] == 0 ? 0 : wordAt(bytes, place);
    if (offset > size || sizes[k] > size - offset)
    {
      return;
    }
    add(sum, bytes, offset, sizes[k]);
  }
  std::memcpy(bytes.data() + ChecksumAt, &sum, sizeof sum);
}
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size == 0)
  {
    return 0;
  }
  std::vector<std::uint8_t> bytes(data + 1, data + size);
  if ((data[0] & 1U) != 0 && bytes.size() >= HeaderSizes[0])
  {
    mend(bytes);
  }
  static MemoryFile memory;
  memory.hold(bytes.data(), bytes.size());
  FlatBodyFile file;
  const std::string error = file.open(memory.path());
  if (!error.empty())
  {
    require(file.body().points == 0 && file.body().coordinates == nullptr,
      "of a file that is refused nothing is held");
    return 0;
  }
  const std::shared_ptr<const ContactBody> body = makeContactBody(file.body());
  FuzzedDataProvider tips(data, size);
  feelAround(*body, file.body().triangles, tips);
  return 0;
}

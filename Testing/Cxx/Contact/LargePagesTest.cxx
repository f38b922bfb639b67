// SPDX-License-Identifier: BSD-3-Clause
// Storing a body in large pages changes no result. The large pages can be seen only in
// /proc/self/smaps (proc(5)).
#include "BumpySphere.h"
#include "Contact/LargePages.h"
#include "Contact/PackedMesh.h"
#include "ProcessMemory.h"
#include "Sanitized.h"

#include <gtest/gtest.h>

#include <sys/mman.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <random>
#include <string>
#include <vector>

using namespace palpate;
using namespace palpate::testing;

TEST(LargePages, AreSharedByWhatIsSmaller)
{
  // Vectors are created and destroyed. Each keeps its content, whichever vector used its page
  // before.
  std::mt19937 random(1);
  std::vector<LargeVector<std::uint32_t>> held(40);
  for (int turn = 0; turn < 4000; ++turn)
  {
    const std::size_t i = random() % held.size();
    for (const std::uint32_t value : held[i])
    {
      ASSERT_EQ(value, i);
    }
    const std::size_t count = std::size_t{ 1 } << random() % 20;
    held[i] = LargeVector<std::uint32_t>(count + random() % count, static_cast<std::uint32_t>(i));
    ASSERT_EQ(reinterpret_cast<std::uintptr_t>(held[i].data()) % 64, 0U);
  }
}

// A sanitizer has its own malloc with ordinary pages and may keep freed memory.
#ifndef PALPATE_SANITIZED
namespace
{
constexpr std::size_t Page = std::size_t{ 1 } << 21;

/// Bytes in large pages in the mapping that contains an address, or -1 if the system does not
/// report it.
double largeBytesAround(const void* address)
{
  const auto place = reinterpret_cast<std::uintptr_t>(address);
  std::ifstream maps("/proc/self/smaps");
  const std::string label = "AnonHugePages:";
  bool isThere = false;
  std::string line;
  while (std::getline(maps, line))
  {
    unsigned long first = 0;
    unsigned long last = 0;
    if (std::sscanf(line.c_str(), "%lx-%lx ", &first, &last) == 2)
    {
      isThere = first <= place && place < last;
    }
    else if (isThere && line.rfind(label, 0) == 0)
    {
      return 1024.0 * std::stod(line.substr(label.size()));
    }
  }
  return -1.0;
}

/// Bytes in large pages that the system gives for a plain request.
double granted()
{
  constexpr std::size_t bytes = 8 * Page;
  void* const memory =
    mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  EXPECT_NE(memory, MAP_FAILED);
  madvise(memory, bytes, MADV_HUGEPAGE);
  for (std::size_t at = 0; at < bytes; at += 4096)
  {
    static_cast<volatile char*>(memory)[at] = 1;
  }
  const double large = largeBytesAround(memory);
  munmap(memory, bytes);
  return large;
}

std::string wordsOfTheSystem()
{
  std::ifstream file("/sys/kernel/mm/transparent_hugepage/enabled");
  std::string words;
  return std::getline(file, words) ? words : "it has no such setting";
}
} // namespace

TEST(LargePages, HoldABodyWhereTheSystemHasThem)
{
  // The arrays of 204800 triangles have their own pages; those of 12800 triangles share pages.
  for (const int cuts : { 160, 40 })
  {
    const Surface surface = bumpySphere(cuts);
    const PackedMesh mesh = surface.packed();
    const double large = largeBytesAround(mesh.coordinates(0));
    if (granted() < 7.0 * static_cast<double>(Page))
    {
      std::cout << "No large pages on this system, so none for a body: transparent_hugepage says "
                << wordsOfTheSystem() << ", and who asks for 16 MiB of them gets " << granted()
                << " bytes\n";
      return;
    }
    // 64 bytes per triangle; one page may be missing.
    const double whole = 64.0 * static_cast<double>(mesh.triangleCount());
    EXPECT_GE(large, std::max(whole - 2.0 * static_cast<double>(Page), static_cast<double>(Page)));
  }
}

TEST(LargePages, GoBackWhenNobodyIsLeft)
{
  const double before = residentMemory();
  for (int turn = 0; turn < 200; ++turn)
  {
    LargeVector<char> first(1500000, 'a');
    LargeVector<char> second(1500000, 'b'); // needs a different page
    LargeVector<char> third(400000, 'c');
    first = LargeVector<char>();
  }
  EXPECT_LT(residentMemory() - before, 2e7); // after 200 repetitions with two pages each
}
#endif // PALPATE_SANITIZED

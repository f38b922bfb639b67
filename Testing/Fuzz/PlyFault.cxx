// SPDX-License-Identifier: BSD-3-Clause
// Arbitrary bytes as a .ply file: checked in bounded time and memory. A file without a header is
// rejected.
#include "Contact/MeshFiles/PlyFault.h"
#include "Require.h"

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string text(reinterpret_cast<const char*>(data), size);
  std::istringstream file(text);
  const std::string fault = palpate::plyFault(file);
  palpate::testing::require(!fault.empty() ||
      (text.find("end_header") != std::string::npos && text.find("vertex") != std::string::npos),
    "a file without a header is refused");
  return 0;
}

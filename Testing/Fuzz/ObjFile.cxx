// SPDX-License-Identifier: BSD-3-Clause
// Arbitrary text as an .obj file: gives an error that names a line, or polygons of existing points.
#include "Contact/MeshFiles/ObjFile.h"
#include "MeshRequirements.h"

#include <sstream>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::istringstream file(std::string(reinterpret_cast<const char*>(data), size));
  palpate::testing::requireWhole(palpate::readObj(file));
  return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
// Arbitrary bytes as an .stl file, ASCII or binary: gives an error, or triangles of existing
// points.
#include "Contact/MeshFiles/StlFile.h"
#include "MeshRequirements.h"

#include <sstream>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::istringstream file(std::string(reinterpret_cast<const char*>(data), size));
  const palpate::FileMesh mesh = palpate::readStl(file);
  palpate::testing::requireWhole(mesh);
  palpate::testing::require(
    mesh.corners.size() == mesh.points.size() / 3, "a corner of a facet is a point of its own");
  return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_TestTools_h
#define palpate_testing_TestTools_h

#include "Mechanics/Tools/ToolSpecification.h"

#include <memory>
#include <stdexcept>
#include <string>

namespace palpate::testing
{
/// Makes a tool from its text on a command line. Throws (so that the test fails) if the text is
/// rejected.
inline std::unique_ptr<AxisymmetricTool> tool(const std::string& text)
{
  ToolSpecification specification;
  std::string error;
  if (!parseTool(text, specification, error))
  {
    throw std::invalid_argument(error);
  }
  return makeTool(specification);
}

/// E* of the rubber of Mahvash and Hayward 2002, MPa. Tables that state no modulus use it.
constexpr double Rubber = 3.45;
} // namespace palpate::testing

#endif

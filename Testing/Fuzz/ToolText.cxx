// SPDX-License-Identifier: BSD-3-Clause
// Arbitrary text as a tool, and as the file of a profile. The result is an error, or a tool with
// finite forces whose written form gives the same tool when it is read. Input: the first byte is 0
// for a specification, otherwise the input is a profile file; then follows the text.
#include "MemoryFile.h"
#include "Mechanics/Tools/ProfileFile.h"
#include "Require.h"
#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <cmath>
#include <memory>
#include <string>

using namespace palpate;
using namespace palpate::testing;

namespace
{
void press(const AxisymmetricTool& tool)
{
  for (const double deflection : { 0.0, 1e-6, 0.1, 2.0, 1e3 })
  {
    const double force = tool.force(deflection, 0.02);
    const double stiffness = tool.stiffness(deflection, 0.02);
    const bool answers = tool.checkDepth(deflection).empty();
    require(!answers || !(force < 0.0), "a force pushes out");
    require(!answers || !(stiffness < 0.0), "a deeper tool is pushed harder");
    tool.contactRadius(deflection);
  }
}

void tryTool(const ToolSpecification& specification)
{
  require(checkTool(specification).empty(), "what is read is a tool");
  const std::unique_ptr<AxisymmetricTool> tool = makeTool(specification);
  require(tool != nullptr, "a tool can be made");
  press(*tool);
  ToolSpecification again;
  std::string error;
  require(parseTool(tool->specification(), again, error), "a tool reads what it writes");
  require(makeTool(again)->specification() == tool->specification(), "and is the same");
}

void readSpecification(const std::string& text)
{
  // A fuzzer must not read files of the machine.
  const bool isFile = text.rfind("profile:", 0) == 0 && text.find(';') == std::string::npos;
  ToolSpecification specification;
  std::string error;
  if (!isFile && parseTool(text, specification, error))
  {
    tryTool(specification);
  }
  else if (!isFile)
  {
    require(!error.empty(), "a refusal has words");
  }
}

void readProfileFile(const std::string& text)
{
  static MemoryFile file;
  file.hold(text.data(), text.size());
  ToolSpecification specification;
  specification.Shape = ToolShape::Profile;
  const std::string error = readProfile(file.path(), specification.Profile);
  if (!error.empty())
  {
    require(specification.Profile.empty(), "after an error nothing is half-loaded");
    return;
  }
  if (checkTool(specification).empty())
  {
    tryTool(specification);
  }
}
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size > 0)
  {
    const std::string text(reinterpret_cast<const char*>(data + 1), size - 1);
    (data[0] == 0 || data[0] == '0') ? readSpecification(text) : readProfileFile(text);
  }
  return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
// Arbitrary words as the viewer's command line. The program ends with a reason, or continues with
// options that it can use. Input: the words, one per line. Files and devices are named but not
// opened.
#include "Contact/SettingTable.h"
#include "Transports/Bridge/BridgeSocket.h"
#include "Haptics/Simulation/SimulatedPlant.h"
#include "Require.h"
#include "Mechanics/Tools/ToolSpecification.h"
#include "ViewerOptions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using namespace palpate;
using palpate::testing::require;

namespace
{
/// Captures the text written to a stream during its lifetime.
class Caught
{
public:
  explicit Caught(std::ostream& stream)
    : Stream(stream)
    , Usual(stream.rdbuf(Text.rdbuf()))
  {
  }
  ~Caught() { this->Stream.rdbuf(this->Usual); }
  Caught(const Caught&) = delete;
  Caught& operator=(const Caught&) = delete;
  bool isEmpty() const { return this->Text.str().empty(); }

private:
  std::ostringstream Text;
  std::ostream& Stream;
  std::streambuf* Usual;
};

std::vector<std::string> wordsOf(const std::uint8_t* data, std::size_t size)
{
  std::vector<std::string> words = { "palpate" };
  std::istringstream stream(std::string(reinterpret_cast<const char*>(data), size));
  for (std::string line; std::getline(stream, line) && words.size() < 40;)
  {
    words.emplace_back(line.c_str()); // a word ends at its first zero byte
  }
  return words;
}

bool isPositive(double value)
{
  return std::isfinite(value) && value > 0.0;
}

bool isNotNegative(double value)
{
  return std::isfinite(value) && value >= 0.0;
}

bool areFinite(const std::optional<std::array<double, 3>>& place)
{
  return !place ||
    (std::isfinite((*place)[0]) && std::isfinite((*place)[1]) && std::isfinite((*place)[2]));
}

void checkTools(const std::vector<std::string>& tools)
{
  for (const std::string& text : tools)
  {
    ToolSpecification tool;
    std::string error;
    require(parseTool(text, tool, error), "a tool is one");
  }
}

void checkBody(const ViewerOptions& options)
{
  require(options.scene == "head" || options.scene == "cylinder", "the scene is known");
  require(!options.youngsModulus || isPositive(*options.youngsModulus), "a modulus");
  require(!options.poissonRatio || (*options.poissonRatio >= 0.0 && *options.poissonRatio <= 0.5),
    "Poisson's ratio");
  require(!options.layer || options.layer->scanned || isNotNegative(options.layer->thickness),
    "a thickness");
  require(!options.layer || !options.layer->isStack() || checkStack(options.layer->stack).empty(),
    "a stack of layers");
  require(isPositive(options.reach) && isNotNegative(options.voxel) &&
      isNotNegative(options.solidSpacing),
    "lengths of the body");
  require(
    options.lengthScale == 1.0 || options.lengthScale == 10.0 || options.lengthScale == 1000.0,
    "a unit of length is mm, cm or m");
  require(isNotNegative(options.resolution) && isNotNegative(options.closingRadius) &&
      std::isfinite(options.contourValue) && std::isfinite(options.baseValue),
    "numbers of a scan");
  checkTools(options.tools);
  std::set<double> labels;
  for (const TissueChoice& tissue : options.tissues)
  {
    require(
      std::isfinite(tissue.label) && labels.insert(tissue.label).second, "a label is given once");
    require(isPositive(tissue.youngsModulus), "the modulus of a tissue");
    require(tissue.poissonRatio >= 0.0 && tissue.poissonRatio <= 0.499, "its Poisson's ratio");
  }
  require(options.tissues.empty() || !options.body.empty(), "tissues are those of a file");
}

void checkTouch(const ViewerOptions& options)
{
  require(!options.depth || isPositive(*options.depth), "a depth");
  require(isPositive(options.maximumDeflection), "a range");
  require(areFinite(options.site) && areFinite(options.slideTo), "a place");
  require(options.rate >= 1.0 && options.rate <= 1e5, "a rate");
  require(!faultOfContact(options.contact), "the contact's settings are sound");
  require(isPositive(options.scale) && isPositive(options.tolerance), "scale and tolerance");
}

void checkTrial(const ViewerOptions& options)
{
  const std::size_t count = options.trial.size();
  require(count == 0 || (count >= 2 && count <= 26), "alternatives have letters");
  require(options.trialRounds >= 1 && options.trialRounds <= 10000, "rounds");
  std::set<std::string> names;
  for (const TrialChoice& choice : options.trial)
  {
    require(names.insert(choice.name).second, "no alternative is given twice");
    require(!faultOfContact(choice.contact), "an alternative's settings are sound");
    require(!choice.youngsModulus || isPositive(*choice.youngsModulus), "its modulus");
    require(!choice.layer || isNotNegative(choice.layer->thickness), "its layer");
    require(choice.tool.empty() ||
        std::count(options.tools.begin(), options.tools.end(), choice.tool) == 1,
      "its tool is one of the scene's");
  }
  require(count == 0 || !(options.compare || options.map), "one view at a time");
}

/// Opens a test socket for a valid address. Sends nothing.
void checkBridge(const std::string& device)
{
  const std::string kind = "bridge:";
  if (device.rfind(kind, 0) == 0)
  {
    std::string error;
    const auto socket = BridgeSocket::open(device.substr(kind.size()), error);
    require((socket == nullptr) == !error.empty(), "a refused address has words");
  }
  const std::string plant = "plant:";
  if (device.rfind(plant, 0) == 0)
  {
    HeldPlant held;
    readPlant(device.substr(plant.size()), held);
    require(fault(held).empty(), "a plant that was read has its settings in range");
  }
}
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::vector<std::string> words = wordsOf(data, size);
  std::vector<char*> arguments;
  for (std::string& word : words)
  {
    if (word.find("profile:") != std::string::npos)
    {
      return 0; // a fuzzer must not read files of the machine; ToolText covers profiles
    }
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);

  ViewerOptions options;
  const Caught output(std::cout);
  const Caught errors(std::cerr);
  const auto exitCode = readCommandLine(static_cast<int>(words.size()), arguments.data(), options);
  if (exitCode)
  {
    require(*exitCode == 0 ? !output.isEmpty() : !errors.isEmpty(), "the program says why it ends");
    return 0;
  }
  require(output.isEmpty() && errors.isEmpty(), "the program goes on without a word");
  checkBody(options);
  checkTouch(options);
  checkTrial(options);
  checkBridge(options.device);
  return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
// Arbitrary text as a file of measured curves. The result is an error that names a line, or curves
// that are finite, in the order of time, and can be split into loadings.
#include "Identification/CurvePreparation.h"
#include "Identification/CurvesFile.h"
#include "Require.h"

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace palpate;
using palpate::testing::require;

namespace
{
bool areFinite(const std::vector<double>& numbers)
{
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

void checkCurve(const MeasuredCurve& curve)
{
  const std::size_t count = curve.deflection.size();
  require(count > 0 && curve.force.size() == count, "a curve has a force per deflection");
  require(curve.time.empty() || curve.time.size() == count, "a time per reading, or none");
  require(curve.phase.empty() || curve.phase.size() == count, "a phase per reading, or none");
  require(curve.position.allFinite() && areFinite(curve.deflection) && areFinite(curve.force) &&
      areFinite(curve.time),
    "readings are finite");
  require(std::is_sorted(curve.time.begin(), curve.time.end()), "time does not decrease");
}
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::istringstream stream(std::string(reinterpret_cast<const char*>(data), size));
  MeasuredCurves curves;
  const std::string error = readCurves(stream, "fuzz", curves);
  if (!error.empty())
  {
    require(error.rfind("fuzz", 0) == 0, "an error names the file");
    require(curves.curves.empty() && curves.file.empty(), "after an error nothing is half-loaded");
    return 0;
  }
  require(!curves.curves.empty(), "a file without curves is an error");
  require(checkTool(curves.tool).empty(), "the tool is one");
  for (const MeasuredCurve& curve : curves.curves)
  {
    checkCurve(curve);
    PreparedCurve prepared;
    prepareCurve(curve, {}, prepared);
    for (const LoadingBranch& load : prepared.loads)
    {
      require(load.deflection.size() == load.force.size(), "a loading has a force per deflection");
    }
  }
  return 0;
}

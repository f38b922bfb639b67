// SPDX-License-Identifier: BSD-3-Clause
#include "ResponseLaw.h"

#include "AxisymmetricTool.h"
#include "SeriesCompliance.h"

#include <algorithm>
#include <limits>

namespace palpate
{
namespace
{
constexpr int ErrorProbes = 200;

struct FloatCurve
{
  const std::vector<float>& forces;
  const std::vector<float>& stiffnesses;
  double force(int i) const { return static_cast<double>(forces[static_cast<std::size_t>(i)]); }
  double stiffness(int i) const
  {
    return static_cast<double>(stiffnesses[static_cast<std::size_t>(i)]);
  }
};
} // namespace

ResponseLaw::ResponseLaw(const AxisymmetricTool& tool, double range, int samples)
  : Tool(tool)
  , Range(range)
  , Samples(samples)
{
  const ResponseSampling sampling(samples, tool.forceExponent());
  for (int i = 0; i < samples; ++i)
  {
    const double depth = sampling.depth(i, range);
    this->UnitForce.push_back(tool.force(depth, 1.0));
    this->UnitStiffness.push_back(tool.stiffness(depth, 1.0));
  }
}

void ResponseLaw::sample(double reducedModulus, float* force, float* stiffness) const
{
  for (int i = 0; i < this->Samples; ++i)
  {
    const auto k = static_cast<std::size_t>(i);
    force[i] = static_cast<float>(reducedModulus * this->UnitForce[k]);
    stiffness[i] = static_cast<float>(reducedModulus * this->UnitStiffness[k]);
  }
}

bool ResponseLaw::sampleSeries(
  double reducedModulus, double compliance, float* force, float* stiffness) const
{
  const ResponseSampling sampling(this->Samples, 1.0);
  for (int i = 0; i < this->Samples; ++i)
  {
    const SeriesPoint point =
      seriesResponse(this->Tool, reducedModulus, compliance, sampling.depth(i, this->Range));
    if (!point.stable)
    {
      std::fill_n(force, this->Samples, 0.0F);
      std::fill_n(stiffness, this->Samples, 0.0F);
      return false;
    }
    force[i] = static_cast<float>(point.force);
    stiffness[i] = static_cast<float>(point.stiffness);
  }
  return true;
}

double ResponseLaw::totalDeflection(
  double reducedModulus, double compliance, double localDepth) const
{
  return localDepth + compliance * this->Tool.force(localDepth, reducedModulus);
}

double ResponseLaw::storageError(double exponent, double reducedModulus, double compliance) const
{
  std::vector<float> forces(static_cast<std::size_t>(this->Samples));
  std::vector<float> stiffnesses(static_cast<std::size_t>(this->Samples));
  if (!this->sampleSeries(reducedModulus, compliance, forces.data(), stiffnesses.data()))
  {
    return std::numeric_limits<double>::infinity();
  }
  const ResponseSampling sampling(this->Samples, exponent);
  const FloatCurve curve{ forces, stiffnesses };
  double largest = 0.0;
  for (int i = 2; i <= ErrorProbes; ++i)
  {
    const double depth = this->Range * i / ErrorProbes;
    const double exact = seriesResponse(this->Tool, reducedModulus, compliance, depth).force;
    const double stored = sampling.evaluate(curve, this->Range, depth).force;
    largest = std::max(largest, std::abs(stored / exact - 1.0));
  }
  return largest;
}
} // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#ifndef ResponseLaw_h
#define ResponseLaw_h

#include "ResponseSampling.h"

#include <vector>

namespace palpate
{
class AxisymmetricTool;

/**
 * The half-space law of one tool, sampled for storage: evaluated once for E* = 1 and scaled by the
 * modulus of each point. Points of finite global compliance are solved one by one
 * (SeriesCompliance.h).
 */
class ResponseLaw
{
public:
  /// `tool` must outlive the law. Range (mm) is the depth of the last sample.
  ResponseLaw(const AxisymmetricTool& tool, double range, int samples);

  /// Writes n forces (N) and n stiffnesses (N/mm) of a half-space. Safe from any number of threads.
  void sample(double reducedModulus, float* force, float* stiffness) const;

  /// The same in series with a compliance (mm/N). False, and zeros, where the curve folds.
  bool sampleSeries(double reducedModulus, double compliance, float* force, float* stiffness) const;

  /// Deflection of the whole series at a depth of its local part, mm.
  double totalDeflection(double reducedModulus, double compliance, double localDepth) const;

  /// Largest relative error of force between 1 and 100 % of the range, of float samples evaluated
  /// as the kernel does, against the law itself; +inf if it cannot be sampled.
  double storageError(double exponent, double reducedModulus, double compliance) const;

private:
  const AxisymmetricTool& Tool;
  double Range;
  int Samples;
  std::vector<double> UnitForce;
  std::vector<double> UnitStiffness;
};
} // namespace palpate

#endif

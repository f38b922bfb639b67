// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Mechanics/Layers/LayerContact.h"
#include "Mechanics/Layers/LayerKernel.h"

#include <memory>
#include <string>
#include <vector>

namespace palpate::testing
{
/// Properties of the body under one point, except its material.
struct Spot
{
  double inverseThickness = 0.0; ///< 1/thickness of a layer on a rigid base, 1/mm; 0: a half-space
  double compliance = 0.0;       ///< global compliance of the body, in series, mm/N

  bool operator==(const Spot& other) const
  {
    return this->inverseThickness == other.inverseThickness && this->compliance == other.compliance;
  }
};

struct StudyMaterial
{
  double reducedModulus = 1.0; ///< E*, MPa
  double poissonRatio = 0.45;
};

/// A tool and its largest depth in the study.
struct StudyTool
{
  std::string name;   ///< name as on a command line
  double range = 0.0; ///< mm
  std::shared_ptr<const AxisymmetricTool> shape;
};
StudyTool studyTool(const std::string& name, double range);

/// Curves of many points: n samples each, at the depths of ResponseSampling.
struct SampledCurves
{
  int samples = 0;
  double exponent = 1.0;
  double range = 0.0;
  std::vector<double> force;     ///< N, n per point
  std::vector<double> stiffness; ///< N/mm
};

/// Force on a tool, exact within linear elasticity: closed forms on a half-space, the exact layer,
/// or either of them in series with a compliance. Not thread-safe.
class StudyLaw
{
public:
  StudyLaw(StudyTool tool, StudyMaterial material);

  const StudyTool& tool() const { return this->Tool; }
  const StudyMaterial& material() const { return this->Material; }
  IndentationPoint evaluate(const Spot& spot, double deflection) const;

  /// Samples the curve of each Spot. The exponent is that of the tip or 1, whichever stores the
  /// curves better.
  SampledCurves sample(const std::vector<Spot>& spots, int samples) const;

private:
  IndentationPoint local(double inverseThickness, double deflection) const;
  void sampleLayers(const std::vector<Spot>& spots, SampledCurves& curves) const;
  double storageError(const SampledCurves& curves, std::size_t point, const Spot& spot) const;

  StudyTool Tool;
  StudyMaterial Material;
  mutable std::shared_ptr<const LayerKernel> Kernel;
  mutable double Inverse = 0.0; ///< 1/thickness of Layer
  mutable std::unique_ptr<LayerContact> Layer;
};
} // namespace palpate::testing

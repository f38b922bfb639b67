// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ToolDrop_h
#define palpate_ToolDrop_h

#include "Mechanics/PalpateExport.h"
#include "Mechanics/Tilt/TiltTable.h"

#include <vector>

namespace palpate
{
class AxisymmetricTool;

/// The deepest point of one tool over its tilt as a TiltTable stores it: h and dh/dθ at even angles
/// up to the largest, cubic between, and a little way beyond straight.
class PALPATE_EXPORT ToolDrop
{
public:
  static constexpr int Angles = 65; ///< h of a sphere to 1e-8 of its radius

  ToolDrop(const AxisymmetricTool& tool, double largest);

  DeepestPoint at(double angle) const;
  double largest() const { return this->Largest; }
  /// h and dh/dθ of each angle.
  const std::vector<double>& nodes() const { return this->Nodes; }

private:
  double Largest;
  std::vector<double> Nodes;
};
} // namespace palpate

#endif

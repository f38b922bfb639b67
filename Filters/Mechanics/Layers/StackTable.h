// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_StackTable_h
#define palpate_StackTable_h

#include "Mechanics/Layers/LayerTable.h"
#include "Mechanics/Layers/StackKernels.h"
#include "Mechanics/PalpateExport.h"
#include "Mechanics/Tools/AxisymmetricTool.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace palpate
{
/**
 * Curves of one tool at fixed depths on a stack whose first two layers vary in thickness. The exact
 * solution is computed at the nodes of StackKernels. Between the nodes ln F, ln dF/dδ and ln a are
 * interpolated by polynomials of ln h.
 *
 * The constructor takes about 1 ms per node for 8 depths. The curve of a point then takes 1 to 2
 * µs. A point has no curve if its first layer is so thin that the contact radius exceeds
 * LayerKernel::LargestRatio times the thickness. This limit is accurate to a tenth of that
 * thickness.
 */
class PALPATE_EXPORT StackTable final : public LayerCurves
{
public:
  /// `depths` (mm) must be ascending.
  StackTable(const AxisymmetricTool& tool, std::shared_ptr<const StackKernels> kernels,
    std::vector<double> depths);

  bool answers(const LayerPlace& place) const noexcept override;
  Curve sample(const LayerPlace& place) const override;

private:
  void leaveOutTheThinnest(const AxisymmetricTool& tool);

  std::shared_ptr<const StackKernels> Kernels; ///< null if no point has a curve
  /// Logarithms of F, dF/dδ and a for each depth; one column per node.
  Eigen::MatrixXd Logarithms;
};
} // namespace palpate

#endif

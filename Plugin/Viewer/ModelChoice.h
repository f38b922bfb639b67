// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ModelChoice_h
#define palpate_ModelChoice_h

#include "ResponseSet.h"
#include "ViewerScene.h"
#include "ViewerOptions.h"

#include <string>

namespace palpate
{
/// The model that is felt: the body with the response of the first tool in the simplest form that
/// keeps its forces.
struct ModelChoice
{
  vtkSmartPointer<vtkPolyData> body;
  std::string reason; ///< vtkResponseChoice's sentence; "" with --no-auto
  double seconds = 0.0;
};

/**
 * Chooses by --auto and --tolerance, at the depth of the scene; with --no-auto the body is
 * unchanged. A point force is considered if the body has a global compliance (--voxel), not on
 * half-spaces and layers. The responses themselves are kept for pictures, files and other tools.
 *
 * Returns an error, or "".
 */
std::string chooseModel(const ViewerOptions& options, const ViewerScene& scene,
  const ResponseSet& responses, ModelChoice& choice);
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ModelChoice_h
#define palpate_ModelChoice_h

#include "ResponseSet.h"
#include "ViewerScene.h"
#include "ViewerOptions.h"

#include <string>

namespace palpate
{
/// What is felt: the body, the response of the first tool in the least form that keeps its forces.
struct ModelChoice
{
  vtkSmartPointer<vtkPolyData> body;
  std::string reason; ///< vtkResponseChoice's sentence; "" with --no-auto
  double seconds = 0.0;
};

/**
 * Chooses as --auto and --tolerance say, at the depth of the scene; with --no-auto the body as it
 * is. A point force is considered where the body gives way as a whole (--voxel): half-spaces and
 * layers never do. The responses themselves stay whole, for pictures, files and other tools.
 *
 * Returns an error, or "".
 */
std::string chooseModel(const ViewerOptions& options, const ViewerScene& scene,
  const ResponseSet& responses, ModelChoice& choice);
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ModelChoice_h
#define palpate_ModelChoice_h

#include "ResponseSet.h"
#include "ViewerScene.h"
#include "ViewerOptions.h"

#include <string>

namespace palpate
{
/// The model in use: the body with the response of the first tool, in the simplest form that keeps
/// the forces within the tolerance.
struct ModelChoice
{
  vtkSmartPointer<vtkPolyData> body;
  std::string reason; ///< the sentence of vtkResponseChoice; "" with --no-auto
  double seconds = 0.0;
};

/**
 * Chooses the model according to --auto and --tolerance, at the depth of the scene. With --no-auto
 * the body is unchanged. A point force is considered if the body has a global compliance (--voxel),
 * but not for half-spaces and layers. The full responses are kept for pictures, files and other
 * tools.
 *
 * Returns "" or an error.
 */
std::string chooseModel(const ViewerOptions& options, const ViewerScene& scene,
  const ResponseSet& responses, ModelChoice& choice);
} // namespace palpate

#endif

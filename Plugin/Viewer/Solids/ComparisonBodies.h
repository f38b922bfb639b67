// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ComparisonBodies_h
#define palpate_ComparisonBodies_h

#include "ResponseSet.h"
#include "ViewerScene.h"
#include "ViewerOptions.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>

namespace palpate
{
/// One of the two bodies of --compare.
struct ComparedBody
{
  ViewerScene scene;
  ResponseSet responses;
  vtkSmartPointer<vtkPolyData> support; ///< its support, for display
};

/**
 * Makes a strip on two rollers, which bends, and a block bonded to a rigid plate, which does not.
 * They have the same rubber, the same top face z = 0, and the three tools of the paper. Both
 * compliances are computed by finite elements. Motion: a press in the middle and a slide along the
 * strip.
 *
 * Forces of the tools 1 mm deep: within 3 % of each other on the strip, 67 % apart on the block.
 * Returns "" or an error.
 */
std::string makeComparedBodies(const ViewerOptions& options, std::array<ComparedBody, 2>& bodies);
} // namespace palpate

#endif

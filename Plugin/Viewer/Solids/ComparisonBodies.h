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
  vtkSmartPointer<vtkPolyData> support; ///< support of the body, for display
};

/**
 * Makes a strip on two rollers, which bends, and a block bonded to a rigid plate, which does not.
 * Both bodies are made of the same rubber and have the same top face z = 0 and the three tools of
 * the paper. Both compliances are computed by finite elements. The motion is a press in the middle
 * and a slide along the strip.
 *
 * At a depth of 1 mm the forces of the tools differ by 3 % on the strip and by 67 % on the block.
 * Returns "" or an error.
 */
std::string makeComparedBodies(const ViewerOptions& options, std::array<ComparedBody, 2>& bodies);
} // namespace palpate

#endif

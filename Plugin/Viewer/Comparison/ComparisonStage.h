// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ComparisonStage_h
#define palpate_ComparisonStage_h

#include "ComparisonBodies.h"

#include "vtkBodyComparison.h"

#include <array>
#include <string>

class vtkRenderer;

namespace palpate
{
/// Shows two bodies with their supports and all tools of the scenes, and sets the camera.
void setStage(vtkBodyComparison* comparison, const std::array<ComparedBody, 2>& bodies);

/// Adds the support of a body to a renderer.
void addSupport(vtkRenderer* renderer, vtkPolyData* support);

/// Prints the results for both bodies.
void printStatements(vtkBodyComparison* comparison, const std::array<ComparedBody, 2>& bodies);
} // namespace palpate

#endif

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
/// Puts two bodies on the stage with what holds them, under all tools of the scenes, and looks at
/// them.
void setStage(vtkBodyComparison* comparison, const std::array<ComparedBody, 2>& bodies);

/// What holds a body, as an actor of the renderer.
void addSupport(vtkRenderer* renderer, vtkPolyData* support);

/// Prints what was found of both.
void printStatements(vtkBodyComparison* comparison, const std::array<ComparedBody, 2>& bodies);
} // namespace palpate

#endif

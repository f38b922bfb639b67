// SPDX-License-Identifier: BSD-3-Clause
#ifndef TriangleNumbers_h
#define TriangleNumbers_h

#include "Laws/ContactField.h"

#include <vector>

namespace palpate
{
/// Convert a triangle of a displacement field to numbers, for transfer to another process, and
/// back.
std::vector<double> triangleNumbersOf(const FieldTriangle& triangle);
FieldTriangle triangleOf(const std::vector<double>& numbers);

/// Returns the stack of layers that is described by the numbers in <name>LayerStack, four per
/// layer. Without numbers the stack has no layers.
LayerStack stackOf(const std::vector<double>& numbers, LayerBase base);
} // namespace palpate

#endif

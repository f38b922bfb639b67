// SPDX-License-Identifier: BSD-3-Clause
#ifndef TriangleNumbers_h
#define TriangleNumbers_h

#include "Laws/ContactField.h"

#include <vector>

namespace palpate
{
/// A triangle of a field as numbers, which go from one process to another, and back.
std::vector<double> triangleNumbersOf(const FieldTriangle& triangle);
FieldTriangle triangleOf(const std::vector<double>& numbers);

/// A stack of the numbers of <name>LayerStack, four a layer; without layers where they are none.
LayerStack stackOf(const std::vector<double>& numbers, LayerBase base);
} // namespace palpate

#endif

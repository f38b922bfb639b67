// SPDX-License-Identifier: BSD-3-Clause
#ifndef TriangleNumbers_h
#define TriangleNumbers_h

#include "Laws/ContactField.h"

#include <vector>

namespace palpate
{
/// A triangle of a field as numbers, to be sent to another process, and back.
std::vector<double> triangleNumbersOf(const FieldTriangle& triangle);
FieldTriangle triangleOf(const std::vector<double>& numbers);

/// A stack from the numbers of <name>LayerStack, four a layer; without layers if there are no
/// numbers.
LayerStack stackOf(const std::vector<double>& numbers, LayerBase base);
} // namespace palpate

#endif

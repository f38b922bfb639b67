// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SeamSearch_h
#define palpate_SeamSearch_h

#include "Response/Pieces/BodySeam.h"

class vtkPolyData;

namespace palpate
{
/// Returns the seam points of a body's pieces (see BodySeam). `body` is the piece of this rank.
/// Collective.
BodySeam::Points findSeam(const Ranks& ranks, vtkPolyData* body);
} // namespace palpate

#endif

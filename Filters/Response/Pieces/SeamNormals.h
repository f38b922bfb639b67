// SPDX-License-Identifier: BSD-3-Clause
#ifndef SeamNormals_h
#define SeamNormals_h

#include "Contact/BodyMesh.h"

#include <vector>

namespace palpate
{
class BodySeam;

/// Returns the unit angle-weighted normals at the points of a seam. The triangles of all pieces
/// contribute. The normals equal the normals of the body in one piece, except for rounding, because
/// the order of summation differs. The normal of a point without a usable triangle is zero.
/// Collective. The results are bitwise equal on all ranks.
std::vector<Vector3> seamNormals(const BodyMesh& piece, const BodySeam& seam);

/// States whether the surface of all pieces together is closed, and the enclosed volume, mm³. The
/// volume is negative if triangles wind inward, and meaningless if the surface is not closed.
struct SeamClosure
{
  bool isClosed = false;
  double enclosedVolume = 0.0;
};
SeamClosure closureOf(const BodyMesh& piece, const BodySeam& seam);
} // namespace palpate

#endif

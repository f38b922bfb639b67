// SPDX-License-Identifier: BSD-3-Clause
#ifndef SeamNormals_h
#define SeamNormals_h

#include "Contact/BodyMesh.h"

#include <vector>

namespace palpate
{
class BodySeam;

/// Returns unit angle-weighted normals at the places of a seam, from the triangles of all pieces.
/// They equal the normals of the body in one piece, except for rounding by another order of
/// summation. The normal of a point without a usable triangle is zero. Collective; the bits are the
/// same on all ranks.
std::vector<Vector3> seamNormals(const BodyMesh& piece, const BodySeam& seam);

/// Whether the surface of all pieces together is closed, and the volume that it encloses, mm³. The
/// volume is negative if triangles wind inward, and meaningless if the surface is not closed.
struct SeamClosure
{
  bool isClosed = false;
  double enclosedVolume = 0.0;
};
SeamClosure closureOf(const BodyMesh& piece, const BodySeam& seam);
} // namespace palpate

#endif

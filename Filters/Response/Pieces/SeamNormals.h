// SPDX-License-Identifier: BSD-3-Clause
#ifndef SeamNormals_h
#define SeamNormals_h

#include "Contact/BodyMesh.h"

#include <vector>

namespace palpate
{
class BodySeam;

/// Unit angle-weighted normals at the places of a seam, over the triangles of all pieces. They
/// equal those of the body in one piece except for the order in which triangles are summed. The
/// normal of a point without a usable triangle is zero. Collective; the bits are the same on all
/// ranks.
std::vector<Vector3> seamNormals(const BodyMesh& piece, const BodySeam& seam);

/// Whether the surface of all pieces is closed, and the enclosed volume (mm³, negative if triangles
/// wind inward; meaningless if the surface is not closed). Collective.
struct SeamClosure
{
  bool isClosed = false;
  double enclosedVolume = 0.0;
};
SeamClosure closureOf(const BodyMesh& piece, const BodySeam& seam);
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef SeamNormals_h
#define SeamNormals_h

#include "Contact/BodyMesh.h"

#include <vector>

namespace palpate
{
class BodySeam;

/// Unit angle-weighted normals at the places of a seam, over the triangles of all pieces: those of
/// the body in one piece except for the order in which its triangles are summed. Zero where no
/// usable triangle meets. Collective; the same bits on all ranks.
std::vector<Vector3> seamNormals(const BodyMesh& piece, const BodySeam& seam);

/// Whether the surface of all pieces is closed, and the volume it then encloses (mm³, negative when
/// triangles wind inward; otherwise without meaning). Collective.
struct SeamClosure
{
  bool isClosed = false;
  double enclosedVolume = 0.0;
};
SeamClosure closureOf(const BodyMesh& piece, const BodySeam& seam);
} // namespace palpate

#endif

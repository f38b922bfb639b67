// SPDX-License-Identifier: BSD-3-Clause
#ifndef MotionArrays_h
#define MotionArrays_h

#include "Solids/TrueShape/SurfaceMotion.h"

class vtkFloatArray;
class vtkPolyData;

namespace palpate
{
/// Attaches how a body moves as arrays of its surface: `GlobalMode0`..., `GlobalModeSign` and
/// `NearField`, as BodyField reads them.
void attachMotion(const SurfaceMotion& motion, vtkPolyData* solid);

/// The same to another surface of the body with these point `normals`: each point takes the values
/// of the nearby `solid` surface that faces the same way.
void attachMotion(
  const SurfaceMotion& motion, vtkPolyData* solid, vtkFloatArray* normals, vtkPolyData* surface);
} // namespace palpate

#endif

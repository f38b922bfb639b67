// SPDX-License-Identifier: BSD-3-Clause
#ifndef MotionArrays_h
#define MotionArrays_h

#include "Solids/TrueShape/SurfaceMotion.h"

class vtkFloatArray;
class vtkPolyData;

namespace palpate
{
/// Attaches the motion of a body as arrays of its surface: `GlobalMode0`..., `GlobalModeSign` and
/// `NearField`, in the form that BodyField reads.
void attachMotion(const SurfaceMotion& motion, vtkPolyData* solid);

/// Like the function above, for another surface of the body with these point `normals`. The values
/// at each point are interpolated from nearby points of `solid` that face the same way.
void attachMotion(
  const SurfaceMotion& motion, vtkPolyData* solid, vtkFloatArray* normals, vtkPolyData* surface);

/// Attaches only the modes to another surface of the body. They are 0 where the body is held.
void attachModes(
  const GlobalModes& modes, vtkPolyData* solid, vtkFloatArray* normals, vtkPolyData* surface);
} // namespace palpate

#endif

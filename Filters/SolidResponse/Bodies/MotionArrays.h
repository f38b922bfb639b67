// SPDX-License-Identifier: BSD-3-Clause
#ifndef MotionArrays_h
#define MotionArrays_h

#include "Solids/TrueShape/SurfaceMotion.h"

class vtkFloatArray;
class vtkPolyData;

namespace palpate
{
/// Attaches the motion of a body to its surface `solid`, as the arrays `GlobalMode0`...,
/// `GlobalModeSign` and `NearField`. BodyField reads these arrays.
void attachMotion(const SurfaceMotion& motion, vtkPolyData* solid);

/// Same as above, for another surface of the body with the point normals `normals`. The values at
/// each point are interpolated from nearby points of `solid` with a similar normal.
void attachMotion(
  const SurfaceMotion& motion, vtkPolyData* solid, vtkFloatArray* normals, vtkPolyData* surface);

/// Attaches only the modes to another surface of the body. The modes are 0 where the body is held.
void attachModes(
  const GlobalModes& modes, vtkPolyData* solid, vtkFloatArray* normals, vtkPolyData* surface);
} // namespace palpate

#endif

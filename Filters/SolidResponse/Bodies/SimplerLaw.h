// SPDX-License-Identifier: BSD-3-Clause
#ifndef SimplerLaw_h
#define SimplerLaw_h

#include "Solids/FiniteElements/ElasticBody.h"
#include "Response/Curves/ResponseStorage.h"

#include <string>

class vtkContactTool;
class vtkFloatArray;
class vtkPolyData;

namespace palpate
{
/// The law with which finite elements of true shape are compared: a half-space of the material at
/// each point, curved as the surface is, or a layer on a rigid base.
struct SimplerLaw
{
  vtkContactTool* tool = nullptr;
  double deflection = 0.0; ///< mm, of the last sample
  double thickness = 0.0;  ///< mm, 0: a half-space
  std::string thicknesses; ///< point array of the surface in its place; "": none
  double tolerance = 0.01; ///< of the force, relative
};

/**
 * Puts the curves of a simpler law in place of those of true shape at each point where the force
 * changes by no more than the tolerance, down to the point's range. `change` (one component per
 * point) becomes the largest relative change of the law's force by true shape; NaN where one of the
 * two has no curve. `reason` tells how many points keep which curve, and how large the change is.
 * Returns what is wrong, or "".
 */
std::string keepSimplerLaw(const ElasticBody& body, vtkPolyData* surface, const SimplerLaw& law,
  ResponseStorage& storage, vtkFloatArray* change, std::string& reason);
} // namespace palpate

#endif

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
/// each point with the curvature of the surface, or a layer on a rigid base.
struct SimplerLaw
{
  vtkContactTool* tool = nullptr;
  double deflection = 0.0; ///< depth of the last sample, mm
  double thickness = 0.0;  ///< mm; 0: a half-space
  std::string thicknesses; ///< point array of the surface with thicknesses; "": none
  double tolerance = 0.01; ///< largest relative change of the force
};

/**
 * Replaces the curves of true shape by those of a simpler law at each point where the force changes
 * by no more than the tolerance, down to the point's range. `change` (one component per point):
 * largest relative change of the law's force by true shape; NaN if one of the two has no curve.
 * `reason`: a sentence with the number of points with each curve and the size of the change.
 * Returns "", or a message about the fault.
 */
std::string keepSimplerLaw(const ElasticBody& body, vtkPolyData* surface, const SimplerLaw& law,
  ResponseStorage& storage, vtkFloatArray* change, std::string& reason);
} // namespace palpate

#endif

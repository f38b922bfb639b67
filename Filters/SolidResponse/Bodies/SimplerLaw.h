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
/// The law with which the finite-element response of the true shape is compared. It is the law of a
/// half-space with the material at each point and the curvature of the surface, or that of a layer
/// on a rigid base.
struct SimplerLaw
{
  vtkContactTool* tool = nullptr;
  double deflection = 0.0; ///< depth of the last sample, mm
  double thickness = 0.0;  ///< thickness of the layer, mm; 0 means a half-space
  /// Name of the point array of the surface with thicknesses; "" if there is none.
  std::string thicknesses;
  double tolerance = 0.01; ///< largest relative change of the force for which the curve is replaced
};

/**
 * Replaces the curves of the true shape by those of a simpler law. This is done at each point where
 * the replacement changes the force by no more than the tolerance, at depths up to the point's
 * range. `change` (one component per point) receives the largest relative difference of the force
 * of the true shape from that of the law. It is NaN if one of the two has no curve. `reason`
 * receives a sentence with the number of points with each curve and the size of the change. Returns
 * "" or an error message.
 */
std::string keepSimplerLaw(const ElasticBody& body, vtkPolyData* surface, const SimplerLaw& law,
  ResponseStorage& storage, vtkFloatArray* change, std::string& reason);
} // namespace palpate

#endif

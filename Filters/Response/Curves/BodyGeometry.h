// SPDX-License-Identifier: BSD-3-Clause
#ifndef BodyGeometry_h
#define BodyGeometry_h

#include "Response/Curves/BodyShape.h"
#include "Response/Curves/CurvatureBound.h"

#include <memory>
#include <string>
#include <vector>

class vtkPolyData;

namespace palpate
{
class BodySeam;
struct BodyContent;

/// Geometry of this rank's piece of a body. It is the part of a response that depends neither on
/// the tool nor on the material.
struct BodyGeometry
{
  std::vector<float> normals; ///< point normals, from fillPointNormals()
  std::vector<unsigned char> status;
  std::unique_ptr<CurvatureBound> bound;
  BodyLengths lengths{ 0.0, 0.0 };
  std::string fault; ///< error message of the normals, or ""; with an error `bound` is null
};

/// Finds the geometry of a body with this content. Never returns null. Collective.
///
/// The process caches the last geometries of whole bodies by content: points, triangles and normals
/// of the input; 20 bytes per point, up to 128 MB and 4 bodies. Thread-safe.
std::shared_ptr<const BodyGeometry> findGeometry(
  vtkPolyData* body, const BodyContent& content, const BodySeam& seam);
} // namespace palpate

#endif

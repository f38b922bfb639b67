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

/// Finds the geometry of a body. Never returns null. Collective.
///
/// A cache of the process keeps recent geometries of whole bodies. Its key is the content of the
/// input: points, triangles and normals. It takes 20 bytes per point, and is limited to 128 MB and
/// 4 bodies. Thread-safe.
std::shared_ptr<const BodyGeometry> findGeometry(vtkPolyData* body, const BodySeam& seam);
} // namespace palpate

#endif

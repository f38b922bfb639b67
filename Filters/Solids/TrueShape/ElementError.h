// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ElementError_h
#define palpate_ElementError_h

#include "Solids/TrueShape/RegularGreen.h"
#include "Solids/TrueShape/SubtractedLoad.h"

namespace palpate
{
/**
 * Expected error of H at a source due to the elements of a body. It is computed before the body is
 * solved.
 *
 * H is the difference between the body and a half-space under Boussinesq's field. Contributions
 * come from each outer face (its traction if it is free, its reaction if it is held) and from each
 * element of another material. The field varies over an element of size h at a distance r from the
 * source. Therefore the element does not represent a fraction of second order, (h/r)², of its
 * contribution. The absolute values are summed, because where the softening by an edge and the
 * stiffening by a base cancel, H is zero but its error is not. On the smooth surface around the
 * source, the missed fraction is smaller, in proportion to the angle by which the normal varies
 * over one element. The error of bending is not included. ShapedErrorTest checks how often the
 * error is within the estimate.
 *
 * One object is used for one body. at() is thread-safe. Cost: 0.1 µs per outer face and per element
 * of another material.
 */
class ElementError
{
public:
  /// The body must be assembled and must outlive this object.
  explicit ElementError(const ElasticBody& body);

  ExpectedError at(const SingularSource& source) const;

private:
  /// One outer face of the body.
  struct Side
  {
    Eigen::Vector3d middle;
    Eigen::Vector3d area; ///< outward normal times area, mm²
    double spacing;       ///< distance of the face's neighbouring nodes, mm
    bool isHeld;
  };
  /// One element. Elements are used only if there are several materials.
  struct Cell
  {
    Eigen::Vector3d middle;
    double volume;
    double spacing;
    ElasticMaterial material;
  };

  double Part = 0.0; ///< factor on the sum, which depends on the kind of the elements
  std::vector<Side> Sides;
  std::vector<Cell> Cells;
};
} // namespace palpate

#endif

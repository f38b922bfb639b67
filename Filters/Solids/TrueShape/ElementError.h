// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ElementError_h
#define palpate_ElementError_h

#include "Solids/TrueShape/RegularGreen.h"
#include "Solids/TrueShape/SubtractedLoad.h"

namespace palpate
{
/**
 * What the elements of a body let expect of the error of H at a source, before anything is solved.
 *
 * H is what the body does otherwise than a half-space under Boussinesq's field: at each outer face,
 * by its traction where it is free and by the reaction where it is held, and in each element of
 * another material. Elements of size h at a distance r from the source, over which the field
 * changes, miss of that a part of second order, (h/r)². The parts are summed by their amounts:
 * where an edge softens and a base stiffens as much, H is nothing and its error is not. Of the
 * surface that is smooth around the source they miss less, by its turn over an element. What
 * bending does is not in it. How often it holds: ShapedErrorTest.
 *
 * Made once for a body; at() may be called by any number of threads. Cost: 0.1 µs per outer face
 * and per element of another material.
 */
class ElementError
{
public:
  /// The body, assembled, must stay.
  explicit ElementError(const ElasticBody& body);

  ExpectedError at(const SingularSource& source) const;

private:
  /// One side of the body.
  struct Side
  {
    Eigen::Vector3d middle;
    Eigen::Vector3d area; ///< outward normal times area, mm²
    double spacing;       ///< of its nodes, mm
    bool isHeld;
  };
  /// One element, where there are several materials.
  struct Cell
  {
    Eigen::Vector3d middle;
    double volume;
    double spacing;
    ElasticMaterial material;
  };

  double Part = 0.0; ///< of the sum, by the kind of the elements
  std::vector<Side> Sides;
  std::vector<Cell> Cells;
};
} // namespace palpate

#endif

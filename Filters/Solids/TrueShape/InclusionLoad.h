// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_InclusionLoad_h
#define palpate_InclusionLoad_h

#include "Solids/FiniteElements/ElasticElement.h"
#include "Solids/TrueShape/BoussinesqField.h"

namespace palpate
{
/**
 * Returns the forces on the nodes of an element (3 × n, N) that represent the difference between
 * its material and the material of the surrounding field, -∫ ∇N·(D - D₀):ε dV, in the frame of the
 * field. Lengths are in mm, and stresses in MPa.
 *
 * `nodes` are given in the same frame. The number of Gauss points depends on the distance from the
 * origin. The incompatible modes of a hexahedron are condensed as in its stiffness. Without these
 * modes, the measured force over a nodule changes by 0.2 % if the size of the cells equals the
 * depth of the nodule, and by 0.1 % for cells of half this size.
 */
ElementNodes inclusionLoad(ElementKind kind, const ElementNodes& nodes,
  const ElasticMaterial& material, const ElasticMaterial& around, const BoussinesqField& field);
} // namespace palpate

#endif

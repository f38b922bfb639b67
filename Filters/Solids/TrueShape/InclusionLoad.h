// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_InclusionLoad_h
#define palpate_InclusionLoad_h

#include "Solids/FiniteElements/ElasticElement.h"
#include "Solids/TrueShape/BoussinesqField.h"

namespace palpate
{
/**
 * Forces on the nodes of an element (3 × n, N) that represent the difference between its material
 * and the material of the surrounding field: -∫ ∇N·(D - D₀):ε dV, mm and MPa, in the frame of the
 * field.
 *
 * `nodes` are given in that frame. The number of Gauss points depends on the distance. The
 * incompatible modes of a hexahedron are condensed as in its stiffness. Without them the force over
 * a nodule changes by 0.2 % on cells as large as the nodule is deep, and by 0.1 % on cells of half
 * that size (measured).
 */
ElementNodes inclusionLoad(ElementKind kind, const ElementNodes& nodes,
  const ElasticMaterial& material, const ElasticMaterial& around, const BoussinesqField& field);
} // namespace palpate

#endif

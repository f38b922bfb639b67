// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_InclusionLoad_h
#define palpate_InclusionLoad_h

#include "Solids/FiniteElements/ElasticElement.h"
#include "Solids/TrueShape/BoussinesqField.h"

namespace palpate
{
/**
 * The forces on the nodes of an element (3 × n, N) that stand for its material being another than
 * that of the field it lies in: -∫ ∇N·(D - D₀):ε dV, mm and MPa, in the frame of the field.
 *
 * `nodes` in that frame. Gauss points by distance; the part of a hexahedron's incompatible modes is
 * condensed as in its stiffness; leaving it out was measured to change the force over a nodule by
 * 0.2 % on cells as large as the nodule is deep, by 0.1 % on cells of half that.
 */
ElementNodes inclusionLoad(ElementKind kind, const ElementNodes& nodes,
  const ElasticMaterial& material, const ElasticMaterial& around, const BoussinesqField& field);
} // namespace palpate

#endif

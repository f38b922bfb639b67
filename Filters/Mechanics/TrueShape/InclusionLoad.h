// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_InclusionLoad_h
#define palpate_InclusionLoad_h

#include "Mechanics/FiniteElements/ElasticElement.h"
#include "Mechanics/TrueShape/BoussinesqField.h"

namespace palpate
{
/**
 * The forces on the nodes of an element (3 × n, N) that stand for its material being another than
 * that of the field it lies in: -∫ ∇N·(D - D₀):ε dV, mm and MPa, in the frame of the field.
 *
 * `nodes` in that frame. Gauss points by distance; the part of a hexahedron's incompatible modes is
 * condensed as in its stiffness. Leaving that out changes the force on a nodule by less than 0.1 %
 * on elements of half its depth (ContactOnNodule tests the whole).
 */
ElementNodes inclusionLoad(ElementKind kind, const ElementNodes& nodes,
  const ElasticMaterial& material, const ElasticMaterial& around, const BoussinesqField& field);
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MaterialTilts_h
#define palpate_MaterialTilts_h

#include "Laws/ContactSpot.h"
#include "Laws/MaterialRange.h"
#include "Mechanics/PalpateExport.h"
#include "Mechanics/Tilt/TiltTable.h"

#include <cstddef>
#include <string>
#include <vector>

namespace palpate
{
class AxisymmetricTool;

/// The effect of tilting a tool on its force at every point of a body.
struct MaterialTilts
{
  TiltTable table;
  std::vector<float> weights; ///< of each point, one per law, sum 1; none where there is one law
  std::string fault;          ///< why there is no table, or ""
  double error = 0.0;         ///< relative error of the force, the largest by tiltError
  /// The thinnest layer that has a law, mm, 0 without layers; points with thinner layers use this
  /// law.
  double thinnest = 0.0;
};

/**
 * The table of a tool tilted by up to `largest` (rad), pressed up to `range` (mm) into a body, and
 * the weights of its `points` points.
 *
 * A modulus scales the force and changes no factor, so it needs one law. Other parameters are
 * spanned by nodes, a law each, with linear weights between: the thickness of layers, even in
 * a/(a + h), a the contact radius at the range, so that a half-space is the end; Poisson's ratio of
 * layers; the thickness of a stack's second layer; compliance times modulus Y, even in YK/(1 + YK),
 * K the stiffness over E* at the range. Several of them form a grid of at most TiltTerms::MostLaws,
 * coarser if necessary. With enough nodes for one of them the error of the force between is 1 %
 * (MaterialTiltsTest.cxx).
 *
 * On a curved body or at finite strain, the factor is that of the flat body at small strain,
 * applied to the upright force. `bounds` may include more pieces than `spots`: the table is the
 * same for all. `spots` are those of a BodyMaterial. Cost: TiltedHalfSpace and 0.2 to 0.5 s a
 * layer.
 */
PALPATE_EXPORT MaterialTilts tiltsOf(const AxisymmetricTool& tool, double range, double largest,
  const MaterialRange& bounds, const ContactSpots& spots, std::size_t points);
} // namespace palpate

#endif

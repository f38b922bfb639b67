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

/// The effect of a tilt of the tool on its force at every point of a body.
struct MaterialTilts
{
  TiltTable table;
  /// One weight for each law and point, with the sum 1 per point; empty if there is one law.
  std::vector<float> weights;
  std::string fault;  ///< the reason why the table is missing, or ""
  double error = 0.0; ///< largest relative error of the force, estimated by tiltError
  /// Thickness of the thinnest layer for which a law exists, mm; 0 without layers. Points with
  /// thinner layers use this law.
  double thinnest = 0.0;
};

/**
 * Makes the tilt table of a tool that is tilted by up to `largest` (rad) and pressed up to `range`
 * (mm) into a body, and the weights of the body's `points` points.
 *
 * The modulus scales the force and does not change the tilt factor. Therefore one law is valid for
 * all moduli. Each other parameter has nodes, with one law per node and linear weights between
 * nodes:
 * - the thickness of layers, with even nodes in a/(a + h), where a is the contact radius at the
 *   range. A half-space is one end of this axis;
 * - Poisson's ratio of layers;
 * - the thickness of a stack's second layer;
 * - compliance times modulus Y, with even nodes in YK/(1 + YK), where K is the stiffness divided by
 *   E* at the range.
 *
 * Several parameters form a grid of at most TiltTerms::MostLaws laws, which is coarsened if
 * necessary. If one parameter varies and has enough nodes, the error of the force between nodes is
 * 1 % (MaterialTiltsTest.cxx).
 *
 * On a curved body or at finite strain, the tilt factor is that of the flat body at small strain.
 * It multiplies the upright force. `bounds` may include more pieces than `spots`; the table is the
 * same for all pieces. `spots` are those of a BodyMaterial. Cost: that of TiltedHalfSpace, and 0.2
 * to 0.5 s per layer.
 */
PALPATE_EXPORT MaterialTilts tiltsOf(const AxisymmetricTool& tool, double range, double largest,
  const MaterialRange& bounds, const ContactSpots& spots, std::size_t points);
} // namespace palpate

#endif

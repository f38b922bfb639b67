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
  /// One weight for each law and point; the weights of a point have the sum 1. Empty if there is
  /// only one law.
  std::vector<float> weights;
  std::string fault;  ///< the reason why the table is missing; "" if it is not missing
  double error = 0.0; ///< largest relative error of the force, estimated by tiltError()
  /// Thickness of the thinnest layer for which a law exists, mm; 0 if the body has no layers.
  /// Points with thinner layers use this law.
  double thinnest = 0.0;
};

/**
 * Computes the tilt table of a tool, and the weights of its laws at the body's `points` points. The
 * tool is tilted by up to `largest` (rad) and pressed up to `range` (mm) into the body.
 *
 * The modulus scales the force and does not change the tilt factor, so that one law is valid for
 * all moduli. Each of the following parameters has nodes, with one law per node and linear
 * interpolation between nodes:
 * - the thickness of layers, with nodes evenly spaced in a/(a + h), where a is the contact radius
 *   at the range. A half-space is one end of this axis;
 * - Poisson's ratio of layers;
 * - the thickness of a stack's second layer;
 * - compliance times modulus Y, with nodes evenly spaced in YK/(1 + YK), where K is the stiffness
 *   divided by E* at the range.
 *
 * Several parameters form a grid of at most TiltTerms::MostLaws laws. If more laws would be needed,
 * the grid is coarsened. If only one parameter varies and has enough nodes, the error of the force
 * between nodes is 1 % (MaterialTiltsTest.cxx).
 *
 * On a curved body or at finite strain, the tilt factor of the flat body at small strain is used.
 * It multiplies the upright force. `bounds` may include other pieces of the body in addition to
 * `spots`; the table is the same for all pieces. `spots` must be those of a BodyMaterial. Cost:
 * that of TiltedHalfSpace, and 0.2 to 0.5 s per layer.
 */
PALPATE_EXPORT MaterialTilts tiltsOf(const AxisymmetricTool& tool, double range, double largest,
  const MaterialRange& bounds, const ContactSpots& spots, std::size_t points);
} // namespace palpate

#endif

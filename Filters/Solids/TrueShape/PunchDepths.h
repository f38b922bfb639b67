// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PunchDepths_h
#define palpate_PunchDepths_h

#include <vector>

namespace palpate
{
/// The depth at which a flat punch comes into full contact with a surface that bulges, is hollow or
/// is inclined under the punch.
struct PunchClosing
{
  double depth = 0.0; ///< depth of full contact, mm; 0 means full contact from the first touch
  double sink = 0.0;  ///< F divided by dF/dδ at the depth of full contact, mm
  /// Force at which the growing contact reaches the wall, as a fraction of the force at full
  /// contact.
  double carried = 0.0;
  bool isSolved = false; ///< whether the uneven contact is solved at each depth (UnevenContact)
};

/// A depth of a flat punch, computed with the assumption of full contact.
struct PunchDepth
{
  double depth = 0.0; ///< depth, mm
  /// Relative error of the force due to the unknown shape of the contact at smaller depths.
  double open = 0.0;
};

/// Returns the depths of a flat punch's curve in ascending order. `radius` is the radius of the
/// punch, mm.
std::vector<PunchDepth> punchDepths(double radius, const PunchClosing& closing);
} // namespace palpate

#endif

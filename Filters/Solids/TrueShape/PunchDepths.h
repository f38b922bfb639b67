// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PunchDepths_h
#define palpate_PunchDepths_h

#include <vector>

namespace palpate
{
/// The depth at which a flat punch comes into full contact with a surface that bulges, is hollow or
/// is inclined under it.
struct PunchClosing
{
  double depth = 0.0;    ///< depth of full contact, mm; 0: full contact from the first touch
  double sink = 0.0;     ///< F divided by dF/dδ at that depth, mm
  double carried = 0.0;  ///< fraction of that force at which the growing contact reaches the wall
  bool isSolved = false; ///< whether the uneven contact is solved at each depth (UnevenContact)
};

/// A depth of a flat punch. Full contact is assumed.
struct PunchDepth
{
  double depth = 0.0; ///< mm
  /// Error of the force due to the unknown shape of the contact below this depth, as a fraction.
  double open = 0.0;
};

/// The depths of a flat punch's curve, ascending. `radius`: that of the punch, mm.
std::vector<PunchDepth> punchDepths(double radius, const PunchClosing& closing);
} // namespace palpate

#endif

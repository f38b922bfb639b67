// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PunchDepths_h
#define palpate_PunchDepths_h

#include <vector>

namespace palpate
{
/// How a flat punch comes to touch all over a surface that bulges, hollows or leans under it.
struct PunchClosing
{
  double depth = 0.0;    ///< from which on it does, mm; 0: from the first touch
  double sink = 0.0;     ///< F over dF/dδ there, mm
  double carried = 0.0;  ///< the part of that force which the curve has before it meets the wall
  bool isSolved = false; ///< what is uneven is solved for at each depth (UnevenContact)
};

/// A depth at which a flat punch is pressed, as if it touched all over.
struct PunchDepth
{
  double depth = 0.0; ///< mm
  double open = 0.0;  ///< of the force, a fraction: what is not known of the shape below it
};

/// The depths that a flat punch's curve takes, ascending; `radius` of the punch, mm.
std::vector<PunchDepth> punchDepths(double radius, const PunchClosing& closing);
} // namespace palpate

#endif

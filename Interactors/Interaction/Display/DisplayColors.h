// SPDX-License-Identifier: BSD-3-Clause
#ifndef DisplayColors_h
#define DisplayColors_h

#include <array>

namespace palpate
{
using Color = std::array<double, 3>;

// Colours of the curves of a chart, in their order: the palette of Okabe and Ito (2008), which
// colour-blind readers can distinguish.
constexpr std::array<Color, 6> CurveColors = { { { 0.00, 0.45, 0.70 }, { 0.84, 0.37, 0.00 },
  { 0.00, 0.62, 0.45 }, { 0.80, 0.47, 0.65 }, { 0.90, 0.62, 0.00 }, { 0.34, 0.71, 0.91 } } };

// Colours of the forces, in the scene and in charts: the ideal total force, the applied force, the
// normal force and the friction.
constexpr Color ForceColor = { 0.84, 0.20, 0.00 };
constexpr Color AppliedForceColor = { 0.00, 0.45, 0.70 };
constexpr Color NormalForceColor = { 0.36, 0.36, 0.40 };
constexpr Color FrictionForceColor = { 0.00, 0.50, 0.36 };
constexpr Color TorqueColor = { 0.45, 0.20, 0.60 };
constexpr Color MemoryForceColor = { 0.80, 0.47, 0.65 }; // memory part of the force

constexpr Color ToolColor = { 0.45, 0.52, 0.62 };
// This colour is visible on the light and on the dark parts of a dent.
constexpr Color CircleColor = { 0.10, 0.75, 0.95 };
constexpr Color TextColor = { 0.10, 0.10, 0.12 };
constexpr Color BackgroundColor = { 0.97, 0.97, 0.98 };

// Colours of the displacement, from the light grey of the undeformed body through violet to near
// black. The lightness decreases monotonically, so that the scale can also be read without colours.
constexpr std::array<Color, 5> DeflectionColors = { { { 0.90, 0.86, 0.82 }, { 0.93, 0.69, 0.55 },
  { 0.80, 0.36, 0.47 }, { 0.46, 0.15, 0.49 }, { 0.12, 0.05, 0.30 } } };

// Colours of the force along a trail, from yellow-green to dark blue (after ColorBrewer's YlGnBu).
// These colours differ from the colours of the body. Their lightness also decreases monotonically.
constexpr std::array<Color, 5> TrailColors = { { { 0.72, 0.88, 0.55 }, { 0.35, 0.74, 0.67 },
  { 0.11, 0.53, 0.73 }, { 0.12, 0.30, 0.62 }, { 0.03, 0.08, 0.30 } } };
} // namespace palpate

#endif

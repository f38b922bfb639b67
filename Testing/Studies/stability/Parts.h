// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_Parts_h
#define palpate_testing_Parts_h

/// The parts of the stability study. Each prints its rows as CSV on the standard output. README.md
/// explains the columns. `isQuick`: only some of the rows.
namespace palpate::testing
{
void stiffnessLimits(bool isQuick);
void encoderLimits(bool isQuick);
void pressedUntilItBuzzes(bool isQuick);
void cylinderSettings(bool isQuick);
void holdLeak(bool isQuick);
void frictionInTheLoop(bool isQuick);
void unkindGeometry(bool isQuick);
void deviceFailures(bool isQuick);
void relaxingLimits(bool isQuick);
void relaxingPress(bool isQuick);
void relaxingPaths(bool isQuick);
void handsLimits(bool isQuick);
void handsPress(bool isQuick);
} // namespace palpate::testing

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_Parts_h
#define palpate_testing_Parts_h

/// The parts of the stability study; each prints its rows as CSV on the standard output. Columns
/// and what is meant by them: README.md. `isQuick`: some of the rows only.
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

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ArrangedReadings_h
#define palpate_ArrangedReadings_h

#include "Identification/BodyFit.h"
#include "Identification/CurvePreparation.h"
#include "Identification/FirstContact.h"

namespace palpate
{
/// All loads of a curve, by depth.
IndentationCurve loadsByDepth(const AxisymmetricTool& tool, const PreparedCurve& prepared);

/**
 * Estimates the first contact of a curve of ascending depths: the half-space on a straight line
 * with the least squares, from a scan. The scan closes in on the contact, so that a baseline a
 * thousand times as long costs some more scans, and no accuracy.
 *
 * Cost: a millisecond, and as much for each factor of ten by which the baseline is longer than the
 * contact.
 */
FirstContact findFirstContact(const IndentationCurve& curve);

/**
 * What so many readings before contact, over this range (mm), tell of the baseline of a contact of
 * this depth (mm); `noise` is relative to the largest force. An offset takes four readings. A drift
 * takes eight, over half of the depth, or such that over the depth it is known to 1 % of the
 * largest force, with a noise not below the accuracy of a law: else E* would become far more
 * uncertain by a drift than by its noise, and the errors of a law would count as drift.
 */
BaselineTerms baselineTerms(double readings, double range, double depth, double noise);

/// The largest change of the force by a drift over the depth of contact, relative to the largest
/// force: more is no drift.
constexpr double LargestDrift = 0.1;

/**
 * The readings of a curve of ascending depths as they are fitted, with the estimate of first
 * contact: all those in contact, and of those before it the last over four times the depth of
 * contact. Many are averaged over equal depths: 160 groups in contact, within which the curve is
 * nearly straight, and 40 before.
 *
 * Without `findContact` depths count from first contact, and there is no baseline.
 */
IndentationCurve arrangeReadings(const IndentationCurve& curve, bool findContact);
} // namespace palpate

#endif

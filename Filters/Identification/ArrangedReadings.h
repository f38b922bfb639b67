// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ArrangedReadings_h
#define palpate_ArrangedReadings_h

#include "Identification/BodyFit.h"
#include "Identification/CurvePreparation.h"
#include "Identification/FirstContact.h"

namespace palpate
{
/// Returns the readings of all loadings of a curve, sorted by depth.
IndentationCurve loadsByDepth(const AxisymmetricTool& tool, const PreparedCurve& prepared);

/**
 * Estimates the first contact of a curve with ascending depths. A scan over depths of first contact
 * fits a half-space on a straight baseline and selects the least sum of squares. The scan is
 * repeated on shorter ranges around the contact, so that a baseline that is a thousand times as
 * long requires only a few more scans and does not reduce the accuracy.
 *
 * Cost: one millisecond, plus one millisecond for each factor of ten by which the baseline is
 * longer than the contact.
 */
FirstContact findFirstContact(const IndentationCurve& curve);

/**
 * Returns the terms of a baseline that can be fitted from `readings` readings before contact. These
 * readings cover a depth of `range` (mm); the contact has the depth `depth` (mm). `noise` is
 * relative to the largest force. An offset needs four readings. A drift needs eight readings and
 * one of two conditions:
 * - the range is at least half of the depth;
 * - the error of the force due to the drift over the depth is at most 1 % of the largest force. For
 *   this condition the noise is assumed to be at least as large as the error of a law.
 *
 * Without these conditions a drift would make E* far more uncertain than the noise does, and errors
 * of the law would be fitted as drift.
 */
BaselineTerms baselineTerms(double readings, double range, double depth, double noise);

/// Largest accepted change of the force by a drift over the depth of contact, relative to the
/// largest force.
constexpr double LargestDrift = 0.1;

/**
 * Prepares the readings of a curve with ascending depths for a fit, with an estimate of first
 * contact. The result contains all readings in contact, and the readings before contact within four
 * times the depth of contact. If there are many readings, they are averaged over equal intervals of
 * depth: 160 intervals in contact, in each of which the curve is nearly straight, and 40 before
 * contact.
 *
 * If `findContact` is false, depths are assumed to be measured from first contact, and there is no
 * baseline.
 */
IndentationCurve arrangeReadings(const IndentationCurve& curve, bool findContact);
} // namespace palpate

#endif

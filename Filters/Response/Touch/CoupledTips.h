// SPDX-License-Identifier: BSD-3-Clause
#ifndef CoupledTips_h
#define CoupledTips_h

#include "Response/Touch/TipContacts.h"

#include <string>
#include <vector>

class vtkDoubleArray;

namespace palpate
{
/**
 * Checks whether tips that have passed checkTips can press at once. Returns "" or an error message.
 * These are errors:
 * - more than CoupledContacts::Most polylines, or more than CoupledContacts::Most single points at
 *   one Time;
 * - if the tips have the array Time: a polyline with two points at the same time, or a polyline
 *   that lacks a point at the time of a point of another polyline. The latter is checked between
 *   the first and the last time of the polyline;
 * - a single point whose Time is NaN or minus infinity.
 */
std::string checkCoupledTips(vtkPolyData* tips);

/**
 * Computes contacts as touchWithTips does, but tips that press at the same time interact
 * (CoupledContacts::settle). Points of polylines press at the same time if they have equal Time or,
 * without Time, the same index in their polylines. Single points press at the same time if they
 * have equal Time; without Time, all of them do. Single points and polylines do not interact. The
 * tips must have passed checkCoupledTips, and the body must have a coupling.
 *
 * If `errors` is not null, it receives a relative error of each tip's force. The error arises
 * because the other tips are represented by point forces (CoupledContacts::pointForceError). It is
 * 0 for a single tip.
 *
 * If `stiffness` is not null, it receives a tuple per tip. The components are the derivatives of
 * the tip's slow normal force with respect to the depth of each tip that presses at the same time,
 * N/mm. They are in the order of the polylines or of the points. The number of components is the
 * largest number of tips that press at once; unused components are zero.
 */
void touchTogether(const ContactBody& body, vtkPolyData* tips, const ContactSettings& settings,
  double indentation, const TipVisitor& visit, vtkDoubleArray* stiffness = nullptr,
  std::vector<double>* errors = nullptr);
} // namespace palpate

#endif

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
 * - more than CoupledContacts::Most polylines, or more single points than that at one Time;
 * - with Time, a polyline with two points at one time, or without a point at a time of another
 *   polyline between its own first and last time;
 * - a single point whose Time is NaN or minus infinity.
 */
std::string checkCoupledTips(vtkPolyData* tips);

/**
 * Touches a body as touchWithTips does, but tips that press at the same time interact
 * (CoupledContacts::settle). For polylines these are the points of equal Time or, without Time, of
 * equal index in their polylines. For single points these are the points of equal Time, or all of
 * them. Single points and polylines do not interact. The tips must have passed checkCoupledTips,
 * and the body must have a coupling.
 *
 * `errors`, unless null, receives the relative error of each tip's force due to the point forces by
 * which the other tips are represented (CoupledContacts::pointForceError); 0 for a single tip.
 *
 * `stiffness`, unless null, receives a tuple per tip: the derivative of the tip's slow normal force
 * with respect to the depth of each tip that presses at the same time, N/mm, in the order of the
 * polylines, or of the points. The number of components is the largest number of tips that press at
 * once; unused components are zero.
 */
void touchTogether(const ContactBody& body, vtkPolyData* tips, const ContactSettings& settings,
  double indentation, const TipVisitor& visit, vtkDoubleArray* stiffness = nullptr,
  std::vector<double>* errors = nullptr);
} // namespace palpate

#endif

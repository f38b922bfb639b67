// SPDX-License-Identifier: BSD-3-Clause
#ifndef CoupledTips_h
#define CoupledTips_h

#include "Response/Touch/TipContacts.h"

#include <string>

class vtkDoubleArray;

namespace palpate
{
/**
 * Why tips that have passed checkTips cannot press at once, or "": more than CoupledContacts::Most
 * polylines, or as many single points (at one Time); with Time a polyline that has two points at
 * one time, or none at one of another polyline's between its first and its last; a single point
 * whose Time is NaN or minus infinity.
 */
std::string checkCoupledTips(vtkPolyData* tips);

/**
 * As touchWithTips, but tips that press at the same time feel one another
 * (CoupledContacts::settle): of polylines those of equal Time, or, without Time, of equal index in
 * their polylines; of single points those of equal Time, or all. Single points and polylines do not
 * feel one another. The tips have passed checkCoupledTips, the body has a coupling.
 *
 * `stiffness`, unless null, gets a tuple per tip: the derivative of its slow normal force by the
 * depth of each tip that presses with it, N/mm, in the order of the polylines, or of the points; as
 * many components as tips ever press at once, the others zero.
 */
void touchTogether(const ContactBody& body, vtkPolyData* tips, const ContactSettings& settings,
  double indentation, const TipVisitor& visit, vtkDoubleArray* stiffness = nullptr);
} // namespace palpate

#endif

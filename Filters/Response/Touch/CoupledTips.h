// SPDX-License-Identifier: BSD-3-Clause
#ifndef CoupledTips_h
#define CoupledTips_h

#include "Response/Touch/TipContacts.h"

#include <string>

class vtkDoubleArray;

namespace palpate
{
/**
 * What keeps tips that have passed checkTips from pressing at once, or "": more than
 * CoupledContacts::Most polylines, or as many single points (at one Time); with Time a polyline
 * that has two points at one time, or none at one of another polyline's between its first and its
 * last; a single point whose Time is NaN or minus infinity.
 */
std::string checkCoupledTips(vtkPolyData* tips);

/**
 * As touchWithTips, but tips that are there at once press at once and feel one another
 * (CoupledContacts::settle): along polylines those of one Time, or, without Time, of one place in
 * their polylines; of the single points those of one Time, or all. Single points and polylines do
 * not feel one another. The tips have passed checkCoupledTips, the body has a coupling.
 *
 * `stiffness`, unless null, gets a tuple per tip: by how much its slow normal force rises with the
 * depth of each tip that presses with it, N/mm, in the order of the polylines, or of the points;
 * as many as ever press at once, zeros beyond.
 */
void touchTogether(const ContactBody& body, vtkPolyData* tips, const ContactSettings& settings,
  double indentation, const TipVisitor& visit, vtkDoubleArray* stiffness = nullptr);
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef TipContacts_h
#define TipContacts_h

#include "Contact/ToolContact.h"

#include "vtkType.h"

#include <functional>
#include <string>

class vtkPolyData;

namespace palpate
{
/// Checks the polylines of tips, their array `Time` along the polylines, and their array
/// `ToolAxis`. Returns "" or an error message.
std::string checkTips(vtkPolyData* tips);

/// Receives each tip, its contact, and the tip's position after Indentation. Several threads may
/// call it for different tips.
using TipVisitor =
  std::function<void(vtkIdType tip, const Contact& contact, const Vector3& pressed)>;

/**
 * Touches a body with tips that have passed checkTips. The tips of a polyline are one history, with
 * friction, and with time if they have the array `Time`. The other tips are single touches, without
 * friction and time. The axes are used if the tips have the array `ToolAxis`. Each tip is first
 * moved inward by `indentation` (mm) along the blended normal at its closest point.
 */
void touchWithTips(const ContactBody& body, vtkPolyData* tips, const ContactSettings& settings,
  double indentation, const TipVisitor& visit);
} // namespace palpate

#endif

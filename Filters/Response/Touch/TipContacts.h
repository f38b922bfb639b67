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
/// Checks the polylines of tips, and the point arrays `Time` and `ToolAxis`. Returns "" or an error
/// message.
std::string checkTips(vtkPolyData* tips);

/// Receives the index of a tip, the contact of the tip, and the position of the tip after the
/// indentation. Several threads may call the visitor at the same time for different tips.
using TipVisitor =
  std::function<void(vtkIdType tip, const Contact& contact, const Vector3& pressed)>;

/**
 * Computes the contacts of tips that have passed checkTips with a body. The tips of a polyline form
 * one history with friction. The history depends on time if the tips have the array `Time`. The
 * other tips are single touches without friction and time. The tool axes are used if the tips have
 * the array `ToolAxis`. Each tip is first moved inward by `indentation` (mm) along the blended
 * normal at its closest point.
 */
void touchWithTips(const ContactBody& body, vtkPolyData* tips, const ContactSettings& settings,
  double indentation, const TipVisitor& visit);
} // namespace palpate

#endif

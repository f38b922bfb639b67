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
/// What is wrong with the polylines of tips, with their array `Time` along these, or with their
/// array `ToolAxis`; "" if nothing.
std::string checkTips(vtkPolyData* tips);

/// Receives each tip, its contact, and the tip's position after Indentation. Called by several
/// threads, for different tips.
using TipVisitor =
  std::function<void(vtkIdType tip, const Contact& contact, const Vector3& pressed)>;

/**
 * Touches a body with tips that have passed checkTips: those of a polyline as one history, with
 * friction, and in time where they have the array `Time`; the others one by one, without; with
 * their axes where they have the array `ToolAxis`. Each is first moved inward by `indentation` (mm)
 * along the blended normal at its closest point.
 */
void touchWithTips(const ContactBody& body, vtkPolyData* tips, const ContactSettings& settings,
  double indentation, const TipVisitor& visit);
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef ContactValidity_h
#define ContactValidity_h

#include "Interaction/Display/ShownContact.h"

#include <string>

class vtkPolyData;

namespace palpate
{
/// Sets validity, limit and error of a contact from Validity, Limit and Error of the response with
/// this prefix: of the three corners of its cell the weakest. Without those arrays, or without a
/// contact, nothing is known to break: infinite.
void findValidity(vtkPolyData* body, const std::string& responseName, ShownContact& contact);
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mechanics/Tools/AxisymmetricTool.h"
#include "ContactMethod.h"
#include "FiniteBody.h"

#include <memory>
#include <vector>

namespace palpate::testing
{

using FiniteBodyPointer = std::shared_ptr<const FiniteBody>;
using ToolPointer = std::shared_ptr<const AxisymmetricTool>;
using MethodPointer = std::unique_ptr<ContactMethod>;

// Each takes tips (x, y, -δ) and answers (0, 0, F); NaN where the contact leaves the window.

/// Full finite-element solve (offline): every step of the contact solves the whole body anew.
MethodPointer fullSolve(FiniteBodyPointer body, ToolPointer tool);

/// Condensed finite-element contact per tick: the window's compliance is stored, the contact is
/// solved.
MethodPointer condensedContact(FiniteBodyPointer body, ToolPointer tool);

/// Local + global at run time: the tool's half-space law in series with C_g at the site.
MethodPointer localAndGlobal(FiniteBodyPointer body, ToolPointer tool);
/// The same with C_g from six modes of the body.
MethodPointer localAndModes(FiniteBodyPointer body, ToolPointer tool);
/// Global compliance only: F = δ / C_g, the tool's shape ignored; NaN where C_g is not positive.
MethodPointer globalOnly(FiniteBodyPointer body);
/// One node pressed: F = δ / C_ii, the spring that a point contact on these elements feels.
MethodPointer pressedNode(FiniteBodyPointer body);

/// All of them, the full solve first. It costs a second per tip where the others cost micro- or
/// milliseconds; its forces are those of the condensed one to 1e-6.
std::vector<MethodPointer> finiteMethods(FiniteBodyPointer body, ToolPointer tool);

/// What the others are judged by: the exact half-space under the tool, and what the body adds to it
/// by finite elements. Some 0.1 s per tip.
MethodPointer finiteReference(FiniteBodyPointer body, ToolPointer tool);

} // namespace palpate::testing

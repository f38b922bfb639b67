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

// Each method takes tips (x, y, -δ) and returns (0, 0, F); NaN if the contact leaves the window.

/// Full finite-element solution (offline): each step of the contact solves the whole body again.
MethodPointer fullSolve(FiniteBodyPointer body, ToolPointer tool);

/// Condensed finite-element contact per tick: the compliance of the window is stored, the contact
/// is solved.
MethodPointer condensedContact(FiniteBodyPointer body, ToolPointer tool);

/// Local + global at run time: the tool's half-space law in series with C_g at the site.
MethodPointer localAndGlobal(FiniteBodyPointer body, ToolPointer tool);
/// As localAndGlobal(), with C_g from six modes of the body.
MethodPointer localAndModes(FiniteBodyPointer body, ToolPointer tool);
/// Global compliance only: F = δ / C_g, for any shape of tool; NaN if C_g is not positive.
MethodPointer globalOnly(FiniteBodyPointer body);
/// One pressed node: F = δ / C_ii, the spring of a point contact on these elements.
MethodPointer pressedNode(FiniteBodyPointer body);

/// All of these methods, the full solution first. The full solution takes a second per tip, the
/// other methods micro- or milliseconds. The forces of the full solution equal those of
/// condensedContact() to 1e-6.
std::vector<MethodPointer> finiteMethods(FiniteBodyPointer body, ToolPointer tool);

/// The reference for the other methods: the exact half-space under the tool, plus the effect of the
/// body by finite elements. About 0.1 s per tip.
MethodPointer finiteReference(FiniteBodyPointer body, ToolPointer tool);

} // namespace palpate::testing

// SPDX-License-Identifier: BSD-3-Clause
#include "FiniteMethods.h"

#include "CondensedContact.h"
#include "FullSolve.h"
#include "SeriesContact.h"
#include "SplitReference.h"

namespace palpate::testing
{

MethodPointer fullSolve(FiniteBodyPointer body, ToolPointer tool)
{
  return std::make_unique<FullSolve>(std::move(body), std::move(tool));
}

MethodPointer condensedContact(FiniteBodyPointer body, ToolPointer tool)
{
  return std::make_unique<CondensedContact>(std::move(body), std::move(tool));
}

MethodPointer localAndGlobal(FiniteBodyPointer body, ToolPointer tool)
{
  return std::make_unique<SeriesContact>(
    std::move(body), std::move(tool), SeriesContact::From::Stored);
}

MethodPointer localAndModes(FiniteBodyPointer body, ToolPointer tool)
{
  return std::make_unique<SeriesContact>(
    std::move(body), std::move(tool), SeriesContact::From::Modes);
}

MethodPointer globalOnly(FiniteBodyPointer body)
{
  return std::make_unique<SiteSpring>(std::move(body), SiteSpring::Kind::Global);
}

MethodPointer pressedNode(FiniteBodyPointer body)
{
  return std::make_unique<SiteSpring>(std::move(body), SiteSpring::Kind::Node);
}

std::vector<MethodPointer> finiteMethods(FiniteBodyPointer body, ToolPointer tool)
{
  std::vector<MethodPointer> methods;
  methods.push_back(fullSolve(body, tool));
  methods.push_back(condensedContact(body, tool));
  methods.push_back(localAndGlobal(body, tool));
  methods.push_back(localAndModes(body, tool));
  methods.push_back(globalOnly(body));
  methods.push_back(pressedNode(body));
  return methods;
}

MethodPointer finiteReference(FiniteBodyPointer body, ToolPointer tool)
{
  return std::make_unique<SplitReference>(std::move(body), std::move(tool));
}

} // namespace palpate::testing

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FiniteMethods.h"

namespace palpate::testing
{

/// δ = δ_local(F; tool) + C F with the half-space law of the tool and C = C_g at the site, solved
/// in each tick. C_g comes from stored compliances or from six modes of the body.
class SeriesContact : public ContactMethod
{
public:
  enum class From
  {
    Stored,
    Modes
  };
  SeriesContact(FiniteBodyPointer body, ToolPointer tool, From from);

  std::string name() const override;
  Vector3 force(const Vector3& tip) override;
  std::size_t bytes() const override;

private:
  double compliance(double x, double y) const;

  FiniteBodyPointer Body;
  ToolPointer Tool;
  From Source;
};

/// A spring at each node of the window, for any tool: F = δ / C.
class SiteSpring : public ContactMethod
{
public:
  enum class Kind
  {
    Global, ///< C_g; NaN if it is not positive
    Node    ///< C_ii, the compliance of one node of these elements
  };
  SiteSpring(FiniteBodyPointer body, Kind kind);

  std::string name() const override;
  Vector3 force(const Vector3& tip) override;
  std::size_t bytes() const override { return sizeof(double) * this->Compliances.size(); }

private:
  FiniteBodyPointer Body;
  Kind Which;
  std::vector<double> Compliances;
};

} // namespace palpate::testing

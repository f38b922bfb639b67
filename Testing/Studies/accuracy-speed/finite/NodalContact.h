// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FiniteMethods.h"
#include "Mechanics/Numerics/UnilateralContact.h"

namespace palpate::testing
{

/**
 * Unilateral contact of a rigid tool with the nodes of a window. Node i, at the distance r_i from
 * the tool's axis, moves inward by δ - f(r_i) or more; its force is compressive or zero. Vertical
 * forces and small displacements, as in the half-space laws. The force is the sum over the nodes.
 * NaN if the contact reaches the rim of the window. The nodes in contact are kept as the first
 * guess for the next tip; the result does not depend on it.
 */
class NodalContact
  : public ContactMethod
  , protected CompliantNodes
{
public:
  Vector3 force(const Vector3& tip) final;
  void forget() final { this->Touched.clear(); }
  /// Window nodes in contact at the last tip, and their forces, N.
  const std::vector<int>& touched() const { return this->Touched; }
  const Eigen::VectorXd& forces() const { return this->Forces; }

protected:
  NodalContact(FiniteBodyPointer body, ToolPointer tool);
  const FiniteBody& body() const { return *this->Body; }
  /// Window nodes that may come into contact; CompliantNodes uses their position in this list.
  const std::vector<int>& candidates() const { return this->Candidates; }

private:
  void collect(const Vector3& tip, double depth);
  void guess(const Vector3& tip, double depth);

  FiniteBodyPointer Body;
  ToolPointer Tool;
  UnilateralContact Contact;
  std::vector<int> Candidates;
  std::vector<int> Active;
  std::vector<int> Touched;
  Eigen::VectorXd Wanted;
  Eigen::VectorXd Forces;
};

} // namespace palpate::testing

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FiniteMethods.h"
#include "Mechanics/Numerics/UnilateralContact.h"

namespace palpate::testing
{

/**
 * Splits the Green function into two parts: G(x,X) = 1/(πE*|x-X|) + H(x,X). Elements resolve the
 * first, singular part badly; therefore its exact form is used. The second part is smooth over some
 * mm and comes from elements (RegularField). Unlike C_g in series, H varies under the contact,
 * because a plate bends around the tool. The contact is solved on squares of uniform pressure
 * around the tip (Love 1929), about `Squares` across the contact. The error of these coarse squares
 * in the singular part is measured on a half-space under the same force, where the law of the tool
 * is known. The depth is corrected by this error.
 */
class SplitReference
  : public ContactMethod
  , private CompliantNodes
{
public:
  static constexpr int Squares = 16;
  SplitReference(FiniteBodyPointer body, ToolPointer tool, int squares = Squares);

  std::string name() const override { return "split finite-element reference"; }
  Vector3 force(const Vector3& tip) override;
  std::size_t bytes() const override;

private:
  void press(const std::vector<int>& active, const Eigen::VectorXd& wanted,
    Eigen::VectorXd& forces) override;
  void move(
    const std::vector<int>& active, const Eigen::VectorXd& forces, Eigen::VectorXd& moved) override;

  /// Places squares within `extent` of the tip's axis; false if they leave the window.
  bool layOut(const Vector3& tip, double side, double extent);
  /// The force at a depth, with the given matrix.
  double pressed(const Eigen::MatrixXd& matrix, double depth);
  double solve(const Vector3& tip, double depth, double radius);

  FiniteBodyPointer Body;
  ToolPointer Tool;
  int Across;
  UnilateralContact Contact;
  std::vector<Eigen::Vector2d> Middles; ///< middles of the squares, relative to the axis
  Eigen::MatrixXd Local;                ///< compliance of the squares on a half-space, mm/N
  Eigen::MatrixXd Whole;                ///< Local plus H
  const Eigen::MatrixXd* Matrix = nullptr;
  std::vector<int> Active;
  double Outermost = 0.0; ///< farthest square in contact, from the axis
};

} // namespace palpate::testing

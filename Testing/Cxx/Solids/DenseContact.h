// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_DenseContact_h
#define palpate_testing_DenseContact_h

#include "Solids/TrueShape/ContactKernelFit.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>

#include <cmath>
#include <functional>
#include <vector>

namespace palpate::testing
{
/**
 * A contact computed from the H of a fit without means over angles, as an independent second way
 * from the same H: square cells of uniform pressure, Love's solution for the half-space plus H
 * between their centres, and an iterated active set. H is the regular part of the Green function.
 */
class DenseContact
{
public:
  /// Makes square cells of this side at distances of up to `radius` from the point.
  DenseContact(const ContactKernelFit& fit, double radius, double side)
    : Side(side)
  {
    const int n = static_cast<int>(std::ceil(radius / side));
    for (int i = -n; i < n; ++i)
    {
      for (int j = -n; j < n; ++j)
      {
        const Eigen::Vector2d at = side * Eigen::Vector2d(i + 0.5, j + 0.5);
        if (at.norm() < radius)
        {
          this->Cells.push_back(at);
        }
      }
    }
    const auto count = static_cast<Eigen::Index>(this->Cells.size());
    this->HalfSpace.resize(count, count);
    for (Eigen::Index i = 0; i < count; ++i)
    {
      for (Eigen::Index j = 0; j < count; ++j)
      {
        const Eigen::Vector2d away =
          this->Cells[static_cast<std::size_t>(i)] - this->Cells[static_cast<std::size_t>(j)];
        this->HalfSpace(i, j) = this->love(away) / (Pi * fit.site().reducedModulus);
      }
    }
    const Eigen::MatrixXd carry = this->interpolation(fit, radius);
    this->Regular = side * side * carry * fit.values() * carry.transpose();
  }

  /// The force at a depth of the tip, for a tool with the gap f(r). With `withRegular` false: that
  /// on a half-space.
  double force(double depth, const std::function<double(double)>& gap, bool withRegular) const
  {
    const Eigen::MatrixXd whole =
      withRegular ? Eigen::MatrixXd(this->HalfSpace + this->Regular) : this->HalfSpace;
    std::vector<Eigen::Index> active;
    for (std::size_t i = 0; i < this->Cells.size(); ++i)
    {
      if (gap(this->Cells[i].norm()) < depth)
      {
        active.push_back(static_cast<Eigen::Index>(i));
      }
    }
    for (int turn = 0; turn < 50; ++turn)
    {
      const auto n = static_cast<Eigen::Index>(active.size());
      Eigen::MatrixXd system(n, n);
      Eigen::VectorXd sinks(n);
      for (Eigen::Index i = 0; i < n; ++i)
      {
        const auto cell = active[static_cast<std::size_t>(i)];
        sinks[i] = depth - gap(this->Cells[static_cast<std::size_t>(cell)].norm());
        for (Eigen::Index j = 0; j < n; ++j)
        {
          system(i, j) = whole(cell, active[static_cast<std::size_t>(j)]);
        }
      }
      const Eigen::VectorXd pressure = system.partialPivLu().solve(sinks);
      std::vector<Eigen::Index> kept;
      for (Eigen::Index i = 0; i < n; ++i)
      {
        if (pressure[i] > 0.0)
        {
          kept.push_back(active[static_cast<std::size_t>(i)]);
        }
      }
      if (kept.size() == active.size())
      {
        return pressure.sum() * this->Side * this->Side;
      }
      // removed cells do not return: the contact begins as f < depth and only shrinks
      active = kept;
    }
    return NotANumber;
  }

private:
  /// Displacement at `at`, measured from the centre of a square under unit pressure, divided by
  /// 1/(πE*); Love 1929.
  double love(const Eigen::Vector2d& at) const
  {
    const double h = 0.5 * this->Side;
    const auto corner = [](double x, double y)
    {
      const double r = std::hypot(x, y);
      return (x != 0.0 ? x * std::log(y + r) : 0.0) + (y != 0.0 ? y * std::log(x + r) : 0.0);
    };
    return corner(at[0] + h, at[1] + h) + corner(at[0] - h, at[1] - h) -
      corner(at[0] + h, at[1] - h) - corner(at[0] - h, at[1] + h);
  }

  /// Interpolates from the points of the fit to the cells by a polynomial of degree 6, or of degree
  /// 4 for few points.
  Eigen::MatrixXd interpolation(const ContactKernelFit& fit, double radius) const
  {
    const int degree = fit.points().size() > 40 ? 6 : 4;
    const auto powers = [&](const Eigen::Vector2d& at)
    {
      std::vector<double> terms;
      for (int d = 0; d <= degree; ++d)
      {
        for (int k = 0; k <= d; ++k)
        {
          terms.push_back(std::pow(at[0] / radius, d - k) * std::pow(at[1] / radius, k));
        }
      }
      return Eigen::RowVectorXd(Eigen::Map<const Eigen::RowVectorXd>(
        terms.data(), static_cast<Eigen::Index>(terms.size())));
    };
    const auto points = static_cast<Eigen::Index>(fit.points().size());
    const Eigen::Index terms = (degree + 1) * (degree + 2) / 2;
    Eigen::MatrixXd system(points, terms);
    Eigen::MatrixXd wanted(static_cast<Eigen::Index>(this->Cells.size()), terms);
    for (Eigen::Index i = 0; i < points; ++i)
    {
      system.row(i) = powers(fit.points()[static_cast<std::size_t>(i)].at);
    }
    for (Eigen::Index i = 0; i < wanted.rows(); ++i)
    {
      wanted.row(i) = powers(this->Cells[static_cast<std::size_t>(i)]);
    }
    return wanted *
      Eigen::MatrixXd(
        system.colPivHouseholderQr().solve(Eigen::MatrixXd::Identity(points, points)));
  }

  double Side;
  std::vector<Eigen::Vector2d> Cells;
  Eigen::MatrixXd HalfSpace;
  Eigen::MatrixXd Regular;
};
} // namespace palpate::testing

#endif

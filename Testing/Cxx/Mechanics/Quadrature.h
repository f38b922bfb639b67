// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_Quadrature_h
#define palpate_testing_Quadrature_h

#include "Mechanics/Numerics/Constants.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace palpate::testing
{
/**
 * The tests' own Gauss-Legendre rule: nodes by Newton's method on the three-term recurrence of the
 * Legendre polynomials (the library computes them from an eigenvalue problem).
 */
class Quadrature
{
public:
  explicit Quadrature(int nodes)
  {
    for (int i = 1; i <= nodes; ++i)
    {
      double x = std::cos(Pi * (i - 0.25) / (nodes + 0.5));
      double slope = 0.0;
      for (int iteration = 0; iteration < 20; ++iteration)
      {
        double previous = 1.0;
        double value = x;
        for (int k = 2; k <= nodes; ++k)
        {
          const double next = ((2 * k - 1) * x * value - (k - 1) * previous) / k;
          previous = value;
          value = next;
        }
        slope = nodes * (x * value - previous) / (x * x - 1.0);
        x -= value / slope;
      }
      this->Nodes.push_back(x);
      this->Weights.push_back(2.0 / ((1.0 - x * x) * slope * slope));
    }
  }

  template <class Function>
  double integrate(double a, double b, Function&& f) const
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < this->Nodes.size(); ++i)
    {
      sum += this->Weights[i] * f(0.5 * (a + b) + 0.5 * (b - a) * this->Nodes[i]);
    }
    return 0.5 * (b - a) * sum;
  }

  /// Calls visit(node, weight) for each node of the rule on [0, 1].
  template <class Visit>
  void forEachNode(Visit&& visit) const
  {
    for (std::size_t i = 0; i < this->Nodes.size(); ++i)
    {
      visit(0.5 * (1.0 + this->Nodes[i]), 0.5 * this->Weights[i]);
    }
  }

private:
  std::vector<double> Nodes;
  std::vector<double> Weights;
};
} // namespace palpate::testing

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ProfileQuadrature_h
#define palpate_ProfileQuadrature_h

#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Mechanics/Numerics/GaussLegendre.h"
#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/**
 * Quadrature of smooth functions times the reduced profile g of a tool, over contacts [0, a].
 *
 * The interval is divided at the kinks of g. After a kink b, g may start like √(x-b). Therefore the
 * panel [b, c] is mapped by x = b + (c-b) u², which makes the integrand smooth. Panels that are
 * always completely inside a contact are evaluated once, in the constructor.
 */
class PALPATE_EXPORT ProfileQuadrature
{
public:
  /// `tool` must outlive the quadrature.
  explicit ProfileQuadrature(const AxisymmetricTool& tool);

  /// Returns whether g has a kink below a. If not, any rule on [0, a] is suitable.
  bool kinkedBelow(double a) const noexcept { return !this->Kinks.empty() && this->Kinks[0] < a; }

  /// Calls visit(x, weight, g(x)) for each node of the rule over [0, a].
  template <class Visit>
  void visit(double a, Visit&& visit) const
  {
    std::size_t panel = 0;
    for (; panel < this->Kinks.size() && this->Kinks[panel] <= a; ++panel)
    {
      const std::size_t first = panel * static_cast<std::size_t>(this->Rule.nodes().size());
      for (std::size_t i = first; i < first + static_cast<std::size_t>(this->Rule.nodes().size());
           ++i)
      {
        visit(this->Nodes[i].x, this->Nodes[i].weight, this->Nodes[i].profile);
      }
    }
    const double begin = panel == 0 ? 0.0 : this->Kinks[panel - 1];
    if (begin < a)
    {
      for (Eigen::Index i = 0; i < this->Rule.nodes().size(); ++i)
      {
        const Node node = this->nodeOf(begin, a, i);
        visit(node.x, node.weight, node.profile);
      }
    }
  }

private:
  struct Node
  {
    double x;
    double weight;
    double profile;
  };
  Node nodeOf(double begin, double end, Eigen::Index i) const;

  const AxisymmetricTool& Tool;
  std::vector<double> Kinks;
  GaussLegendre Rule;
  std::vector<Node> Nodes; ///< nodes of the panels between kinks, ascending
};
} // namespace palpate

#endif

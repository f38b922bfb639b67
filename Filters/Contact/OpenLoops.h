// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_OpenLoops_h
#define palpate_OpenLoops_h

#include <Eigen/Core>

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace palpate
{
/// Open edges of a surface, connected into loops at their common points.
class OpenLoops
{
public:
  void add(std::int32_t from, std::int32_t to)
  {
    this->Edges.push_back({ from, to });
    const std::int32_t one = this->rootOf(from);
    this->Above[one] = this->rootOf(to);
  }
  /// Calls visit(from, to, centre of the edge's loop) for each edge.
  template <class Place, class Visit>
  void visit(const Place& place, const Visit& visit)
  {
    struct Sum
    {
      Eigen::Vector3d moment = Eigen::Vector3d::Zero();
      double length = 0.0;
    };
    std::unordered_map<std::int32_t, Sum> sums;
    for (const auto& [from, to] : this->Edges)
    {
      const double length = (place(to) - place(from)).norm();
      Sum& sum = sums[this->rootOf(from)];
      sum.moment += 0.5 * length * (place(from) + place(to));
      sum.length += length;
    }
    for (const auto& [from, to] : this->Edges)
    {
      const Sum& sum = sums[this->rootOf(from)];
      visit(from, to, sum.length > 0.0 ? Eigen::Vector3d(sum.moment / sum.length) : place(from));
    }
  }

private:
  std::int32_t rootOf(std::int32_t point)
  {
    this->Above.emplace(point, point);
    while (this->Above[point] != point)
    {
      point = this->Above[point] = this->Above[this->Above[point]];
    }
    return point;
  }

  std::vector<std::pair<std::int32_t, std::int32_t>> Edges;
  std::unordered_map<std::int32_t, std::int32_t> Above;
};
} // namespace palpate

#endif

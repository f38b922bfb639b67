// SPDX-License-Identifier: BSD-3-Clause
#ifndef RelaxationList_h
#define RelaxationList_h

#include "Mechanics/Relaxation/PronySeries.h"

#include "Mechanics/Checked.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace palpate
{
/// List of the branches of a relaxation, each with a strength and a time (s). The user of a filter
/// sets the branches one by one. The list accepts any number of branches and any values;
/// fillSeries() checks them.
class RelaxationList
{
public:
  void add(double strength, double seconds) { this->Branches.push_back({ strength, seconds }); }
  /// Replaces a branch, or appends one. Returns whether the list changed.
  bool set(int place, double strength, double seconds)
  {
    const std::array<double, 2> next{ strength, seconds };
    if (place == this->count())
    {
      this->Branches.push_back(next);
      return true;
    }
    if (!this->has(place) || this->at(place) == next)
    {
      return false;
    }
    this->Branches[static_cast<std::size_t>(place)] = next;
    return true;
  }
  /// Removes all branches. Returns whether there were any branches.
  bool clear()
  {
    const bool had = !this->Branches.empty();
    this->Branches.clear();
    return had;
  }

  int count() const { return static_cast<int>(this->Branches.size()); }
  /// Returns the strength of a branch; 0 if the branch does not exist.
  double strength(int place) const { return this->has(place) ? this->at(place)[0] : 0.0; }
  double seconds(int place) const { return this->has(place) ? this->at(place)[1] : 0.0; }

  /// Returns a list of the branches whose strength is not 0.
  RelaxationList effectiveBranches() const
  {
    RelaxationList some;
    for (const auto& [strength, seconds] : this->Branches)
    {
      if (strength != 0.0)
      {
        some.add(strength, seconds);
      }
    }
    return some;
  }

  /// Copies the branches to the series. Returns "" or an error that names an invalid branch.
  std::string fillSeries(PronySeries& series) const
  {
    series = {};
    if (this->Branches.size() > PronySeries::LargestCount)
    {
      return "Relaxations: a body has at most " + std::to_string(PronySeries::LargestCount) +
        " of them, but there are " + std::to_string(this->Branches.size());
    }
    for (const auto& [strength, seconds] : this->Branches)
    {
      series.add(strength, seconds);
    }
    return prefixed("Relaxations: ", faultOfRelaxation(series));
  }

private:
  bool has(int place) const { return place >= 0 && place < this->count(); }
  const std::array<double, 2>& at(int place) const
  {
    return this->Branches[static_cast<std::size_t>(place)];
  }

  std::vector<std::array<double, 2>> Branches;
};
} // namespace palpate

#endif

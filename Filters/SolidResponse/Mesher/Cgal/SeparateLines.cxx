// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Mesher/Cgal/SeparateLines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace palpate
{
namespace
{
// The following lengths are in units of the cells' edge length.
constexpr double LeastSide = 0.25;
constexpr double LeastDistance = 1.0;
constexpr double LeastPart = 3.0;
// Smallest ratio of the distance between two positions to the length of the path between them along
// the lines.
constexpr double LeastOfPath = 0.5;

/// Returns the line without the points that are closer than `least` to the previous point. Both
/// ends of the line are kept.
Line withoutShortSides(const Line& line, double least)
{
  Line made = { line.front() };
  for (std::size_t i = 1; i + 1 < line.size(); ++i)
  {
    if ((line[i] - made.back()).norm() >= least)
    {
      made.push_back(line[i]);
    }
  }
  if (made.size() > 1 && (line.back() - made.back()).norm() < least)
  {
    made.pop_back();
  }
  made.push_back(line.back());
  return made;
}

/// A position on a line.
struct Place
{
  Eigen::Vector3d at;
  std::size_t line;
  std::size_t side;
  double along; ///< distance from the line's first point, mm
};

class Separation
{
public:
  Separation(const std::vector<Line>& lines, double length)
    : Length(length)
  {
    for (const Line& line : lines)
    {
      if (line.size() > 1)
      {
        this->Lines.push_back(withoutShortSides(line, LeastSide * length));
      }
    }
    for (std::size_t l = 0; l < this->Lines.size(); ++l)
    {
      this->sample(l);
    }
    this->findNear();
  }

  std::vector<Line> parts() const
  {
    std::vector<Line> made;
    for (std::size_t l = 0; l < this->Lines.size(); ++l)
    {
      const Line& line = this->Lines[l];
      Line part;
      double total = 0.0;
      const auto end = [&]()
      {
        if (total >= LeastPart * this->Length)
        {
          made.push_back(part);
        }
        part.clear();
        total = 0.0;
      };
      for (std::size_t side = 0; side + 1 < line.size(); ++side)
      {
        if (this->IsNear[l][side])
        {
          end();
          continue;
        }
        if (part.empty())
        {
          part.push_back(line[side]);
        }
        part.push_back(line[side + 1]);
        total += (line[side + 1] - line[side]).norm();
      }
      end();
    }
    return made;
  }

private:
  void sample(std::size_t l)
  {
    const Line& line = this->Lines[l];
    double along = 0.0;
    for (std::size_t side = 0; side + 1 < line.size(); ++side)
    {
      const Eigen::Vector3d step = line[side + 1] - line[side];
      const double length = step.norm();
      const int count = 1 + static_cast<int>(length / (LeastSide * this->Length));
      for (int k = 0; k < count; ++k)
      {
        const double part = (k + 0.5) / count;
        this->Places.push_back({ line[side] + part * step, l, side, along + part * length });
      }
      along += length;
    }
    this->Totals.push_back(along);
    this->IsNear.emplace_back(line.size() - 1, false);
  }

  /// Returns the length of the path along the lines between two positions. It is infinite if the
  /// lines do not meet.
  double path(const Place& a, const Place& b) const
  {
    double least =
      a.line == b.line ? std::abs(a.along - b.along) : std::numeric_limits<double>::infinity();
    const Line& one = this->Lines[a.line];
    const Line& other = this->Lines[b.line];
    for (const bool fromBack : { false, true })
    {
      for (const bool toBack : { false, true })
      {
        if ((fromBack ? one.back() : one.front()) == (toBack ? other.back() : other.front()))
        {
          const double before = fromBack ? this->Totals[a.line] - a.along : a.along;
          least = std::min(least, before + (toBack ? this->Totals[b.line] - b.along : b.along));
        }
      }
    }
    return least;
  }

  void findNear()
  {
    std::sort(this->Places.begin(), this->Places.end(),
      [](const Place& a, const Place& b) { return a.at.x() < b.at.x(); });
    const double least = LeastDistance * this->Length;
    for (auto a = this->Places.begin(); a != this->Places.end(); ++a)
    {
      for (auto b = a + 1; b != this->Places.end() && b->at.x() - a->at.x() < least; ++b)
      {
        const double distance = (a->at - b->at).norm();
        if (distance < least && distance < LeastOfPath * this->path(*a, *b))
        {
          this->IsNear[a->line][a->side] = this->IsNear[b->line][b->side] = true;
        }
      }
    }
  }

  double Length;
  std::vector<Line> Lines;
  std::vector<double> Totals; ///< length of each line, mm
  std::vector<Place> Places;
  /// Whether a segment is too close to another segment, for each line and each segment.
  std::vector<std::vector<bool>> IsNear;
};
} // namespace

std::vector<Line> separateLines(const std::vector<Line>& lines, double length)
{
  return Separation(lines, length).parts();
}
} // namespace palpate

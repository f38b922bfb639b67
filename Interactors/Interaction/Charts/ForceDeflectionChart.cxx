// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Charts/ForceDeflectionChart.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr const char* DeflectionColumn = "Deflection (mm)";
} // namespace

ForceDeflectionChart::ForceDeflectionChart()
  : LiveChart("Force over deflection, this touch", DeflectionColumn, "Force (N)")
  , Ideal(DeflectionColumn, "Ideal force (N)")
  , Applied(DeflectionColumn, "Applied force (N)")
  , Slow(DeflectionColumn, "Slow force (N)")
  , Now(DeflectionColumn, "Ideal force now (N)")
{
  this->Ideal.addLine(this->chart(), "Ideal", ForceColor, 4.0F);
  this->AppliedPlot = this->Applied.addLine(this->chart(), "Applied", AppliedForceColor, 2.0F);
  this->AppliedPlot->SetVisible(false);
  this->SlowPlot = this->Slow.addLine(this->chart(), "Slow", NormalForceColor, 2.0F);
  this->SlowPlot->SetVisible(false);
  this->Now.addMarker(this->chart(), "Now", ForceColor, 11.0F);
}

bool ForceDeflectionChart::isNear(const Point& one, const Point& other) const
{
  const double across = Resolution * this->endAcross();
  const double up = Resolution * this->endUp();
  return std::abs(one.deflection - other.deflection) < across &&
    std::abs(one.ideal - other.ideal) < up &&
    // The comparison with NaN gives true; NaN means that no force is applied.
    !(std::abs(one.applied - other.applied) >= up);
}

void ForceDeflectionChart::add(
  bool touches, double deflection, double ideal, double applied, double slow)
{
  if (touches && !this->Touches)
  {
    this->Path.clear();
  }
  this->Touches = touches;
  if (std::isfinite(applied))
  {
    this->AppliedPlot->SetVisible(true);
  }
  if (!touches)
  {
    return;
  }
  if (slow != ideal)
  {
    this->SlowPlot->SetVisible(true);
  }
  const Point point{ deflection, ideal, applied, slow };
  const std::size_t count = this->Path.size();
  if (count > 1 && this->isNear(this->Path[count - 2], point))
  {
    this->Path.back() = point;
  }
  else
  {
    this->Path.push_back(point);
  }
  if (this->Path.size() > LargestCount)
  {
    this->Path.pop_front();
  }
}

void ForceDeflectionChart::clear()
{
  this->Path.clear();
  this->Touches = false;
  this->AppliedPlot->SetVisible(false);
  this->SlowPlot->SetVisible(false);
  this->show(std::numeric_limits<double>::quiet_NaN());
}

void ForceDeflectionChart::show(double time)
{
  double deepest = 0.0;
  double largest = 0.0;
  this->Slow.begin();
  this->Ideal.begin();
  this->Applied.begin();
  for (const Point& point : this->Path)
  {
    this->Slow.add(point.deflection, point.slow);
    this->Ideal.add(point.deflection, point.ideal);
    this->Applied.add(point.deflection, point.applied);
    deepest = std::max(deepest, point.deflection);
    largest = std::max({ largest, point.ideal, point.applied, point.slow });
  }
  this->fitAcross(deepest, time);
  this->fitUp(largest, time);
  this->Slow.end();
  this->Ideal.end();
  this->Applied.end();
  this->Now.begin();
  if (this->Touches && !this->Path.empty())
  {
    this->Now.add(this->Path.back().deflection, this->Path.back().ideal);
  }
  this->Now.end();
}
} // namespace palpate

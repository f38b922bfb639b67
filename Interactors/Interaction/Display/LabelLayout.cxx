// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/LabelLayout.h"

#include "Interaction/Display/SceneView.h"

#include "vtkActor2D.h"
#include "vtkBoundingBox.h"
#include "vtkBox.h"
#include "vtkCoordinate.h"
#include "vtkMath.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkTextActor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace palpate
{
namespace
{
// Smallest distance between texts, and between a text and an obstacle, pixels.
constexpr double Spacing = 2.0;
constexpr double HeadDistance = 10.0; // smallest distance of a text from the head, pixels
// Distance between successive rings of candidate positions around the head, pixels.
constexpr double DistanceStep = 6.0;
constexpr int Directions = 16; // number of candidate positions in a ring
// Pixels by which another position must be nearer to the head.
constexpr double SteadyDistance = 40.0;
constexpr double WrongSide = 20.0; // pixels, cost of a position on the side away from the arrow
constexpr double SideLess = 4.0;   // pixels; for a shorter arrow no side is preferred
// Pixels, cost of a covered obstacle; larger than any distance.
constexpr double CoveredObstacle = 1e5;
constexpr double NoPlace = std::numeric_limits<double>::infinity();

/// The box of a text, in pixels of the window.
struct Box
{
  Eigen::Vector2d low;
  Eigen::Vector2d size;

  Eigen::Vector2d high() const { return this->low + this->size; }
  bool covers(const Box& other) const
  {
    return (this->low.array() < other.high().array()).all() &&
      (other.low.array() < this->high().array()).all();
  }
  bool isInside(const Box& other) const
  {
    return (this->low.array() >= other.low.array()).all() &&
      (this->high().array() <= other.high().array()).all();
  }
  double distanceTo(const Eigen::Vector2d& point) const
  {
    return (point - point.cwiseMax(this->low).cwiseMin(this->high())).norm();
  }
};

/// A line of half width `radius`, in pixels of the window.
struct Bar
{
  Eigen::Vector2d from;
  Eigen::Vector2d to;
  double radius;

  /// Whether the line, including its half width, intersects the box.
  bool covers(const Box& box) const
  {
    const Eigen::Vector2d low = box.low.array() - this->radius - Spacing;
    const Eigen::Vector2d high = box.high().array() + this->radius + Spacing;
    const vtkBoundingBox grown(low.x(), high.x(), low.y(), high.y(), -1.0, 1.0);
    if (grown.ContainsPoint(this->from.x(), this->from.y(), 0.0))
    {
      return true;
    }
    std::array<double, 6> bounds{};
    grown.GetBounds(bounds.data());
    const std::array<double, 3> begin{ this->from.x(), this->from.y(), 0.0 };
    const std::array<double, 3> way{ this->to.x() - begin[0], this->to.y() - begin[1], 0.0 };
    std::array<double, 3> hit{};
    double share = 0.0;
    return vtkBox::IntersectBox(bounds.data(), begin.data(), way.data(), hit.data(), share) != 0;
  }
};

Eigen::Vector3d toDisplay(vtkRenderer* renderer, const Eigen::Vector3d& world)
{
  renderer->SetWorldPoint(world.x(), world.y(), world.z(), 1.0);
  renderer->WorldToDisplay();
  Eigen::Vector3d display;
  renderer->GetDisplayPoint(display.data());
  return display;
}

Eigen::Vector3d toWorld(vtkRenderer* renderer, const Eigen::Vector3d& display)
{
  renderer->SetDisplayPoint(display.data());
  renderer->DisplayToWorld();
  Eigen::Vector4d world;
  renderer->GetWorldPoint(world.data());
  return world.head<3>() / world.w();
}

/// Returns the boxes of the visible texts and legends among the props of a renderer. The labels of
/// arrows are not included, because they are parts of an assembly.
std::vector<Box> captionsOf(vtkRenderer* renderer)
{
  std::vector<Box> boxes;
  const Eigen::Vector2d origin(renderer->GetOrigin()[0], renderer->GetOrigin()[1]);
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator place;
  props->InitTraversal(place);
  while (vtkProp* prop = props->GetNextProp(place))
  {
    auto* actor = vtkActor2D::SafeDownCast(prop);
    if (!actor || !actor->GetVisibility())
    {
      continue;
    }
    const int* at = actor->GetPositionCoordinate()->GetComputedViewportValue(renderer);
    const Eigen::Vector2d begin = origin + Eigen::Vector2d(at[0], at[1]);
    if (auto* text = vtkTextActor::SafeDownCast(actor))
    {
      std::array<double, 4> reach{};
      text->GetBoundingBox(renderer, reach.data());
      boxes.push_back({ begin + Eigen::Vector2d(reach[0], reach[2]),
        { reach[1] - reach[0], reach[3] - reach[2] } });
    }
    else if (vtkScalarBarActor::SafeDownCast(actor))
    {
      const int* end = actor->GetPosition2Coordinate()->GetComputedViewportValue(renderer);
      boxes.push_back({ begin, origin + Eigen::Vector2d(end[0], end[1]) - begin });
    }
  }
  return boxes;
}

/// Searches the position of one text.
class PlaceSearch
{
public:
  PlaceSearch(const Box& window, const std::vector<Box>& texts, const std::vector<Bar>& bars,
    const std::vector<Box>& captions, const Eigen::Vector2d& head, const Eigen::Vector2d& size,
    bool leftwards)
    : Window(window)
    , Texts(texts)
    , Bars(bars)
    , Captions(captions)
    , Head(head)
    , Size(size)
    , Side(leftwards ? -1.0 : 1.0)
    // The first candidate is on the side to which the arrow points, at the height of the head.
    , Best{ head + Eigen::Vector2d(leftwards ? -HeadDistance - size.x() : HeadDistance, 0.0), size }
  {
  }

  /// Returns the best box. `last` is the position in the last picture, if that position is to be
  /// preferred.
  Box find(const std::optional<Eigen::Vector2d>& last)
  {
    this->consider(Box(this->Best), 0.0);
    const double farthest = this->Window.size.norm();
    for (double away = HeadDistance; away < std::min(farthest, this->LeastCost);
         away += DistanceStep)
    {
      for (int i = 0; i < Directions; ++i)
      {
        this->considerAround(2.0 * vtkMath::Pi() * i / Directions, away);
      }
    }
    if (last)
    {
      const Box box{ this->Head + *last, this->Size };
      this->consider(box, box.distanceTo(this->Head) - SteadyDistance);
    }
    return this->Best;
  }

private:
  /// Evaluates the box whose centre is in the direction `angle` from the head, at a distance of
  /// `away` pixels between head and box.
  void considerAround(double angle, double away)
  {
    const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
    const double half = 0.5 * direction.cwiseAbs().dot(this->Size);
    const Eigen::Vector2d centre = this->Head + (away + half) * direction;
    const double turned = direction.dot(Eigen::Vector2d(0.8 * this->Side, 0.6));
    this->consider(
      { centre - 0.5 * this->Size, this->Size }, away + 0.5 * WrongSide * (1.0 - turned));
  }

  void consider(const Box& box, double cost)
  {
    const auto isCovered = [&box](const auto& other) { return other.covers(box); };
    if (!(cost < this->LeastCost) || !box.isInside(this->Window) ||
      std::any_of(this->Texts.begin(), this->Texts.end(), isCovered))
    {
      return;
    }
    cost += CoveredObstacle *
      static_cast<double>(std::count_if(this->Bars.begin(), this->Bars.end(), isCovered) +
        std::count_if(this->Captions.begin(), this->Captions.end(), isCovered));
    if (cost < this->LeastCost)
    {
      this->LeastCost = cost;
      this->Best = box;
    }
  }

  const Box& Window;
  const std::vector<Box>& Texts;
  const std::vector<Bar>& Bars;
  const std::vector<Box>& Captions;
  Eigen::Vector2d Head;
  Eigen::Vector2d Size;
  double Side;
  /// Initially the first candidate. It is used if every position in the window would cover an
  /// earlier text.
  Box Best;
  double LeastCost = NoPlace;
};
} // namespace

void arrangeLabels(vtkRenderer* renderer, const std::vector<AnchoredLabel>& labels,
  const std::vector<LabelObstacle>& obstacles, bool steady)
{
  const int* origin = renderer->GetOrigin();
  const int* extent = renderer->GetSize();
  const Box window{ { origin[0] + Spacing, origin[1] + Spacing },
    { extent[0] - 2.0 * Spacing, extent[1] - 2.0 * Spacing } };
  std::vector<Bar> bars;
  for (const LabelObstacle& obstacle : obstacles)
  {
    const Bar bar{ toDisplay(renderer, obstacle.from).head<2>(),
      toDisplay(renderer, obstacle.to).head<2>(),
      obstacle.radius * pixelsPerMillimetre(renderer, 0.5 * (obstacle.from + obstacle.to)) };
    if (bar.from.allFinite() && bar.to.allFinite() && std::isfinite(bar.radius))
    {
      bars.push_back(bar);
    }
  }
  const std::vector<Box> captions = captionsOf(renderer);
  std::vector<Box> placed;
  for (const AnchoredLabel& label : labels)
  {
    std::array<double, 2> size{};
    label.text->GetSize(renderer, size.data());
    const Eigen::Vector3d head = toDisplay(renderer, label.head);
    const double back = toDisplay(renderer, label.tail).x() - head.x();
    PlaceSearch search(window, placed, bars, captions, head.head<2>(), Eigen::Vector2d(size.data()),
      back > SideLess);
    const bool remains = steady && label.place->isKnown;
    const Box box =
      search.find(remains ? std::optional<Eigen::Vector2d>(label.place->offset) : std::nullopt);
    *label.place = { true, box.low - head.head<2>() };
    placed.push_back(box);
    const Eigen::Vector3d place = toWorld(renderer, { box.low.x(), box.low.y(), head.z() });
    label.text->GetPositionCoordinate()->SetValue(place.data());
  }
}
} // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/LabelLayout.h"

#include "vtkCoordinate.h"
#include "vtkTextActor.h"
#include "vtkViewport.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double Spacing = 2.0;       // pixels, between texts
constexpr double HeadDistance = 10.0; // pixels, from the head

/// The box of a text, in pixels of the window.
struct Box
{
  double left;
  double bottom;
  double width;
  double height;

  bool covers(const Box& other) const
  {
    return this->left < other.left + other.width && other.left < this->left + this->width &&
      this->bottom < other.bottom + other.height && other.bottom < this->bottom + this->height;
  }
};

/// Returns the bottom, nearest to the present one, at which `box` covers none of the others.
double freeHeight(const Box& box, const std::vector<Box>& others)
{
  const auto isFree = [&](double bottom)
  {
    Box moved = box;
    moved.bottom = bottom;
    return std::none_of(
      others.begin(), others.end(), [&](const Box& other) { return moved.covers(other); });
  };
  std::vector<double> heights{ box.bottom };
  for (const Box& other : others)
  {
    heights.push_back(other.bottom - box.height - Spacing);
    heights.push_back(other.bottom + other.height + Spacing);
  }
  std::stable_sort(heights.begin(), heights.end(),
    [&](double a, double b) { return std::abs(a - box.bottom) < std::abs(b - box.bottom); });
  const auto found = std::find_if(heights.begin(), heights.end(), isFree);
  return found == heights.end() ? box.bottom : *found;
}

Eigen::Vector3d toDisplay(vtkViewport* viewport, const Eigen::Vector3d& world)
{
  viewport->SetWorldPoint(world.x(), world.y(), world.z(), 1.0);
  viewport->WorldToDisplay();
  Eigen::Vector3d display;
  viewport->GetDisplayPoint(display.data());
  return display;
}

Eigen::Vector3d toWorld(vtkViewport* viewport, const Eigen::Vector3d& display)
{
  viewport->SetDisplayPoint(display.data());
  viewport->DisplayToWorld();
  Eigen::Vector4d world;
  viewport->GetWorldPoint(world.data());
  return world.head<3>() / world.w();
}
} // namespace

void arrangeLabels(vtkViewport* viewport, const std::vector<AnchoredLabel>& labels)
{
  const int* origin = viewport->GetOrigin();
  const int* extent = viewport->GetSize();
  std::vector<Box> placed;
  for (const AnchoredLabel& label : labels)
  {
    std::array<double, 2> size{};
    label.text->GetSize(viewport, size.data());
    const Eigen::Vector3d head = toDisplay(viewport, label.head);
    Box box{ head.x(), head.y(), size[0], size[1] };
    Eigen::Vector3d place = label.head;
    if (!placed.empty())
    {
      const bool leftwards = head.x() < toDisplay(viewport, label.tail).x();
      const double left = head.x() + (leftwards ? -box.width - HeadDistance : HeadDistance);
      const double rightmost = origin[0] + extent[0] - box.width - Spacing;
      box.left = std::max(origin[0] + Spacing, std::min(left, rightmost));
      box.bottom = freeHeight(box, placed);
      place = toWorld(viewport, { box.left, box.bottom, head.z() });
    }
    placed.push_back(box);
    label.text->GetPositionCoordinate()->SetValue(place.data());
  }
}
} // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#ifndef LabelLayout_h
#define LabelLayout_h

#include <Eigen/Core>

#include <vector>

class vtkRenderer;
class vtkTextActor;

namespace palpate
{
/// Where a label stood in the last picture: its lower left corner relative to the head of its
/// arrow, pixels.
struct LabelPlace
{
  bool isKnown = false;
  Eigen::Vector2d offset = Eigen::Vector2d::Zero();
};

/// A text that belongs to the head of an arrow.
struct AnchoredLabel
{
  vtkTextActor* text; ///< positioned in world coordinates
  Eigen::Vector3d tail;
  Eigen::Vector3d head;
  LabelPlace* place;
};

/// A part of the scene that labels leave free: all points within `radius` (mm) of a line.
struct LabelObstacle
{
  Eigen::Vector3d from;
  Eigen::Vector3d to;
  double radius;
};

/// Places each text near the head of its arrow, on the side to which the arrow points. A text stays
/// inside the viewport. It covers neither an earlier text nor an obstacle, nor a caption or legend
/// among the renderer's props: it stands at the nearest free place around the head. Without any
/// free place it covers as few of these as possible, but no earlier text.
///
/// With `steady`, a text remains where it stood relative to its head until another place is nearer
/// by SteadyDistance pixels or its own place is no longer free.
void arrangeLabels(vtkRenderer* renderer, const std::vector<AnchoredLabel>& labels,
  const std::vector<LabelObstacle>& obstacles, bool steady);
} // namespace palpate

#endif

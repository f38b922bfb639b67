// SPDX-License-Identifier: BSD-3-Clause
#ifndef LabelLayout_h
#define LabelLayout_h

#include <Eigen/Core>

#include <vector>

class vtkRenderer;
class vtkTextActor;

namespace palpate
{
/// Place of a label in the last picture: its lower left corner relative to the head of its arrow,
/// pixels.
struct LabelPlace
{
  bool isKnown = false;
  Eigen::Vector2d offset = Eigen::Vector2d::Zero();
};

/// A text at the head of an arrow.
struct AnchoredLabel
{
  vtkTextActor* text; ///< positioned in world coordinates
  Eigen::Vector3d tail;
  Eigen::Vector3d head;
  LabelPlace* place;
};

/// A part of the scene that labels must not cover: all points within `radius` (mm) of a line.
struct LabelObstacle
{
  Eigen::Vector3d from;
  Eigen::Vector3d to;
  double radius;
};

/// Places each text near the head of its arrow, on the side to which the arrow points. A text stays
/// inside the viewport. It must not cover an earlier text, an obstacle, or a caption or legend
/// among the props of the renderer. So it is placed at the nearest free place around the head. If
/// there is no free place, the text covers as few of these as possible, but no earlier text.
///
/// With `steady`, a text stays at its place relative to its head. It moves only if another place is
/// nearer by at least SteadyDistance pixels, or if its place is no longer free.
void arrangeLabels(vtkRenderer* renderer, const std::vector<AnchoredLabel>& labels,
  const std::vector<LabelObstacle>& obstacles, bool steady);
} // namespace palpate

#endif

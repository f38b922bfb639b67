// SPDX-License-Identifier: BSD-3-Clause
#ifndef LabelLayout_h
#define LabelLayout_h

#include <Eigen/Core>

#include <vector>

class vtkRenderer;
class vtkTextActor;

namespace palpate
{
/// Position of a label in the last picture: its lower left corner relative to the head of its
/// arrow, pixels.
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

/// A part of the scene that labels must not cover. It consists of all points within `radius` (mm)
/// of a line segment.
struct LabelObstacle
{
  Eigen::Vector3d from;
  Eigen::Vector3d to;
  double radius;
};

/// Places each text near the head of its arrow, on the side to which the arrow points. A text stays
/// inside the viewport. It must not cover an earlier text, an obstacle, or a caption or legend
/// among the props of the renderer. Therefore the text is placed at the nearest free position
/// around the head. If there is no free position, the text covers no earlier text, and as few
/// obstacles, captions and legends as possible.
///
/// With `steady`, a text keeps its position relative to its head. It moves only if another position
/// is nearer by at least SteadyDistance pixels, or if its position is no longer free.
void arrangeLabels(vtkRenderer* renderer, const std::vector<AnchoredLabel>& labels,
  const std::vector<LabelObstacle>& obstacles, bool steady);
} // namespace palpate

#endif

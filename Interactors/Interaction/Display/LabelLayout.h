// SPDX-License-Identifier: BSD-3-Clause
#ifndef LabelLayout_h
#define LabelLayout_h

#include <Eigen/Core>

#include <vector>

class vtkTextActor;
class vtkViewport;

namespace palpate
{
/// A text that belongs to the head of an arrow.
struct AnchoredLabel
{
  vtkTextActor* text; ///< positioned in world coordinates
  Eigen::Vector3d tail;
  Eigen::Vector3d head;
};

/// Places each text next to the head of its arrow, on the side to which the arrow points. A text is
/// then moved by the smallest distance at which it neither covers an earlier text nor leaves the
/// viewport.
void arrangeLabels(vtkViewport* viewport, const std::vector<AnchoredLabel>& labels);
} // namespace palpate

#endif

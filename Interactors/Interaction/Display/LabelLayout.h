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
  vtkTextActor* text; ///< placed in world coordinates
  Eigen::Vector3d tail;
  Eigen::Vector3d head;
};

/// Puts each text beside its head, on the side the arrow points to, moved as little as is needed
/// where it would cover an earlier one or leave the viewport. The first one begins at its head.
void arrangeLabels(vtkViewport* viewport, const std::vector<AnchoredLabel>& labels);
} // namespace palpate

#endif

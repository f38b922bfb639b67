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

/// Places each text beside its arrow's head, on the side the arrow points to, and moves it as
/// little as possible so that it neither covers an earlier one nor leaves the viewport. The first
/// one begins at its head.
void arrangeLabels(vtkViewport* viewport, const std::vector<AnchoredLabel>& labels);
} // namespace palpate

#endif

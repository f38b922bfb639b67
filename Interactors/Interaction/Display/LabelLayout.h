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

/// Puts each text beside its head, on the side the arrow points to, or, where it would cover one
/// before it or leave the viewport, as little off as is needed. The first one begins at its head.
void arrangeLabels(vtkViewport* viewport, const std::vector<AnchoredLabel>& labels);
} // namespace palpate

#endif

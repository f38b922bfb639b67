// SPDX-License-Identifier: BSD-3-Clause
#ifndef EndOnSign_h
#define EndOnSign_h

#include "Interaction/Display/DisplayColors.h"

#include "vtkSmartPointer.h"

#include <Eigen/Core>

class vtkActor2D;
class vtkPolyData;
class vtkRenderer;

namespace palpate
{
/// The sign for an arrow that is seen end-on. An arrow towards the viewer is marked by a ring with
/// a dot, an arrow away from the viewer by a ring with a cross. The diameter of the ring is the
/// length of the arrow as seen from the side, but at least twice SmallestRadius.
class EndOnSign
{
public:
  /// Largest angle between the arrow and the line of sight, degrees, at which the arrow counts as
  /// seen end-on.
  static constexpr double LargestAngle = 20.0;
  static constexpr double SmallestRadius = 8.0; ///< pixels

  explicit EndOnSign(const Color& color);
  ~EndOnSign();
  EndOnSign(const EndOnSign&) = delete;
  EndOnSign& operator=(const EndOnSign&) = delete;

  /// Draws the sign at the head of the arrow if the renderer's camera sees the arrow end-on.
  void show(vtkRenderer* renderer, const Eigen::Vector3d& tail, const Eigen::Vector3d& head);
  void hide();
  bool isShown() const { return this->Radius > 0.0; }

  /// Radius of the ring, mm at the position of the head. 0 if no sign is drawn.
  double radius() const { return this->Radius; }
  vtkActor2D* actor() { return this->Actor; }

private:
  double Radius = 0.0;
  vtkSmartPointer<vtkPolyData> Shape;
  vtkSmartPointer<vtkActor2D> Actor;
};
} // namespace palpate

#endif

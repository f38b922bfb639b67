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
/// The sign of an arrow that is seen end-on. An arrow towards the viewer is marked by a ring with a
/// dot, an arrow away from the viewer by a ring with a cross. The diameter of the ring is the
/// length of the arrow as seen from the side, but at least twice SmallestRadius.
class EndOnSign
{
public:
  /// An arrow is seen end-on if its angle to the line of sight is below this value, degrees.
  static constexpr double LargestAngle = 20.0;
  static constexpr double SmallestRadius = 8.0; ///< pixels

  explicit EndOnSign(const Color& color);
  ~EndOnSign();
  EndOnSign(const EndOnSign&) = delete;
  EndOnSign& operator=(const EndOnSign&) = delete;

  /// Draws the sign at the head of the arrow, if the camera of the renderer sees the arrow end-on.
  void show(vtkRenderer* renderer, const Eigen::Vector3d& tail, const Eigen::Vector3d& head);
  void hide();
  bool isShown() const { return this->Radius > 0.0; }

  /// Radius of the ring, in mm at the place of the head; 0 if no sign is drawn.
  double radius() const { return this->Radius; }
  vtkActor2D* actor() { return this->Actor; }

private:
  double Radius = 0.0;
  vtkSmartPointer<vtkPolyData> Shape;
  vtkSmartPointer<vtkActor2D> Actor;
};
} // namespace palpate

#endif

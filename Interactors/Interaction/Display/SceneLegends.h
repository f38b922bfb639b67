// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneLegends_h
#define SceneLegends_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <Eigen/Core>

#include <string>

class vtkActor2D;
class vtkLookupTable;
class vtkPolyData;
class vtkRenderer;
class vtkScalarBarActor;
class vtkTextActor;

namespace palpate
{
/// The colour scales of a scene, and their legends in a column at the right edge. One legend is for
/// the displacement (mm), one for the force along the trail (N).
class SceneLegends
{
public:
  SceneLegends();
  ~SceneLegends();
  SceneLegends(const SceneLegends&) = delete;
  SceneLegends& operator=(const SceneLegends&) = delete;

  vtkLookupTable* displacementColors() { return this->DisplacementColors; }
  vtkLookupTable* forceColors() { return this->ForceColors; }
  vtkScalarBarActor* displacement() { return this->Displacement; }
  vtkScalarBarActor* force() { return this->Force; }

  /// Sets the end of a scale. The labels are at round steps.
  void setLargestDisplacement(double largest);
  void setLargestForce(double largest);

  /// Whether the title of the displacement's legend explains the contact circle.
  void explainCircle(bool explains);
  /// Adds an explanation of gaps to the title of the trail's legend. If `words` is "", no
  /// explanation is added.
  void explainGaps(const std::string& words);

  /// Fraction of a viewport's width that the column of legends occupies.
  static double share(vtkRenderer* renderer);
  /// Places the legends. `captionHeight` is the height of the caption below the legends, pixels.
  void place(vtkRenderer* renderer, double captionHeight);

private:
  vtkNew<vtkLookupTable> DisplacementColors;
  vtkNew<vtkLookupTable> ForceColors;
  vtkNew<vtkScalarBarActor> Displacement;
  vtkNew<vtkScalarBarActor> Force;
};

/// The scale of the force arrows. It is an arrow in the lower right corner of the picture for a
/// round number of newtons. Its length is that of an arrow for this force at the contact,
/// perpendicular to the line of sight. After setChanged(true) it also shows the remark that the
/// scale has changed.
class ForceScale
{
public:
  ForceScale();
  ~ForceScale();
  ForceScale(const ForceScale&) = delete;
  ForceScale& operator=(const ForceScale&) = delete;

  /// Chooses the force of the arrow, a round number near half of `largestForce` (N). `scale` is the
  /// length of arrows per force, mm/N.
  void choose(double largestForce, double scale);
  /// Adapts the arrow to the camera. If the arrow would be longer than a third of the picture's
  /// width, the next smaller round number is used.
  void place(vtkRenderer* renderer, const Eigen::Vector3d& contact);
  void setVisibility(bool visible);
  void setChanged(bool changed) { this->IsChanged = changed; }

  double force() const { return this->Force; } ///< the chosen force, N
  /// Width of the arrow in the picture, pixels.
  double width() const { return this->Width; }
  vtkActor2D* arrow() { return this->Arrow; }
  vtkTextActor* label() { return this->Label; }

private:
  double Force = 1.0;
  double Scale = 1.0;
  double Width = 0.0;
  bool IsChanged = false;
  vtkSmartPointer<vtkPolyData> Shape;
  vtkSmartPointer<vtkActor2D> Arrow;
  vtkSmartPointer<vtkTextActor> Label;
};
} // namespace palpate

#endif

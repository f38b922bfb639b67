// SPDX-License-Identifier: BSD-3-Clause
#ifndef ForceArrow_h
#define ForceArrow_h

#include "Interaction/Display/DisplayColors.h"
#include "Interaction/Display/LabelLayout.h"

#include "vtkSmartPointer.h"

#include <Eigen/Core>

#include <string>
#include <vector>

class vtkActor;
class vtkAppendPolyData;
class vtkArcSource;
class vtkConeSource;
class vtkTextActor;
class vtkTubeFilter;

namespace palpate
{
/// Style of an arrow: radius of the shaft, radius and length of the head, mm. The head is at most
/// 40 % of the arrow's length; head and shaft of a very short arrow are thinner.
struct ArrowLook
{
  Color color;
  double shaftRadius;
  double headRadius;
  double headLength;
  int labelSize; ///< points
  bool bold;
  double labelOpacity; ///< opacity of the background of the label
};

/// One force, drawn as an arrow with its value in N at the head.
class ForceArrow
{
public:
  explicit ForceArrow(const ArrowLook& look);
  ~ForceArrow();
  ForceArrow(const ForceArrow&) = delete;
  ForceArrow& operator=(const ForceArrow&) = delete;

  /// Draws the arrow from `origin` (mm) with `scale` mm per N. The label consists of `name` and the
  /// magnitude. Draws nothing if the force is zero or not finite.
  void show(const Eigen::Vector3d& origin, const Eigen::Vector3d& force, double scale, bool dashed,
    const std::string& name = "");
  void hide();
  bool isShown() const;
  /// Moves the arrow to another origin.
  void moveTo(const Eigen::Vector3d& origin);

  Eigen::Vector3d tail() const { return this->Head - this->ArrowVector; }
  const Eigen::Vector3d& head() const { return this->Head; }
  vtkActor* actor() { return this->Actor; }
  vtkTextActor* label() { return this->Label; }
  LabelPlace* labelPlace() { return &this->Place; }
  /// Adds shaft and head to the obstacles, which labels must not cover.
  void addTo(std::vector<LabelObstacle>& obstacles) const;

private:
  ArrowLook Look;
  LabelPlace Place;
  Eigen::Vector3d ArrowVector = Eigen::Vector3d::Zero(); ///< vector from origin to head, mm
  Eigen::Vector3d Head = Eigen::Vector3d::Zero();
  vtkSmartPointer<vtkTubeFilter> Shaft;
  vtkSmartPointer<vtkConeSource> Cone;
  vtkSmartPointer<vtkActor> Actor;
  vtkSmartPointer<vtkTextActor> Label;
};

/// A torque, drawn as an arc around its point of reference in the direction of rotation. Its value
/// in N mm is shown at the head of the arc.
class TorqueArc
{
public:
  static constexpr double Radius = 9.0; ///< mm

  TorqueArc();
  ~TorqueArc();
  TorqueArc(const TorqueArc&) = delete;
  TorqueArc& operator=(const TorqueArc&) = delete;

  /// Draws the arc around `center` (mm). The arc begins in the direction `from`. Its length is that
  /// of an arrow (`scale` mm per N) for the force that causes the same torque with the radius of
  /// the arc as lever arm. The arc is at most 5.2 rad long. Draws nothing if the torque is zero or
  /// not finite.
  void show(const Eigen::Vector3d& center, const Eigen::Vector3d& torque,
    const Eigen::Vector3d& from, double scale);
  void hide();
  bool isShown() const;

  const Eigen::Vector3d& head() const { return this->Head; }
  const Eigen::Vector3d& center() const { return this->Center; }
  vtkActor* actor() { return this->Actor; }
  vtkTextActor* label() { return this->Label; }
  LabelPlace* labelPlace() { return &this->Place; }
  /// Adds the arc to the obstacles, which labels must not cover.
  void addTo(std::vector<LabelObstacle>& obstacles) const;

private:
  LabelPlace Place;
  Eigen::Vector3d Head = Eigen::Vector3d::Zero();
  Eigen::Vector3d Center = Eigen::Vector3d::Zero();
  vtkSmartPointer<vtkArcSource> Arc;
  vtkSmartPointer<vtkConeSource> Cone;
  vtkSmartPointer<vtkActor> Actor;
  vtkSmartPointer<vtkTextActor> Label;
};
} // namespace palpate

#endif

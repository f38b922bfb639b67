// SPDX-License-Identifier: BSD-3-Clause
#ifndef ForceArrow_h
#define ForceArrow_h

#include "Interaction/Display/DisplayColors.h"

#include "vtkSmartPointer.h"

#include <Eigen/Core>

#include <string>

class vtkActor;
class vtkAppendPolyData;
class vtkArcSource;
class vtkConeSource;
class vtkTextActor;
class vtkTubeFilter;

namespace palpate
{
/// The style of an arrow: radii and length of its head, mm. The head is at most 40 % of the arrow,
/// and an arrow shorter than a head is slimmer.
struct ArrowLook
{
  Color color;
  double shaftRadius;
  double headRadius;
  double headLength;
  int labelSize; ///< points
  bool bold;
  double labelOpacity; ///< of the background behind the text
};

/// One force as an arrow, with its value in N at the head.
class ForceArrow
{
public:
  explicit ForceArrow(const ArrowLook& look);
  ~ForceArrow();
  ForceArrow(const ForceArrow&) = delete;
  ForceArrow& operator=(const ForceArrow&) = delete;

  /// From `origin` (mm), `scale` mm per N; the label is the magnitude, after `name` or, without
  /// one, after a gap as wide as the head. Zero or not finite: nothing.
  void show(const Eigen::Vector3d& origin, const Eigen::Vector3d& force, double scale, bool dashed,
    const std::string& name = "");
  void hide();
  bool isShown() const;
  /// The same arrow elsewhere.
  void moveTo(const Eigen::Vector3d& origin);

  Eigen::Vector3d tail() const { return this->Head - this->Along; }
  const Eigen::Vector3d& head() const { return this->Head; }
  vtkActor* actor() { return this->Actor; }
  vtkTextActor* label() { return this->Label; }

private:
  ArrowLook Look;
  Eigen::Vector3d Along = Eigen::Vector3d::Zero(); ///< from origin to head, mm
  Eigen::Vector3d Head = Eigen::Vector3d::Zero();
  vtkSmartPointer<vtkTubeFilter> Shaft;
  vtkSmartPointer<vtkConeSource> Cone;
  vtkSmartPointer<vtkActor> Actor;
  vtkSmartPointer<vtkTextActor> Label;
};

/// A torque as an arc about its point, in its direction, with its value in N mm at the head.
class TorqueArc
{
public:
  static constexpr double Radius = 9.0; ///< mm

  TorqueArc();
  ~TorqueArc();
  TorqueArc(const TorqueArc&) = delete;
  TorqueArc& operator=(const TorqueArc&) = delete;

  /// About `center` (mm), beginning on the side of `from`. As long as the arrow of the force with
  /// this torque at the arc's radius, at `scale` mm per N; at most 5.2 rad. Zero or not finite:
  /// nothing.
  void show(const Eigen::Vector3d& center, const Eigen::Vector3d& torque,
    const Eigen::Vector3d& from, double scale);
  void hide();
  bool isShown() const;

  const Eigen::Vector3d& head() const { return this->Head; }
  const Eigen::Vector3d& center() const { return this->Center; }
  vtkActor* actor() { return this->Actor; }
  vtkTextActor* label() { return this->Label; }

private:
  Eigen::Vector3d Head = Eigen::Vector3d::Zero();
  Eigen::Vector3d Center = Eigen::Vector3d::Zero();
  vtkSmartPointer<vtkArcSource> Arc;
  vtkSmartPointer<vtkConeSource> Cone;
  vtkSmartPointer<vtkActor> Actor;
  vtkSmartPointer<vtkTextActor> Label;
};
} // namespace palpate

#endif

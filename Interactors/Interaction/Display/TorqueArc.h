// SPDX-License-Identifier: BSD-3-Clause
#ifndef TorqueArc_h
#define TorqueArc_h

#include "vtkSmartPointer.h"

#include <Eigen/Core>

class vtkActor;
class vtkArcSource;
class vtkConeSource;
class vtkTextActor;
class vtkTubeFilter;

namespace palpate
{
/// A torque as an arc about the point it acts about, the way it turns, with its N mm at the head.
class TorqueArc
{
public:
  static constexpr double Radius = 9.0; ///< mm

  TorqueArc();
  ~TorqueArc();
  TorqueArc(const TorqueArc&) = delete;
  TorqueArc& operator=(const TorqueArc&) = delete;

  /// About `center` (mm), on from the side of `from`. As long as the arrow of the force that does
  /// the same at its radius, at `scale` mm per N, and no more than most of a turn. Zero or not
  /// finite: nothing.
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

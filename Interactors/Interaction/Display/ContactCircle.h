// SPDX-License-Identifier: BSD-3-Clause
#ifndef ContactCircle_h
#define ContactCircle_h

#include "vtkSmartPointer.h"

#include <Eigen/Core>

class vtkActor;
class vtkTubeFilter;

namespace palpate
{
/// The circle within which the tool touches the body.
class ContactCircle
{
public:
  ContactCircle();
  ~ContactCircle();
  ContactCircle(const ContactCircle&) = delete;
  ContactCircle& operator=(const ContactCircle&) = delete;

  /// Around `center`, across the unit vector `normal`; a radius (mm) of 0, or not finite: none.
  void show(
    const Eigen::Vector3d& center, const Eigen::Vector3d& normal, double radius, bool dashed);
  void hide();

  vtkActor* actor() { return this->Actor; }

private:
  vtkSmartPointer<vtkTubeFilter> Tube;
  vtkSmartPointer<vtkActor> Actor;
};
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef ContactMark_h
#define ContactMark_h

#include "Interaction/Display/ShownContact.h"

#include "vtkActor.h"
#include "vtkSmartPointer.h"

#include <Eigen/Core>

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

/// A ball, not visible yet, for the place of a contact that is shown blind.
vtkSmartPointer<vtkActor> makePlaceMarker();

/// On the surface, not at the tip: how deep the tip is would tell how stiff the body is.
void placeMarker(const ShownContact& contact, vtkActor* marker);
} // namespace palpate

#endif

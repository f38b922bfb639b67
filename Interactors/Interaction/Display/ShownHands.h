// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShownHands_h
#define ShownHands_h

#include "Interaction/Display/LabelLayout.h"
#include "Interaction/Display/ShownContact.h"

#include "vtkActor.h"
#include "vtkSmartPointer.h"

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <vector>

class vtkBoundingBox;
class vtkContactTool;
class vtkHapticToolRepresentation;
class vtkRenderer;
class vtkTubeFilter;

namespace palpate
{
/// The circle of contact.
class ContactCircle
{
public:
  ContactCircle();
  ~ContactCircle();
  ContactCircle(const ContactCircle&) = delete;
  ContactCircle& operator=(const ContactCircle&) = delete;

  /// Draws the circle around `center`, perpendicular to the unit vector `normal`. If the radius
  /// (mm) is 0 or not finite, there is no circle.
  void show(
    const Eigen::Vector3d& center, const Eigen::Vector3d& normal, double radius, bool dashed);
  void hide();

  vtkActor* actor() { return this->Actor; }

private:
  vtkSmartPointer<vtkTubeFilter> Tube;
  vtkSmartPointer<vtkActor> Actor;
};

/// Makes a ball, not yet visible, that marks the position of a contact in a blind comparison.
vtkSmartPointer<vtkActor> makePlaceMarker();

/// Puts the marker on the surface, not at the tip: the depth of the tip would reveal the stiffness
/// of the body.
void placeMarker(const ShownContact& contact, vtkActor* marker);

/// The tools over a body, one per hand, each with its arrows and its circle of contact. The first
/// always exists; the others have its style.
class ShownHands
{
public:
  ShownHands();
  ~ShownHands();
  ShownHands(const ShownHands&) = delete;
  ShownHands& operator=(const ShownHands&) = delete;

  /// Must be called once, before the first call of show().
  void setRenderer(vtkRenderer* renderer);
  void setTool(vtkContactTool* tool);
  void setVisibility(bool visible);
  /// Parts of the scene that the labels of all hands leave free.
  void leaveFree(std::vector<LabelObstacle> obstacles);
  void setSteadyLabels(bool steady);
  void resize(std::size_t count);
  std::size_t count() const { return this->Hands.size(); }

  /// Direction of a hand's tool without contact. May be set before the hand exists. Zero (default):
  /// the last direction.
  void setFreeDirection(std::size_t hand, const Eigen::Vector3d& direction);
  Eigen::Vector3d freeDirection(std::size_t hand) const;

  /// Shows a hand's tool and forces, and a circle of this radius (mm; 0: none) `depth` mm below the
  /// contact point.
  void show(std::size_t hand, const ShownContact& contact, double radius, double depth);
  void hideCircles();

  vtkHapticToolRepresentation* tool() { return this->Hands.front().tool; }
  vtkActor* circle() { return this->Hands.front().circle->actor(); }
  void addBounds(vtkBoundingBox& box) const;

private:
  struct Hand
  {
    vtkSmartPointer<vtkHapticToolRepresentation> tool;
    std::unique_ptr<ContactCircle> circle;
  };

  Hand makeHand() const;
  void addToRenderer(const Hand& hand);

  vtkSmartPointer<vtkRenderer> Renderer;
  std::vector<Hand> Hands;
  std::vector<Eigen::Vector3d> FreeDirections; ///< for all hands that a session may have
};
} // namespace palpate

#endif

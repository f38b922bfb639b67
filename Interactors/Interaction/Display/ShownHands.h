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
/// Draws the contact circle.
class ContactCircle
{
public:
  ContactCircle();
  ~ContactCircle();
  ContactCircle(const ContactCircle&) = delete;
  ContactCircle& operator=(const ContactCircle&) = delete;

  /// Draws the circle around `center`, perpendicular to the unit vector `normal`. Draws nothing if
  /// the radius (mm) is 0 or not finite.
  void show(
    const Eigen::Vector3d& center, const Eigen::Vector3d& normal, double radius, bool dashed);
  void hide();

  vtkActor* actor() { return this->Actor; }

private:
  vtkSmartPointer<vtkTubeFilter> Tube;
  vtkSmartPointer<vtkActor> Actor;
};

/// Makes a ball that marks the position of a contact in a blind comparison. Initially it is
/// invisible.
vtkSmartPointer<vtkActor> makePlaceMarker();

/// Places the marker at the contact point on the surface, not at the tip, because the depth of the
/// tip would reveal the stiffness of the body to the participant.
void placeMarker(const ShownContact& contact, vtkActor* marker);

/// Draws the tools on a body, one per hand, each with its arrows and its contact circle. The first
/// tool always exists; the other tools get its style.
class ShownHands
{
public:
  ShownHands();
  ~ShownHands();
  ShownHands(const ShownHands&) = delete;
  ShownHands& operator=(const ShownHands&) = delete;

  /// Sets the renderer. Must be called once, before the first call of show().
  void setRenderer(vtkRenderer* renderer);
  void setTool(vtkContactTool* tool);
  void setVisibility(bool visible);
  /// Sets the parts of the scene that the labels of all hands must not cover.
  void leaveFree(std::vector<LabelObstacle> obstacles);
  void setSteadyLabels(bool steady);
  void resize(std::size_t count);
  std::size_t count() const { return this->Hands.size(); }

  /// Sets the direction of a hand's tool while it has no contact. It may be set before the hand
  /// exists. If the direction is zero, the default, the last direction is kept.
  void setFreeDirection(std::size_t hand, const Eigen::Vector3d& direction);
  Eigen::Vector3d freeDirection(std::size_t hand) const;

  /// Shows the tool and the forces of a hand, and a contact circle. `radius` is the radius of the
  /// circle, mm; with 0 there is no circle. `depth` is the depth of the circle below the contact
  /// point, mm.
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
  /// One element for each hand that a session can have.
  std::vector<Eigen::Vector3d> FreeDirections;
};
} // namespace palpate

#endif

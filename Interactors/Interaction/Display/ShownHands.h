// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShownHands_h
#define ShownHands_h

#include "Interaction/Display/ContactMark.h"
#include "Interaction/Display/ShownContact.h"

#include "vtkSmartPointer.h"

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <vector>

class vtkBoundingBox;
class vtkContactTool;
class vtkHapticToolRepresentation;
class vtkRenderer;

namespace palpate
{
/// The tools over a body, one per hand, each with its arrows and its circle of contact. There is
/// always a first; how it is styled, those after it are.
class ShownHands
{
public:
  ShownHands();
  ~ShownHands();
  ShownHands(const ShownHands&) = delete;
  ShownHands& operator=(const ShownHands&) = delete;

  /// Before the first is shown; once.
  void setRenderer(vtkRenderer* renderer);
  void setTool(vtkContactTool* tool);
  void setVisibility(bool visible);
  void resize(std::size_t count);
  std::size_t count() const { return this->Hands.size(); }

  /// Along which direction a tool stands that touches nothing, of a hand that a session may have,
  /// whether it is there yet or not. Zero, as at first: as it last did.
  void setFreeDirection(std::size_t hand, const Eigen::Vector3d& direction);
  Eigen::Vector3d freeDirection(std::size_t hand) const;

  /// A circle of this radius (mm; 0: none) so deep below the contact point as the body is drawn.
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
  std::vector<Eigen::Vector3d> FreeDirections; ///< of all that a session may have
};
} // namespace palpate

#endif

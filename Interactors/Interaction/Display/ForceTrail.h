// SPDX-License-Identifier: BSD-3-Clause
#ifndef ForceTrail_h
#define ForceTrail_h

#include "Interaction/Display/LabelLayout.h"
#include "Interaction/Display/ShownContact.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <deque>
#include <string>
#include <vector>

class vtkActor;
class vtkLookupTable;
class vtkTubeFilter;

namespace palpate
{
/// Draws the path of the contact: a line through the contact points, coloured by the force at each
/// point. The line is dashed beyond validity and interrupted where there is no contact.
class ForceTrail
{
public:
  /// `colors`: colours and range of the force, N.
  explicit ForceTrail(vtkLookupTable* colors);
  ~ForceTrail();
  ForceTrail(const ForceTrail&) = delete;
  ForceTrail& operator=(const ForceTrail&) = delete;

  void clear();
  /// Shows a complete path.
  void show(const std::vector<ShownContact>& way);
  /// Adds the contact of a picture, and keeps only the contacts of the newest `most` pictures.
  /// Replaces a path that was set by show().
  void follow(const ShownContact& contact, std::size_t most);
  /// Adds a contact between two pictures. Call it between two calls of follow(), so that the line
  /// stays on the surface when the hand is fast.
  void pass(const ShownContact& contact) { this->add(contact, false); }
  /// Whether pass() with a contact at this point would visibly change the line.
  bool isFar(const Eigen::Vector3d& point) const;
  /// Ends the line, because the tool has lost the contact. Call it between two calls of follow().
  void lift();

  /// Whether no line is visible.
  bool isEmpty() const { return this->Contacts.size() < 2; }
  /// Largest force along the line, N; 0 without contact.
  double largestForce() const;
  /// Returns an explanation of the gaps, "gap: no contact", and of the dashes, "dashed: beyond
  /// validity"; "" if there are neither.
  std::string gapsInWords() const;
  /// The line as at most `most` straight pieces, which labels leave free.
  std::vector<LabelObstacle> segments(std::size_t most) const;
  vtkActor* actor() { return this->Actor; }

private:
  /// Adds a contact. It replaces the last contact if that contact is closer than SmallestDistance
  /// to the one before it. A tick without contact ends the line.
  void add(const ShownContact& contact, bool isPicture);
  void draw();

  struct Place
  {
    Eigen::Vector3d point;
    double force;
    bool valid;
    bool begins;    ///< true for the first contact of a line
    bool isPicture; ///< false for a contact between two pictures
  };

  std::deque<Place> Contacts;
  std::size_t Pictures = 0; ///< number of contacts of pictures
  bool IsNear = false;      ///< whether the next contact may replace the last one
  bool InAir = true;
  bool IsLive = false;
  bool IsDashed = false; ///< whether the drawn line has gaps because of a part beyond validity
  vtkSmartPointer<vtkTubeFilter> Tube;
  vtkSmartPointer<vtkActor> Actor;
};
} // namespace palpate

#endif

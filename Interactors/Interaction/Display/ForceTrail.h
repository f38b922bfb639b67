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
/// Draws the path of the contact as a line through the contact points, coloured by the force at
/// each point. The line is dashed where the response is beyond its validity, and interrupted where
/// there is no contact.
class ForceTrail
{
public:
  /// `colors` contains the colours and the range of the force, N.
  explicit ForceTrail(vtkLookupTable* colors);
  ~ForceTrail();
  ForceTrail(const ForceTrail&) = delete;
  ForceTrail& operator=(const ForceTrail&) = delete;

  void clear();
  /// Shows a complete path.
  void show(const std::vector<ShownContact>& way);
  /// Adds the contact that a new picture shows, and keeps only the contacts of the newest `most`
  /// pictures. Replaces a path that was set by show().
  void follow(const ShownContact& contact, std::size_t most);
  /// Adds a contact from the time between two pictures. To be called between two calls of follow(),
  /// so that the line stays on the surface during fast motion.
  void pass(const ShownContact& contact) { this->add(contact, false); }
  /// Whether pass() with a contact at this point would change the line visibly.
  bool isFar(const Eigen::Vector3d& point) const;
  /// Ends the line, because the tool has lost the contact. To be called between two calls of
  /// follow().
  void lift();

  /// Whether no line is visible.
  bool isEmpty() const { return this->Contacts.size() < 2; }
  /// Largest force along the line, N. 0 if there is no contact.
  double largestForce() const;
  /// Explains the gaps ("gap: no contact") and the dashes ("dashed: beyond validity") of the line.
  /// Returns "" if the line has neither.
  std::string gapsInWords() const;
  /// Approximates the line by at most `most` straight segments, which labels must not cover.
  std::vector<LabelObstacle> segments(std::size_t most) const;
  vtkActor* actor() { return this->Actor; }

private:
  /// Adds a contact. The new contact replaces the last contact if the last contact is closer than
  /// SmallestDistance to the contact before it. A tick without contact ends the line.
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
  std::size_t Pictures = 0; ///< number of contacts that a picture has shown
  bool IsNear = false;      ///< whether the next contact may replace the last one
  bool InAir = true;
  bool IsLive = false;
  bool IsDashed = false; ///< whether the drawn line has gaps because of a part beyond validity
  vtkSmartPointer<vtkTubeFilter> Tube;
  vtkSmartPointer<vtkActor> Actor;
};
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef ForceTrail_h
#define ForceTrail_h

#include "Interaction/Display/ShownContact.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <deque>
#include <vector>

class vtkActor;
class vtkLookupTable;
class vtkTubeFilter;

namespace palpate
{
/// The path of the contact: a line through contact points, coloured by the force there, dashed
/// beyond validity, interrupted without contact.
class ForceTrail
{
public:
  /// `colors` has the colours and the range of the force, N.
  explicit ForceTrail(vtkLookupTable* colors);
  ~ForceTrail();
  ForceTrail(const ForceTrail&) = delete;
  ForceTrail& operator=(const ForceTrail&) = delete;

  void clear();
  /// A whole path at once.
  void show(const std::vector<ShownContact>& way);
  /// Adds a contact and keeps the newest `most`; replaces a path shown at once.
  void follow(const ShownContact& contact, std::size_t most);

  /// Whether no line is visible.
  bool isEmpty() const { return this->Contacts.size() < 2; }
  vtkActor* actor() { return this->Actor; }

private:
  /// Replaces the last contact by one too near to be distinguished from it; one without contact
  /// ends the line.
  void add(const ShownContact& contact);
  void draw();

  struct Place
  {
    Eigen::Vector3d point;
    double force;
    bool valid;
    bool begins; ///< a line, after no contact
  };

  std::deque<Place> Contacts;
  bool IsNear = false; ///< whether the next contact may replace the last one
  bool InAir = true;
  bool IsLive = false;
  vtkSmartPointer<vtkTubeFilter> Tube;
  vtkSmartPointer<vtkActor> Actor;
};
} // namespace palpate

#endif

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
/// Where the tool has touched: a line through contact points, coloured by the force there, dashed
/// beyond validity, interrupted where nothing was touched.
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

  /// Whether there is a line to be seen.
  bool isEmpty() const { return this->Contacts.size() < 2; }
  vtkActor* actor() { return this->Actor; }

private:
  /// A contact nearer to the last one than can be seen takes its place; one that touches nothing
  /// ends the line.
  void add(const ShownContact& contact);
  void draw();

  struct Place
  {
    Eigen::Vector3d point;
    double force;
    bool valid;
    bool begins; ///< a line: nothing was touched before
  };

  std::deque<Place> Contacts;
  bool IsNear = false; ///< the last contact: the next may take its place
  bool InAir = true;
  bool IsLive = false;
  vtkSmartPointer<vtkTubeFilter> Tube;
  vtkSmartPointer<vtkActor> Actor;
};
} // namespace palpate

#endif

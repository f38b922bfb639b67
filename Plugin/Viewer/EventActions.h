// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_EventActions_h
#define palpate_EventActions_h

#include <functional>
#include <memory>
#include <vector>

class vtkObject;

namespace palpate
{
/// The actions of a window on events of its objects. This object must outlive the other objects, or
/// at least their last event.
class EventActions
{
public:
  /// Adds an action, which gets the event's call data. Actions of higher priority are called first.
  void add(vtkObject* speaker, unsigned long event, std::function<void(void*)> action,
    float priority = 0.0F);

private:
  std::vector<std::unique_ptr<std::function<void(void*)>>> Actions;
};
} // namespace palpate

#endif

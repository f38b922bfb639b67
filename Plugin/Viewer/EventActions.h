// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_EventActions_h
#define palpate_EventActions_h

#include <functional>
#include <memory>
#include <vector>

class vtkObject;

namespace palpate
{
/// The actions that a window performs on events of its objects. This object must exist until the
/// last event of the other objects.
class EventActions
{
public:
  /// Adds an action for an event of `speaker`. The action receives the call data of the event.
  /// Actions with a higher priority are called first.
  void add(vtkObject* speaker, unsigned long event, std::function<void(void*)> action,
    float priority = 0.0F);

private:
  std::vector<std::unique_ptr<std::function<void(void*)>>> Actions;
};
} // namespace palpate

#endif

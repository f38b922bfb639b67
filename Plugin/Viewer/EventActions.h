// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_EventActions_h
#define palpate_EventActions_h

#include <functional>
#include <memory>
#include <vector>

class vtkObject;

namespace palpate
{
/// What a window does when an object of it tells an event. Must outlive the objects, or their last
/// event.
class EventActions
{
public:
  /// The action is given the event's call data. The higher the priority the earlier.
  void add(vtkObject* speaker, unsigned long event, std::function<void(void*)> action,
    float priority = 0.0F);

private:
  std::vector<std::unique_ptr<std::function<void(void*)>>> Actions;
};
} // namespace palpate

#endif

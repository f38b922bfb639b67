// SPDX-License-Identifier: BSD-3-Clause
#include "EventActions.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"

#include <utility>

namespace palpate
{
void EventActions::add(
  vtkObject* speaker, unsigned long event, std::function<void(void*)> action, float priority)
{
  this->Actions.push_back(std::make_unique<std::function<void(void*)>>(std::move(action)));
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this->Actions.back().get());
  command->SetCallback([](vtkObject*, unsigned long, void* client, void* data)
    { (*static_cast<std::function<void(void*)>*>(client))(data); });
  speaker->AddObserver(event, command, priority);
}
} // namespace palpate

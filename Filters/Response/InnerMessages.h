// SPDX-License-Identifier: BSD-3-Clause
#ifndef InnerMessages_h
#define InnerMessages_h

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObject.h"

#include <string>

namespace palpate
{
/// What an algorithm inside a filter complains about, passed on in the filter's own name.
struct InnerMessages
{
  std::string error;
  std::string warning;
};

inline void listen(vtkObject* object, InnerMessages& messages)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&messages);
  command->SetCallback(
    [](vtkObject* caller, unsigned long event, void* data, void* text)
    {
      auto* heard = static_cast<InnerMessages*>(data);
      std::string& kept = event == vtkCommand::ErrorEvent ? heard->error : heard->warning;
      if (kept.empty() && text && !caller->IsA("vtkExecutive"))
      {
        // "ERROR: In file, line n\nclass (address): message\n\n"
        kept = static_cast<const char*>(text);
        const std::size_t start = kept.find("): ");
        kept.erase(0, start == std::string::npos ? 0 : start + 3);
        kept.erase(kept.find_last_not_of(" \n.") + 1);
      }
    });
  object->AddObserver(vtkCommand::ErrorEvent, command);
  object->AddObserver(vtkCommand::WarningEvent, command);
}
} // namespace palpate

#endif

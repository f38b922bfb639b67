// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ModuleFile_h
#define palpate_ModuleFile_h

#include "Mechanics/PalpateExport.h"

#include <string>

namespace palpate
{
/**
 * The table of functions of a module. A module is a library that the core does not link, because
 * most scenes do not need it. The table type of each module is derived from this struct. A module
 * NAME defines
 *   extern "C" const ModuleTable* NAMEModule();
 */
struct ModuleTable
{
  const char* version; ///< version of Palpate
};

/// The table of a loaded module, or the reason why it could not be loaded.
struct LoadedModule
{
  const ModuleTable* table = nullptr;
  std::string fault; ///< empty if there is a table
};

/**
 * Loads lib`name`.so, with or without the version appended. The function searches the folder of
 * Palpate's libraries first, then the system's library search path. It rejects a file without the
 * function `name`Module, and a module of another version. A module remains loaded. Any thread
 * except the servo thread may call this function.
 */
PALPATE_EXPORT LoadedModule loadModule(const std::string& name);

/// Returns the continuation of a sentence "… needs ": the name of the module, the fault of
/// loadModule, and the command that builds the module.
PALPATE_EXPORT std::string missingModule(const std::string& name, const std::string& fault);
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ModuleFile_h
#define palpate_ModuleFile_h

#include "Mechanics/PalpateExport.h"

#include <string>

namespace palpate
{
/**
 * The functions of a module: a library that the core does not link, since most scenes need none of
 * it. A module has its own table of functions, derived from this one, and defines
 *   extern "C" const ModuleTable* NAMEModule();
 */
struct ModuleTable
{
  const char* version; ///< of Palpate
};

/// The table of a loaded module, or the reason why there is none, in words.
struct LoadedModule
{
  const ModuleTable* table = nullptr;
  std::string fault; ///< empty if there is a table
};

/**
 * Loads lib`name`.so, with or without the version behind it, from the folder of Palpate's libraries
 * or, where it is not there, from where the system looks for libraries. Refuses a file without
 * `name`Module, and a module of another version. A module stays loaded. Any thread may call it; not
 * from the servo tick.
 */
PALPATE_EXPORT LoadedModule loadModule(const std::string& name);

/// For a sentence "… needs ": the module by its name, the fault of loadModule, and what makes the
/// module.
PALPATE_EXPORT std::string missingModule(const std::string& name, const std::string& fault);
} // namespace palpate

#endif

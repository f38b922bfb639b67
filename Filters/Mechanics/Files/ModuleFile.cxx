// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Files/ModuleFile.h"

#include "Mechanics/JoinedText.h"

#include <dlfcn.h>

#include <array>
#include <filesystem>

namespace palpate
{
namespace
{
/// Returns the two file names of a module: with the version, as required by programs that link the
/// module, and without the version.
std::array<std::string, 2> namesOf(const std::string& module)
{
  const std::string name = "lib" + module + ".so";
  return { name + "." + PALPATE_SOVERSION, name };
}

/// Returns the file of a module in the folder of this library; "" if that folder is unknown.
std::string fileOfModule(const std::string& module)
{
  Dl_info own{};
  if (dladdr(reinterpret_cast<const void*>(&loadModule), &own) == 0 || !own.dli_fname)
  {
    return {};
  }
  std::error_code ignored;
  const auto folder = std::filesystem::canonical(own.dli_fname, ignored).parent_path();
  for (const std::string& name : namesOf(module))
  {
    const auto file = folder / name;
    if (std::filesystem::exists(file, ignored))
    {
      return file.string();
    }
  }
  return {};
}

void* open(const std::string& module)
{
  const std::string found = fileOfModule(module);
  if (!found.empty())
  {
    return dlopen(found.c_str(), RTLD_NOW | RTLD_LOCAL);
  }
  void* library = nullptr;
  for (const std::string& name : namesOf(module))
  {
    library = library ? library : dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
  }
  return library;
}
} // namespace

LoadedModule loadModule(const std::string& name)
{
  const std::string fileName = "lib" + name + ".so";
  void* library = open(name);
  if (!library)
  {
    const char* reason = dlerror();
    return { nullptr, reason ? reason : fileName + " cannot be loaded" };
  }
  using Entry = const ModuleTable* (*)();
  const auto entry = reinterpret_cast<Entry>(dlsym(library, (name + "Module").c_str()));
  if (!entry)
  {
    return { nullptr, joined(fileName, " is not a module of Palpate: it has no ", name, "Module") };
  }
  const ModuleTable* table = entry();
  if (table->version != std::string(PALPATE_VERSION))
  {
    return { nullptr,
      joined(fileName, " is of version ", table->version, ", but this program is of version ",
        PALPATE_VERSION) };
  }
  return { table, {} };
}

std::string missingModule(const std::string& name, const std::string& fault)
{
  return joined("the module ", name, ", which cannot be loaded (", fault,
    "): ./run build makes it, and Palpate's packages contain it");
}
} // namespace palpate

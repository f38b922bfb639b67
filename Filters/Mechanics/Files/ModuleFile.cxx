// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Files/ModuleFile.h"

#include "Mechanics/JoinedText.h"

#include <dlfcn.h>

#include <filesystem>

namespace palpate
{
namespace
{
/// The file of a module in the folder of this library; "" where that is not known.
std::string fileOfModule(const std::string& name)
{
  Dl_info own{};
  if (dladdr(reinterpret_cast<const void*>(&loadModule), &own) == 0 || !own.dli_fname)
  {
    return {};
  }
  std::error_code ignored;
  const auto folder = std::filesystem::canonical(own.dli_fname, ignored).parent_path();
  const auto file = folder / ("lib" + name + ".so");
  return std::filesystem::exists(file, ignored) ? file.string() : std::string();
}
} // namespace

LoadedModule loadModule(const std::string& name)
{
  const std::string fileName = "lib" + name + ".so";
  const std::string found = fileOfModule(name);
  void* library = dlopen((found.empty() ? fileName : found).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library)
  {
    const char* reason = dlerror();
    return { nullptr, reason ? reason : fileName + " cannot be loaded" };
  }
  using Entry = const ModuleTable* (*)();
  const auto entry = reinterpret_cast<Entry>(dlsym(library, (name + "Module").c_str()));
  if (!entry)
  {
    return { nullptr,
      joined(fileName, " is no module of Palpate: ", name, "Module is missing in it") };
  }
  const ModuleTable* table = entry();
  if (table->version != std::string(PALPATE_VERSION))
  {
    return { nullptr,
      joined(fileName, " is of version ", table->version, ", this program of ", PALPATE_VERSION) };
  }
  return { table, {} };
}
} // namespace palpate

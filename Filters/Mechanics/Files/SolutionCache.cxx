// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Files/SolutionCache.h"

#include "Mechanics/Files/NumberText.h"
#include "Mechanics/Files/WholeFile.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

namespace palpate
{
namespace
{
/// Returns the folder of the cache; "" if the cache is off.
std::filesystem::path folder()
{
  const auto variable = [](const char* name) { return std::getenv(name); };
  if (const char* own = variable("PALPATE_CACHE"))
  {
    return own;
  }
  const char* caches = variable("XDG_CACHE_HOME");
  if (caches && *caches)
  {
    return std::filesystem::path(caches) / "palpate";
  }
  const char* home = variable("HOME");
  return home && *home ? std::filesystem::path(home) / ".cache" / "palpate"
                       : std::filesystem::path();
}

std::filesystem::path fileOf(const std::string& kind, const std::string& key)
{
  const std::filesystem::path place = folder();
  return place.empty() ? place : place / (kind + "-" + digest(key) + ".txt");
}
} // namespace

/// The FNV-1a hash. Collisions do no harm, because a file of the cache also contains the key.
std::string digest(std::string_view text)
{
  std::uint64_t hash = 14695981039346656037U;
  for (const char letter : text)
  {
    hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211U;
  }
  char buffer[17];
  std::snprintf(buffer, sizeof buffer, "%016llx", static_cast<unsigned long long>(hash));
  return buffer;
}

std::vector<double> readSolution(const std::string& kind, const std::string& key, std::size_t count)
{
  std::ifstream file(fileOf(kind, key));
  std::string line;
  if (!file || !std::getline(file, line) || line != key)
  {
    return {};
  }
  std::vector<double> values;
  while (std::getline(file, line))
  {
    double value = 0.0;
    if (!readNumber(line, value) || !std::isfinite(value))
    {
      return {};
    }
    values.push_back(value);
  }
  return values.size() == count ? values : std::vector<double>();
}

void writeSolution(
  const std::string& kind, const std::string& key, const std::vector<double>& values)
{
  const std::filesystem::path path = fileOf(kind, key);
  if (path.empty())
  {
    return;
  }
  std::error_code failed;
  std::filesystem::create_directories(path.parent_path(), failed);
  WholeFile file(path.string());
  if (failed || !file.open().empty())
  {
    return;
  }
  file.write(key + "\n");
  for (const double value : values)
  {
    file.write(shortestDecimals(value) + "\n");
  }
  file.finish(); // if this fails, the next run solves the problem again
}
} // namespace palpate

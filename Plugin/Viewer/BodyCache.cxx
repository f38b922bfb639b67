// SPDX-License-Identifier: BSD-3-Clause
#include "BodyCache.h"

#include "Contact/ResponseContract.h"
#include "Response/BodyLaws.h"
#include "Response/FlatBodyConversion.h"
#include "ResponseSet.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <sstream>

namespace palpate
{
namespace
{
const char* const CacheResponse = "Cached";
// Depth of the cached response, mm; any value is possible, because the response is not used.
constexpr double CacheDepth = 2.0;

/// A point array of the body, and the array of the cached response in which it is stored.
struct CarriedArray
{
  const char* name;
  ResponseArray carrier;
};
// Response arrays with one float per point, whose own values are not needed.
constexpr std::array<CarriedArray, 2> Carried = { {
  { "LayerThickness", ResponseArray::Validity },
  { "LayerThicknessError", ResponseArray::Range },
} };

/// Returns the path of the cache file for this scan, or "" if no cache folder is possible.
std::string cacheFile(const std::string& path, const BodyFileOptions& options)
{
  std::error_code failed;
  const auto time = std::filesystem::last_write_time(path, failed);
  const auto size = std::filesystem::file_size(path, failed);
  if (failed)
  {
    return {};
  }
  std::ostringstream key;
  key.precision(17);
  key << std::filesystem::absolute(path, failed).string() << '|' << size << '|'
      << time.time_since_epoch().count() << '|' << options.lengthScale << '|' << options.resolution
      << '|' << options.contourValue << '|' << options.closingRadius
      << "|placed by the header" // because earlier versions did not use the header for the position
                                 // of skins
      << "|error of the thickness"; // because earlier versions did not store this array
  if (options.baseValue)
  {
    key << "|bone below " << *options.baseValue;
  }
  return cachePlace("skin", key.str(), ".palpate");
}

/// Returns the cached body without its response. The normals of the response become the active
/// normals. With `thickness`, the thickness and its error become arrays of the body.
vtkSmartPointer<vtkPolyData> withoutResponse(vtkPolyData* cached, bool thickness)
{
  auto body = vtkSmartPointer<vtkPolyData>::New();
  body->CopyStructure(cached);
  vtkDataArray* normals =
    cached->GetPointData()->GetArray((std::string(CacheResponse) + "Normal").c_str());
  normals->SetName("Normals");
  body->GetPointData()->SetNormals(normals);
  for (const CarriedArray& array : Carried)
  {
    vtkDataArray* carrier =
      cached->GetPointData()->GetArray(arrayName(CacheResponse, array.carrier).c_str());
    if (thickness)
    {
      carrier->SetName(array.name);
      body->GetPointData()->AddArray(carrier);
    }
  }
  return body;
}

/// Stores a body in the flat file format, which requires a response. The response itself is not
/// used, but some of its arrays contain arrays of the body.
std::string store(vtkPolyData* body, const std::string& file)
{
  const std::string unmade = makeCacheFolder(file);
  if (!unmade.empty())
  {
    return unmade;
  }
  vtkNew<vtkContactTool> tool;
  LawRequest request;
  request.tool = tool;
  request.responseName = CacheResponse;
  request.deflection = CacheDepth;
  request.terms = LawTerms::plain();
  vtkNew<vtkPolyData> made;
  std::string warning;
  const std::string error = attachResponse(Ranks(), body, request, {}, made, warning);
  for (const CarriedArray& array : Carried)
  {
    if (vtkDataArray* given = body->GetPointData()->GetArray(array.name))
    {
      vtkNew<vtkFloatArray> carried;
      carried->DeepCopy(given);
      carried->SetName(arrayName(CacheResponse, array.carrier).c_str());
      made->GetPointData()->AddArray(carried);
    }
  }
  return error.empty() ? writeFlatBody(made, CacheResponse, file) : error;
}
} // namespace

std::string cachePlace(const std::string& kind, const std::string& key, const std::string& ending)
{
  const char* folder = std::getenv("XDG_CACHE_HOME");
  const char* home = std::getenv("HOME");
  if ((!folder || !*folder) && (!home || !*home))
  {
    return {};
  }
  std::ostringstream name;
  name << kind << '-' << std::hex << std::hash<std::string>()(key + "|" + PALPATE_VERSION)
       << ending;
  const std::filesystem::path base =
    folder && *folder ? std::filesystem::path(folder) : std::filesystem::path(home) / ".cache";
  return (base / "palpate" / name.str()).string();
}

std::string makeCacheFolder(const std::string& file)
{
  std::error_code failed;
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  std::filesystem::create_directories(folder, failed);
  return failed ? "cannot make folder '" + folder.string() + "': " + failed.message()
                : std::string();
}

BodyFileResult readCachedScan(const std::string& path, const BodyFileOptions& options)
{
  const std::string file = cacheFile(path, options);
  std::error_code ignored;
  BodyFileResult result;
  std::string fault;
  if (!file.empty() && std::filesystem::exists(file, ignored))
  {
    if (const auto cached = readFlatBody(file, CacheResponse, fault))
    {
      result.body = withoutResponse(cached, options.baseValue.has_value());
      result.notes.push_back("skin of " + path + " taken from the cache " + file);
      return result;
    }
  }
  result = readBodyFile(path, options);
  if (result.error.empty() && !file.empty())
  {
    const std::string unwritten = store(result.body, file);
    fault += (fault.empty() || unwritten.empty() ? "" : "; ") + unwritten;
  }
  if (!fault.empty())
  {
    result.notes.push_back("cache not used: " + fault);
  }
  return result;
}
} // namespace palpate

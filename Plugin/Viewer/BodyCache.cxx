// SPDX-License-Identifier: BSD-3-Clause
#include "BodyCache.h"

#include "Response/BodyLaws.h"
#include "Response/FlatBodyConversion.h"
#include "ResponseSet.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <sstream>

namespace palpate
{
namespace
{
const char* const CacheResponse = "Cached";
constexpr double CacheDepth = 2.0; // mm; the value has no effect
const char* const Thickness = "LayerThickness";

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
      << "|placed by the header"; // skins of earlier versions were not placed by the header
  if (options.baseValue)
  {
    key << "|bone below " << *options.baseValue;
  }
  return cachePlace("skin", key.str(), ".palpate");
}

/// Makes the normals of the response the active normals. With `thickness`, makes its validity the
/// thickness array. Removes the response itself.
vtkSmartPointer<vtkPolyData> withoutResponse(vtkPolyData* cached, bool thickness)
{
  auto body = vtkSmartPointer<vtkPolyData>::New();
  body->CopyStructure(cached);
  vtkDataArray* normals =
    cached->GetPointData()->GetArray((std::string(CacheResponse) + "Normal").c_str());
  normals->SetName("Normals");
  body->GetPointData()->SetNormals(normals);
  if (thickness)
  {
    vtkDataArray* layer =
      cached->GetPointData()->GetArray((std::string(CacheResponse) + "Validity").c_str());
    layer->SetName(Thickness);
    body->GetPointData()->AddArray(layer);
  }
  return body;
}

/// Stores a body in the flat file format. The format requires a response, so the body gets one,
/// which is never used. The validity of this response, a length per point, holds the thickness of
/// the layer.
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
  if (vtkDataArray* thickness = body->GetPointData()->GetArray(Thickness))
  {
    const std::string place = std::string(CacheResponse) + "Validity";
    vtkNew<vtkFloatArray> carried;
    carried->DeepCopy(thickness);
    carried->SetName(place.c_str());
    made->GetPointData()->AddArray(carried);
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

// SPDX-License-Identifier: BSD-3-Clause
#include "SolvedCache.h"

#include "BodyCache.h"
#include "Mechanics/Checked.h"
#include "Mechanics/Files/NumberText.h"
#include "ResponseSet.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkXMLPolyDataReader.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <sstream>
#include <string_view>

namespace palpate
{
vtkSmartPointer<vtkPolyData> readSolved(
  const std::string& file, const std::vector<std::string>& pointArrays)
{
  std::error_code ignored;
  if (file.empty() || !std::filesystem::exists(file, ignored))
  {
    return nullptr;
  }
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  if (!updateQuietly(reader).empty())
  {
    return nullptr;
  }
  vtkPolyData* body = reader->GetOutput();
  const auto has = [body](const std::string& name)
  { return body->GetPointData()->HasArray(name.c_str()) != 0; };
  return std::all_of(pointArrays.begin(), pointArrays.end(), has) ? body : nullptr;
}

std::string keepSolved(vtkPolyData* body, const std::string& file)
{
  if (file.empty())
  {
    return {};
  }
  return firstFault([&] { return makeCacheFolder(file); }, [&] { return saveBody(body, file); });
}

std::string solvedKey(const ViewerOptions& options, const ViewerScene& scene)
{
  std::string key;
  for (const double number : { scene.youngsModulus, scene.poissonRatio, options.maximumDeflection,
         options.terms.errorTolerance, options.terms.edges ? 1.0 : 0.0, options.terms.tilt })
  {
    key += '|' + shortestDecimals(number);
  }
  key += '|' + textOf(scene.relaxation);
  for (const std::string& tool : scene.tools)
  {
    key += '|' + tool;
  }
  return key;
}

std::string contentOf(vtkPolyData* body)
{
  std::ostringstream text;
  const auto add = [&text](vtkDataArray* array)
  {
    const auto bytes = static_cast<std::size_t>(array->GetNumberOfValues()) *
      static_cast<std::size_t>(array->GetDataTypeSize());
    const std::string_view content(static_cast<const char*>(array->GetVoidPointer(0)), bytes);
    text << '|' << (array->GetName() ? array->GetName() : "") << ' ' << array->GetDataType() << ' '
         << array->GetNumberOfTuples() << ' ' << std::hash<std::string_view>()(content);
  };
  add(body->GetPoints()->GetData());
  vtkCellArray* polys = body->GetPolys();
  add(polys->GetConnectivityArray());
  for (int i = 0; i < body->GetPointData()->GetNumberOfArrays(); ++i)
  {
    if (vtkDataArray* array = body->GetPointData()->GetArray(i))
    {
      add(array);
    }
  }
  return text.str();
}
} // namespace palpate

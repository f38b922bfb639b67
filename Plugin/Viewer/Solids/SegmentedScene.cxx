// SPDX-License-Identifier: BSD-3-Clause
// A segmentation as the body of a scene. Its labels are tissues, which are solved once by finite
// elements.
#include "ViewerScene.h"

#include "Mechanics/Files/NumberText.h"
#include "Mechanics/JoinedText.h"
#include "ProgressLine.h"
#include "Response/Files/CollectingWindow.h"
#include "SolidTools.h"

#include "vtkBodyFileReader.h"
#include "vtkDataArray.h"
#include "vtkElasticContactResponse.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSegmentedBody.h"
#include "vtkUnstructuredGrid.h"

#include <chrono>
#include <functional>
#include <string_view>

namespace palpate
{
namespace
{
/// Reads the image of labels. Returns "" or an error that names the file.
std::string readLabels(const std::string& path, vtkSmartPointer<vtkImageData>& image)
{
  const QuietScope quiet;
  vtkNew<vtkBodyFileReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  if (!reader->GetFault().empty())
  {
    return path + ": " + reader->GetFault() + ".";
  }
  image = vtkImageData::SafeDownCast(reader->GetOutput());
  return image ? std::string()
               : path +
      ": is a surface or a mesh, but --tissue needs an image of labels (.nii, "
      ".nii.gz, .vti)";
}

std::string textOfTissues(const ViewerOptions& options)
{
  std::string text;
  for (const TissueChoice& tissue : options.tissues)
  {
    text += joined(text.empty() ? "label " : ", label ", tissue.label,
      ": E = ", tissue.youngsModulus, " MPa, nu = ", tissue.poissonRatio);
  }
  return text + " (given on the command line)";
}

/// Returns the cache key, which contains all input of the responses. The revision must be increased
/// when the same input gives other results.
std::string segmentedKey(
  const ViewerOptions& options, const ViewerScene& scene, vtkImageData* image)
{
  constexpr int Revision = 1;
  std::string key = joined(Revision, solidTermsKey(options, scene));
  for (const TissueChoice& tissue : options.tissues)
  {
    key += '|' + shortestDecimals(tissue.label) + ':' + shortestDecimals(tissue.youngsModulus) +
      ':' + shortestDecimals(tissue.poissonRatio);
  }
  for (int i = 0; i < 6; ++i)
  {
    key += joined('|', image->GetExtent()[i]);
  }
  for (int i = 0; i < 3; ++i)
  {
    key += '|' + shortestDecimals(image->GetOrigin()[i]) + '|' +
      shortestDecimals(image->GetSpacing()[i]);
  }
  for (int i = 0; i < 9; ++i)
  {
    key += '|' + shortestDecimals(image->GetDirectionMatrix()->GetData()[i]);
  }
  vtkDataArray* labels = image->GetPointData()->GetScalars();
  const auto bytes = static_cast<std::size_t>(labels ? labels->GetNumberOfValues() : 0) *
    static_cast<std::size_t>(labels ? labels->GetDataTypeSize() : 0);
  const std::string_view content(
    labels ? static_cast<const char*>(labels->GetVoidPointer(0)) : nullptr, bytes);
  return key + joined('|', std::hash<std::string_view>()(content));
}

/// Adds the arrays of a response to a body, except the arrays that the body already has.
void addArrays(vtkFieldData* from, vtkFieldData* to)
{
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    if (!to->HasArray(from->GetArrayName(i)))
    {
      to->AddArray(from->GetAbstractArray(i));
    }
  }
}

/// Fills the tissues with cells and presses the tools of the scene on them. Sets body and notes of
/// the scene.
std::string solveTissues(const ViewerOptions& options, ViewerScene& scene, vtkImageData* image)
{
  SolidTools made;
  std::string error = makeSolidTools(options, scene, made);
  if (!error.empty())
  {
    return error;
  }
  const auto begin = std::chrono::steady_clock::now();
  vtkNew<vtkSegmentedBody> filled;
  filled->SetInputData(image);
  for (const TissueChoice& tissue : options.tissues)
  {
    filled->AddTissue(tissue.label, tissue.youngsModulus, tissue.poissonRatio);
  }
  filled->SetSurfaceSpacing(options.solidSpacing);
  filled->SetFixedFaces(options.fixedFaces);
  error = updateWithProgress(filled, "the tissues are filled with tetrahedra");
  if (!error.empty())
  {
    return options.body + ": " + error;
  }
  vtkNew<vtkElasticContactResponse> pressed;
  pressed->SetInputConnection(filled->GetOutputPort());
  const int cells = vtkDataObject::FIELD_ASSOCIATION_CELLS;
  pressed->SetInputArrayToProcess(0, 0, 0, cells, "YoungsModulus");
  pressed->SetInputArrayToProcess(1, 0, 0, cells, "PoissonRatio");
  setSolidTerms(options, scene, pressed);
  auto body = vtkSmartPointer<vtkPolyData>::New();
  vtkIdType solutions = 0;
  for (const std::size_t t : made.order)
  {
    setSolidTool(options, scene, made, t, pressed);
    error = updateWithProgress(pressed, "the tissues are solved under " + scene.tools[t]);
    if (!error.empty())
    {
      return options.body + ": " + error;
    }
    solutions += pressed->GetNumberOfSolutions();
    if (body->GetNumberOfPoints() == 0)
    {
      body->ShallowCopy(pressed->GetOutput());
    }
    addArrays(pressed->GetOutput()->GetPointData(), body->GetPointData());
    addArrays(pressed->GetOutput()->GetFieldData(), body->GetFieldData());
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  const int fine = filled->GetNumberOfFineRegions();
  scene.notes.push_back(joined("filled with ", filled->GetOutput()->GetNumberOfCells(),
    " tetrahedra of ", filled->GetOutput()->GetNumberOfPoints(), " nodes, ",
    shortly(filled->GetUsedSpacing()), " mm at the surface, finer in ", fine,
    fine == 1 ? " enclosed region" : " enclosed regions", ", held at ", options.fixedFaces, "; ",
    solutions, " points solved for, in ", shortly(taken.count()), " s"));
  scene.body = body;
  return {};
}
} // namespace

std::string makeSegmentedScene(const ViewerOptions& options, ViewerScene& scene)
{
  vtkSmartPointer<vtkImageData> image;
  std::string error = readLabels(options.body, image);
  if (!error.empty())
  {
    return error;
  }
  scene.title = options.body.substr(options.body.find_last_of('/') + 1);
  scene.tissues = textOfTissues(options);
  scene.tools = options.tools.empty() ? std::vector<std::string>{ "sphere:6.35" } : options.tools;
  scene.terms = options.terms;
  scene.relaxation = options.relaxation;
  error = solveOrRead("tissues", segmentedKey(options, scene, image), scene,
    [&]() { return solveTissues(options, scene, image); });
  if (!error.empty())
  {
    return error;
  }
  scene.body->GetCenter(scene.center.data());
  scene.directions = { { 0.0, 0.0, 1.0 } };
  scene.viewFrom = { 0.5, -0.8, 0.6 };
  return {};
}
} // namespace palpate

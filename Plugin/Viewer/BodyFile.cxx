// SPDX-License-Identifier: BSD-3-Clause
#include "BodyFile.h"

#include "Response/Files/CollectingWindow.h"
#include "Response/FlatBodyConversion.h"
#include "Mechanics/JoinedText.h"

#include "vtkBodyFileReader.h"
#include "vtkBodySurface.h"
#include "vtkLayerThickness.h"
#include "vtkSkinSurface.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>
#include <exception>
#include <filesystem>

namespace
{
/** Adds LayerThickness (in the file's unit of length) and its error to the skin of a scan. */
vtkSmartPointer<vtkPolyData> withThickness(
  vtkPolyData* skin, vtkImageData* scan, const palpate::BodyFileOptions& options)
{
  vtkNew<vtkLayerThickness> thickness;
  thickness->SetInputData(0, skin);
  thickness->SetScanData(scan);
  thickness->SetBaseValue(*options.baseValue);
  thickness->SetMaximumDepth(thickness->GetMaximumDepth() / options.lengthScale);
  thickness->SetEdgeWidth(thickness->GetEdgeWidth() / options.lengthScale);
  thickness->SetSmoothingRadius(thickness->GetSmoothingRadius() / options.lengthScale);
  thickness->Update();
  return thickness->GetOutput();
}

/** Returns the outer skin of a scan. */
vtkSmartPointer<vtkPolyData> skinOf(
  vtkImageData* scan, const palpate::BodyFileOptions& options, std::vector<std::string>& notes)
{
  vtkNew<vtkSkinSurface> skin;
  skin->SetInputData(scan);
  skin->SetContourValue(options.contourValue);
  skin->SetResolution(options.resolution / options.lengthScale);
  skin->SetClosingRadius(options.closingRadius / options.lengthScale);
  skin->Update();
  const int* size = scan->GetDimensions();
  notes.push_back(palpate::joined("outer skin of a scan of ", size[0], " x ", size[1], " x ",
    size[2], " voxels at grey level ", skin->GetUsedContourValue(), ", openings up to ",
    2.0 * options.closingRadius, " mm closed: ", skin->GetOutput()->GetNumberOfPoints(),
    " points"));
  if (options.baseValue)
  {
    return withThickness(skin->GetOutput(), scan, options);
  }
  return skin->GetOutput();
}

/** Multiplies a point array of a body by a factor, if the body has the array. */
void scaleArray(vtkPolyData* body, const char* name, double factor)
{
  vtkDataArray* given = body->GetPointData()->GetArray(name);
  if (!given || factor == 1.0)
  {
    return;
  }
  auto scaled = vtkSmartPointer<vtkDataArray>::Take(given->NewInstance());
  scaled->DeepCopy(given);
  for (vtkIdType i = 0; i < scaled->GetNumberOfTuples(); ++i)
  {
    scaled->SetTuple1(i, factor * given->GetTuple1(i));
  }
  body->GetPointData()->AddArray(scaled);
}

/** Returns the reason why the data are not a body, without the prefix of the filter's message. */
std::string bodyProblem(const palpate::CollectingWindow* complaints)
{
  const std::string before = "Wrong input: ";
  const std::string& reason = complaints->reason();
  return reason.compare(0, before.size(), before) == 0 ? reason.substr(before.size()) : reason;
}

/** Reads `path` into `result`. Returns "" or an error. */
std::string readSurface(const std::string& path, const palpate::BodyFileOptions& options,
  const palpate::CollectingWindow* complaints, palpate::BodyFileResult& result)
{
  if (!(options.lengthScale > 0.0) || !std::isfinite(options.lengthScale))
  {
    return palpate::joined(
      "the unit of length must be positive and finite (mm), but is ", options.lengthScale);
  }

  vtkNew<vtkBodyFileReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  if (!reader->GetFault().empty())
  {
    return reader->GetFault();
  }
  for (int i = 0; i < reader->GetNumberOfNotes(); ++i)
  {
    result.notes.push_back(reader->GetNote(i));
  }

  // Converts the data to triangles in millimetres.
  vtkSmartPointer<vtkDataSet> content = reader->GetOutput();
  if (auto* scan = vtkImageData::SafeDownCast(content))
  {
    content = skinOf(scan, options, result.notes);
  }
  vtkNew<vtkBodySurface> surface;
  surface->SetInputData(content);
  surface->SetLengthScale(options.lengthScale);
  surface->AskAboutSizeOff(); // the question is asked below, where it can name the option
  surface->Update();
  if (complaints->hasFailed())
  {
    return bodyProblem(complaints);
  }
  vtkSmartPointer<vtkPolyData> body = surface->GetOutput();
  if (body->GetNumberOfPolys() == 0)
  {
    const std::string& reason = complaints->reason();
    return palpate::joined("holds no triangles", reason.empty() ? "" : ": ", reason);
  }
  // The unit of length of the arrays is converted to mm.
  scaleArray(body, "LayerThickness", options.lengthScale);
  scaleArray(body, "LayerThicknessError", 1.0 / options.lengthScale);
  for (int i = 0; i < surface->GetNumberOfNotes(); ++i)
  {
    result.notes.push_back(surface->GetNote(i));
  }
  if (vtkBodySurface::IsSizeDoubtful(surface->GetLongestSide()))
  {
    result.notes.push_back(palpate::joined(
      "its longest side is ", surface->GetLongestSide(), " mm: is --length-unit right?"));
  }
  if (!complaints->firstWarning().empty())
  {
    result.notes.push_back(complaints->firstWarning());
  }
  result.body = body;
  return "";
}
} // namespace

namespace palpate
{
BodyFileResult readBodyFile(const std::string& path, const BodyFileOptions& options)
{
  BodyFileResult result;
  if (std::filesystem::path(path).extension() == ".palpate")
  {
    result.body = readFlatBody(path, "Response", result.error);
    return result;
  }
  const QuietScope quiet;
  std::string problem;
  try
  {
    problem = readSurface(path, options, quiet.window, result);
  }
  catch (const std::exception& exception)
  {
    problem = palpate::joined("cannot be read: ", exception.what());
  }
  if (!problem.empty())
  {
    result = {};
    result.error = palpate::joined(path, ": ", problem, ".");
  }
  return result;
}
} // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "BodyFile.h"

#include "CollectingWindow.h"
#include "Response/FlatBodyConversion.h"
#include "Mechanics/JoinedText.h"
#include "MeshFileCheck.h"
#include "PromptReader.h"

#include "vtkBodySurface.h"
#include "vtkLayerThickness.h"
#include "vtkSkinSurface.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataSetReader.h"
#include "vtkImageData.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkSTLReader.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <exception>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace
{
//------------------------------------------------------------------------------
template <class Reader>
vtkSmartPointer<vtkAlgorithm> makeReader(const std::string& path)
{
  auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.c_str());
  return reader;
}

struct Format
{
  const char* extension;
  vtkSmartPointer<vtkAlgorithm> (*reader)(const std::string& path);
};
const Format formats[] = {
  { ".vtp", makeReader<palpate::PromptReader<vtkXMLPolyDataReader>> },
  { ".stl", makeReader<vtkSTLReader> },
  { ".ply", makeReader<vtkPLYReader> },
  { ".obj", makeReader<vtkOBJReader> },
  { ".vtu", makeReader<palpate::PromptReader<vtkXMLUnstructuredGridReader>> },
  { ".vtk", makeReader<vtkDataSetReader> },
  { ".vti", makeReader<palpate::PromptReader<vtkXMLImageDataReader>> },
  { ".nii", makeReader<vtkNIFTIImageReader> },
  { ".nii.gz", makeReader<vtkNIFTIImageReader> },
};

/** The format by the end of the file name, upper or lower case; null if unknown. */
const Format* findFormat(std::string path)
{
  std::transform(path.begin(), path.end(), path.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const Format& format : formats)
  {
    const std::string end = format.extension;
    if (path.size() > end.size() && path.compare(path.size() - end.size(), end.size(), end) == 0)
    {
      return &format;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
/** Why the file cannot be read at all; "" if it can. */
std::string fileProblem(const std::string& path)
{
  std::error_code code;
  const auto status = std::filesystem::status(path, code);
  if (!std::filesystem::exists(status))
  {
    return "there is no such file";
  }
  if (std::filesystem::is_directory(status))
  {
    return "it is a folder";
  }
  if (!std::ifstream(path).good())
  {
    return "it may not be read";
  }
  return std::ifstream(path).peek() == std::ifstream::traits_type::eof() ? "it is empty" : "";
}

/** Adds LayerThickness to the skin of a scan, in the file's unit of length. */
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

/** The outer skin of a scan. */
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
    size[2], " voxels at grey level ", options.contourValue, ", openings up to ",
    2.0 * options.closingRadius, " mm closed: ", skin->GetOutput()->GetNumberOfPoints(),
    " points"));
  if (options.baseValue)
  {
    return withThickness(skin->GetOutput(), scan, options);
  }
  return skin->GetOutput();
}

/** Converts a body's thickness from the file's unit of length to millimetres. */
void scaleThickness(vtkPolyData* body, double factor)
{
  vtkDataArray* given = body->GetPointData()->GetArray("LayerThickness");
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

/** Why the data are not a body, without the filter's prefix. */
std::string bodyProblem(const palpate::CollectingWindow* complaints)
{
  const std::string before = "Wrong input: ";
  const std::string& reason = complaints->reason();
  return reason.compare(0, before.size(), before) == 0 ? reason.substr(before.size()) : reason;
}

/** Reads `path` into `result`; returns what went wrong, "" if nothing. */
std::string read(const std::string& path, const palpate::BodyFileOptions& options,
  const palpate::CollectingWindow* complaints, palpate::BodyFileResult& result)
{
  const Format* format = findFormat(path);
  if (!format)
  {
    std::string known = " .palpate";
    for (const Format& one : formats)
    {
      known += palpate::joined(" ", one.extension);
    }
    return "unknown kind of file; a body may be" + known;
  }
  std::string problem = fileProblem(path);
  if (problem.empty())
  {
    problem = palpate::meshFileProblem(path, format->extension);
  }
  if (!problem.empty())
  {
    return problem;
  }
  if (!(options.lengthScale > 0.0) || !std::isfinite(options.lengthScale))
  {
    return palpate::joined("a unit of length of ", options.lengthScale, " mm makes no sense");
  }

  // The content of the file.
  vtkSmartPointer<vtkAlgorithm> reader = format->reader(path);
  reader->Update();
  auto* data = vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  if (complaints->hasFailed() || !data)
  {
    return "cannot be read: " + complaints->reason();
  }
  if (vtkSTLReader::SafeDownCast(reader) && data->GetNumberOfPoints() > 0)
  {
    result.notes.push_back(palpate::joined(3 * data->GetNumberOfCells(),
      " corners of facets merged into ", data->GetNumberOfPoints(), " points"));
  }

  // As triangles in millimetres.
  vtkSmartPointer<vtkDataSet> content = data;
  if (auto* scan = vtkImageData::SafeDownCast(data))
  {
    content = skinOf(scan, options, result.notes);
  }
  vtkNew<vtkBodySurface> surface;
  surface->SetInputData(content);
  surface->SetLengthScale(options.lengthScale);
  surface->AskAboutSizeOff(); // asked below, by the name of the option
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
  scaleThickness(body, options.lengthScale);
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
    result.notes.push_back("the reader warns: " + complaints->firstWarning());
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
    problem = read(path, options, quiet.window, result);
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

// SPDX-License-Identifier: BSD-3-Clause
#include "BodyFile.h"

#include "BodyConversion.h"
#include "CollectingWindow.h"
#include "FlatBodyConversion.h"
#include "MeshFileCheck.h"
#include "PromptReader.h"

#include "vtkLayerThickness.h"
#include "vtkSkinSurface.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkDataSetReader.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkImageData.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkReverseSense.h"
#include "vtkSTLReader.h"
#include "vtkTriangleFilter.h"
#include "vtkUnstructuredGrid.h"
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
constexpr double SmallestBody = 5.0;   // mm, longest side of a plausible body
constexpr double LargestBody = 5000.0; // mm

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

/** Text from parts. */
template <class... Parts>
std::string join(const Parts&... parts)
{
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

//------------------------------------------------------------------------------
/** What keeps the file from being read at all; "" if nothing. */
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

/** Cells that name points which are not there would crash the filters; "" if there are none. */
std::string cellProblem(vtkDataSet* data)
{
  std::vector<vtkCellArray*> arrays;
  if (auto* surface = vtkPolyData::SafeDownCast(data))
  {
    arrays = { surface->GetVerts(), surface->GetLines(), surface->GetPolys(),
      surface->GetStrips() };
  }
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    arrays = { grid->GetCells() };
  }
  for (vtkCellArray* cells : arrays)
  {
    if (cells && cells->GetNumberOfConnectivityIds() > 0)
    {
      double ids[2];
      cells->GetConnectivityArray()->GetRange(ids);
      const double wrong = ids[0] < 0 ? ids[0] : ids[1];
      if (!cells->IsValid() || wrong < 0 || wrong >= static_cast<double>(data->GetNumberOfPoints()))
      {
        return join("its cells are damaged: one names point ", static_cast<vtkIdType>(wrong),
          ", there are ", data->GetNumberOfPoints(), " points");
      }
    }
  }
  return "";
}

/** How many coordinates are not numbers, and where; "" if none. */
std::string coordinateProblem(vtkDataSet* data)
{
  vtkIdType count = 0;
  vtkIdType first = -1;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double p[3];
    data->GetPoint(i, p);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    {
      first = count++ == 0 ? i : first;
    }
  }
  return count == 0
    ? ""
    : join(count, " of ", data->GetNumberOfPoints(),
        " points have a coordinate that is not a finite number, the first is point ", first);
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
  notes.push_back(join("outer skin of a scan of ", size[0], " x ", size[1], " x ", size[2],
    " voxels at grey level ", options.contourValue, ", openings up to ",
    2.0 * options.closingRadius, " mm closed: ", skin->GetOutput()->GetNumberOfPoints(),
    " points"));
  if (options.baseValue)
  {
    return withThickness(skin->GetOutput(), scan, options);
  }
  return skin->GetOutput();
}

/** Whatever the file holds, as polygons. */
vtkSmartPointer<vtkPolyData> surfaceOf(
  vtkDataSet* data, const palpate::BodyFileOptions& options, std::vector<std::string>& notes)
{
  if (auto* surface = vtkPolyData::SafeDownCast(data))
  {
    return surface;
  }
  if (auto* scan = vtkImageData::SafeDownCast(data))
  {
    return skinOf(scan, options, notes);
  }
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(data);
  surface->Update();
  notes.push_back(join("surface extracted from ", data->GetNumberOfCells(), " cells"));
  return surface->GetOutput();
}

/** Only triangles; a surface that has nothing else comes back itself. */
vtkSmartPointer<vtkPolyData> trianglesOf(vtkPolyData* surface, std::vector<std::string>& notes)
{
  const vtkIdType strips = surface->GetNumberOfStrips();
  const vtkIdType others = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  const bool polygons =
    surface->GetNumberOfPolys() > 0 && surface->GetPolys()->IsHomogeneous() != 3;
  if (!polygons && strips + others == 0)
  {
    return surface;
  }
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(surface);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  if (polygons || strips > 0)
  {
    notes.push_back(join(surface->GetNumberOfPolys(), " polygons and ", strips, " strips cut into ",
      triangles->GetOutput()->GetNumberOfPolys(), " triangles"));
  }
  if (others > 0)
  {
    notes.push_back(join(others, " vertices and lines left out"));
  }
  return triangles->GetOutput();
}

void scale(vtkPolyData* body, double factor)
{
  auto scaled = vtkSmartPointer<vtkPoints>::New();
  scaled->SetDataType(body->GetPoints()->GetDataType());
  scaled->SetNumberOfPoints(body->GetNumberOfPoints());
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    double p[3];
    body->GetPoint(i, p);
    scaled->SetPoint(i, factor * p[0], factor * p[1], factor * p[2]);
  }
  body->SetPoints(scaled);
  if (vtkDataArray* thickness = body->GetPointData()->GetArray("LayerThickness"))
  {
    for (vtkIdType i = 0; i < thickness->GetNumberOfTuples(); ++i)
    {
      thickness->SetTuple1(i, factor * thickness->GetTuple1(i));
    }
  }
}

/** Closed, with its triangles wound so that the enclosed volume is negative. */
bool isInsideOut(vtkPolyData* body)
{
  const palpate::BodyMesh mesh = palpate::makeBodyMesh(body);
  return mesh.isClosed() && mesh.enclosedVolume() < 0.0;
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
      known += join(" ", one.extension);
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
    return join("a unit of length of ", options.lengthScale, " mm makes no sense");
  }

  // The file as it is.
  vtkSmartPointer<vtkAlgorithm> reader = format->reader(path);
  reader->Update();
  auto* data = vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  if (complaints->hasFailed() || !data)
  {
    return "cannot be read: " + complaints->reason();
  }
  problem = cellProblem(data);
  if (problem.empty() && !vtkImageData::SafeDownCast(data))
  {
    problem = coordinateProblem(data);
  }
  if (!problem.empty())
  {
    return problem;
  }
  if (vtkSTLReader::SafeDownCast(reader) && data->GetNumberOfPoints() > 0)
  {
    result.notes.push_back(join(3 * data->GetNumberOfCells(), " corners of facets merged into ",
      data->GetNumberOfPoints(), " points"));
  }

  // As triangles in millimetres.
  vtkNew<vtkPolyData> body;
  body->ShallowCopy(trianglesOf(surfaceOf(data, options, result.notes), result.notes));
  if (complaints->hasFailed())
  {
    return complaints->reason();
  }
  if (body->GetNumberOfPolys() == 0)
  {
    const std::string& reason = complaints->reason();
    return join("holds no triangles", reason.empty() ? "" : ": ", reason);
  }
  if (options.lengthScale != 1.0)
  {
    scale(body, options.lengthScale);
    result.notes.push_back(join("scaled by ", options.lengthScale, " to millimetres"));
  }
  if (!body->GetPointData()->GetNormals() && isInsideOut(body))
  {
    vtkNew<vtkReverseSense> turned;
    turned->SetInputData(body);
    turned->Update();
    body->ShallowCopy(turned->GetOutput());
    result.notes.push_back("it was inside out: triangles turned");
  }

  // As large as a body?
  double box[6];
  body->GetBounds(box);
  const double longest = std::max({ box[1] - box[0], box[3] - box[2], box[5] - box[4] });
  if (longest < SmallestBody || longest > LargestBody)
  {
    result.notes.push_back(join("its longest side is ", longest, " mm: is --length-unit right?"));
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
    problem = join("cannot be read: ", exception.what());
  }
  if (!problem.empty())
  {
    result = {};
    result.error = join(path, ": ", problem, ".");
  }
  return result;
}
} // namespace palpate

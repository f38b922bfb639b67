// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Files/BodyData.h"

#include "Contact/MeshFiles/ObjFile.h"
#include "Contact/MeshFiles/PlyFault.h"
#include "Contact/MeshFiles/StlFile.h"
#include "Mechanics/JoinedText.h"
#include "Response/Files/CollectingWindow.h"
#include "Response/Files/DataFault.h"
#include "Response/Files/NiftiFile.h"
#include "Response/Files/PromptReader.h"
#include "Response/Files/TrialRun.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkDataSetReader.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMergePoints.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <cctype>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>

namespace palpate
{
namespace
{
/// Returns the reason why the file cannot be read at all; "" if it can be read.
std::string accessFault(const std::string& path)
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
    return "there is no permission to read it";
  }
  return std::ifstream(path).peek() == std::ifstream::traits_type::eof() ? "it is empty" : "";
}

vtkSmartPointer<vtkFloatArray> vectors(const std::vector<float>& values)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size() / 3));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

vtkSmartPointer<vtkIdTypeArray> indices(const std::vector<std::int64_t>& values)
{
  auto array = vtkSmartPointer<vtkIdTypeArray>::New();
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

vtkSmartPointer<vtkPolyData> asPolyData(const FileMesh& mesh)
{
  auto made = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetData(vectors(mesh.points));
  made->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  cells->SetData(indices(mesh.starts), indices(mesh.corners));
  made->SetPolys(cells);
  if (!mesh.normals.empty())
  {
    const auto normals = vectors(mesh.normals);
    normals->SetName("Normals");
    made->GetPointData()->SetNormals(normals);
  }
  return made;
}

/// Merges corners at the same position into one point. Leaves out triangles that have two corners
/// at the same position.
vtkSmartPointer<vtkPolyData> mergedCorners(vtkPolyData* facets)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkMergePoints> places;
  places->InitPointInsertion(points, facets->GetBounds(), facets->GetNumberOfPoints());
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType corner = 0; corner < facets->GetNumberOfPoints(); corner += 3)
  {
    vtkIdType ids[3];
    for (vtkIdType k = 0; k < 3; ++k)
    {
      places->InsertUniquePoint(facets->GetPoint(corner + k), ids[k]);
    }
    if (ids[0] != ids[1] && ids[1] != ids[2] && ids[2] != ids[0])
    {
      triangles->InsertNextCell(3, ids);
    }
  }
  auto merged = vtkSmartPointer<vtkPolyData>::New();
  merged->SetPoints(points);
  merged->SetPolys(triangles);
  return merged;
}

void take(FileMesh mesh, BodyData& result)
{
  result.fault = mesh.fault;
  result.notes = mesh.notes;
  if (mesh.fault.empty())
  {
    result.data = asPolyData(mesh);
  }
}

void readObjFile(const std::string& path, BodyData& result)
{
  std::ifstream file(path, std::ios::binary);
  take(readObj(file), result);
}

void readStlFile(const std::string& path, BodyData& result)
{
  std::ifstream file(path, std::ios::binary);
  take(readStl(file), result);
  if (result.data && result.data->GetNumberOfPoints() > 0)
  {
    const auto merged = mergedCorners(vtkPolyData::SafeDownCast(result.data));
    result.notes.push_back(joined(result.data->GetNumberOfPoints(),
      " corners of facets merged into ", merged->GetNumberOfPoints(), " points"));
    result.data = merged;
  }
}

/// Returns an upper limit of the memory for the content of a file, in bytes. DEFLATE compresses by
/// a factor of at most 1032.
double memoryFor(const std::string& path)
{
  constexpr double Least = 2.5e8;
  constexpr double Most = 1100.0;
  std::error_code ignored;
  return Least + Most * static_cast<double>(std::filesystem::file_size(path, ignored));
}

/// Replaces unprintable characters. Error messages of Palpate and VTK may quote any content of the
/// file.
std::string printable(std::string text)
{
  std::replace_if(
    text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}

std::string noFault()
{
  return "";
}

/// Reads the file with a VTK reader. Does not read it if the reader crashed in the trial run, or if
/// `fault` finds an error in the reader's information about the content.
void update(vtkAlgorithm* reader, const std::string& path, BodyData& result,
  const std::function<std::string()>& fault = noFault)
{
  const double memory = memoryFor(path);
  const auto read = [reader, &fault]
  {
    reader->UpdateInformation();
    std::string found = fault();
    if (found.empty())
    {
      reader->Update();
    }
    return found;
  };
  const std::string crash = crashOf(read, memory);
  if (!crash.empty())
  {
    result.fault =
      joined("it is damaged: VTK's ", reader->GetClassName(), " crashes on it (", crash, ')');
    return;
  }
  const QuietScope quiet;
  result.fault = read();
  if (!result.fault.empty())
  {
    return;
  }
  auto* data = vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  if (quiet.window->hasFailed() || !data)
  {
    result.fault = "cannot be read: " + quiet.window->reason();
    return;
  }
  result.fault = dataFault(data, memory);
  if (result.fault.empty())
  {
    result.data = data;
  }
  if (!quiet.window->firstWarning().empty())
  {
    result.notes.push_back(printable("the reader warns: " + quiet.window->firstWarning()));
  }
}

template <class Reader>
void readByVtk(const std::string& path, BodyData& result)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  update(reader, path, result);
}

void readPlyFile(const std::string& path, BodyData& result)
{
  std::ifstream file(path, std::ios::binary);
  result.fault = plyFault(file);
  if (result.fault.empty())
  {
    readByVtk<vtkPLYReader>(path, result);
  }
}

void readNiftiFile(const std::string& path, BodyData& result)
{
  vtkNew<vtkNIFTIImageReader> reader;
  reader->SetFileName(path.c_str());
  update(reader, path, result, [&reader] { return niftiFault(reader); });
  if (auto* image = vtkImageData::SafeDownCast(result.data))
  {
    result.fault = applyNiftiHeader(reader, image, result.notes);
    if (!result.fault.empty())
    {
      result.data = nullptr;
    }
  }
}

struct Format
{
  const char* extension;
  void (*read)(const std::string& path, BodyData& result);
};
const Format formats[] = {
  { ".vtp", readByVtk<PromptReader<vtkXMLPolyDataReader>> },
  { ".stl", readStlFile },
  { ".ply", readPlyFile },
  { ".obj", readObjFile },
  { ".vtu", readByVtk<PromptReader<vtkXMLUnstructuredGridReader>> },
  { ".vtk", readByVtk<vtkDataSetReader> },
  { ".vti", readByVtk<PromptReader<vtkXMLImageDataReader>> },
  { ".nii", readNiftiFile },
  { ".nii.gz", readNiftiFile },
};

/// Returns the format that belongs to the file name extension, in upper or lower case. Returns null
/// if the extension is unknown.
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
} // namespace

std::string bodyFileExtensions()
{
  std::string all;
  for (const Format& format : formats)
  {
    all += joined(all.empty() ? "" : " ", format.extension);
  }
  return all;
}

BodyData readBodyData(const std::string& path)
{
  BodyData result;
  const Format* format = findFormat(path);
  result.fault = !format ? "unknown kind of file; a body may be .palpate " + bodyFileExtensions()
                         : accessFault(path);
  if (!result.fault.empty())
  {
    return result;
  }
  try
  {
    format->read(path, result);
  }
  catch (const std::exception& exception)
  {
    result = {};
    result.fault = joined("cannot be read: ", exception.what());
  }
  result.fault = printable(result.fault);
  return result;
}
} // namespace palpate

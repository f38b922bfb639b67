// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Files/NiftiFile.h"

#include "Mechanics/JoinedText.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNIFTIImageHeader.h"
#include "vtkNIFTIImageReader.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

namespace palpate
{
namespace
{
// Largest ratio of the size of the content to the size of a gzip file.
constexpr double MostDeflated = 1032.0;
/// Smallest volume that the three axes may span, as a fraction of the volume of a box with the same
/// side lengths.
constexpr double SmallestVolume = 1e-6;

using Affine = Eigen::Matrix<double, 3, 4>; // maps voxel indices to the coordinates of the file

bool isCompressed(const std::string& path)
{
  // The path ends in ".gz" or ".nii", so its last letter distinguishes them.
  return path.size() > 2 && (path.back() == 'z' || path.back() == 'Z');
}

Affine sform(vtkNIFTIImageHeader* header)
{
  Affine made;
  for (int i = 0; i < 4; ++i)
  {
    made.col(i) << header->GetSRowX()[i], header->GetSRowY()[i], header->GetSRowZ()[i];
  }
  return made;
}

/// Returns the side lengths of a voxel; 1 if the header does not state them.
Eigen::Vector3d voxelSides(vtkNIFTIImageHeader* header)
{
  Eigen::Vector3d sides;
  for (int i = 0; i < 3; ++i)
  {
    const double side = std::abs(header->GetPixDim(i + 1));
    sides[i] = side == 0.0 ? 1.0 : side;
  }
  return sides;
}

/// Returns the rotation that the quaternion of the header describes. The header stores three
/// components. The first component of the quaternion follows from them.
Affine qform(vtkNIFTIImageHeader* header)
{
  const Eigen::Vector3d vector(header->GetQuaternB(), header->GetQuaternC(), header->GetQuaternD());
  const double rest = 1.0 - vector.squaredNorm();
  Eigen::Quaterniond turn(std::sqrt(std::max(rest, 0.0)), vector[0], vector[1], vector[2]);
  turn.normalize();
  Eigen::Vector3d sides = voxelSides(header);
  sides[2] *= header->GetPixDim(0) < 0.0 ? -1.0 : 1.0;
  Affine made;
  made.leftCols<3>() = turn.toRotationMatrix() * sides.asDiagonal();
  made.col(3) << header->GetQOffsetX(), header->GetQOffsetY(), header->GetQOffsetZ();
  return made;
}

Affine voxelAxes(vtkNIFTIImageHeader* header)
{
  Affine made = Affine::Zero();
  made.leftCols<3>() = voxelSides(header).asDiagonal();
  return made;
}

/// Returns the number of millimetres per length unit of the file.
double unitOf(vtkNIFTIImageHeader* header)
{
  constexpr int SpatialBits = 7;
  constexpr int Metre = 1;
  constexpr int Micrometre = 3;
  const int unit = header->GetXYZTUnits() & SpatialBits;
  return unit == Metre ? 1000.0 : unit == Micrometre ? 0.001 : 1.0;
}

/// Returns whether the axes span a volume. If they do not, points have no unique position in the
/// image.
bool spansVolume(const Affine& affine)
{
  const Eigen::Matrix3d axes = affine.leftCols<3>();
  const double box = axes.colwise().norm().prod();
  return affine.allFinite() && box > std::numeric_limits<double>::min() && std::isfinite(box) &&
    std::abs(axes.determinant()) > SmallestVolume * box;
}

void place(vtkImageData* image, const Affine& affine)
{
  std::array<double, 9> direction{};
  std::array<double, 3> spacing{};
  for (int axis = 0; axis < 3; ++axis)
  {
    spacing[static_cast<std::size_t>(axis)] = affine.col(axis).norm();
    for (int row = 0; row < 3; ++row)
    {
      direction[static_cast<std::size_t>(3 * row + axis)] =
        affine(row, axis) / affine.col(axis).norm();
    }
  }
  image->SetOrigin(affine(0, 3), affine(1, 3), affine(2, 3));
  image->SetSpacing(spacing.data());
  image->SetDirectionMatrix(direction.data());
}

void scaleValues(vtkImageData* image, double slope, double intercept)
{
  vtkDataArray* read = image->GetPointData()->GetScalars();
  const bool isExact = read->GetDataTypeSize() <= 2 || read->GetDataType() == VTK_FLOAT;
  vtkSmartPointer<vtkDataArray> scaled;
  scaled.TakeReference(
    isExact ? static_cast<vtkDataArray*>(vtkFloatArray::New()) : vtkDoubleArray::New());
  scaled->SetName(read->GetName());
  scaled->SetNumberOfTuples(read->GetNumberOfTuples());
  for (vtkIdType i = 0; i < read->GetNumberOfTuples(); ++i)
  {
    scaled->SetComponent(i, 0, slope * read->GetComponent(i, 0) + intercept);
  }
  image->GetPointData()->SetScalars(scaled);
}
} // namespace

std::string niftiFault(vtkNIFTIImageReader* reader)
{
  vtkNIFTIImageHeader* header = reader->GetNIFTIHeader();
  const std::string magic = header->GetMagic() ? std::string(header->GetMagic(), 3) : "";
  if (magic != "n+1" && magic != "n+2")
  {
    return "it is not a NIfTI file: its header does not have the mark n+1 or n+2";
  }
  const auto dimensions = header->GetDim(0);
  double voxels = 1.0;
  for (int i = 1; i <= 7 && i <= dimensions; ++i)
  {
    const auto size = header->GetDim(i);
    if (size < 1 || size > std::numeric_limits<int>::max())
    {
      return joined("dim[", i, "] of its header is ", size);
    }
    if (i > 3 && size > 1)
    {
      return joined("it holds ", size, " images (dim[", i,
        "] of its header): extract one of them to a file of three dimensions");
    }
    voxels *= static_cast<double>(size);
  }
  if (dimensions < 3)
  {
    return joined("it has ", dimensions, " dimensions, but three are needed");
  }
  if (reader->GetNumberOfScalarComponents() != 1)
  {
    return joined("its voxels have ", reader->GetNumberOfScalarComponents(),
      " components (colours or complex numbers), but one is needed");
  }
  const std::string path = reader->GetFileName();
  const double offset = static_cast<double>(header->GetVoxOffset());
  const double needed =
    offset + voxels * vtkDataArray::GetDataTypeSize(reader->GetDataScalarType());
  std::error_code ignored;
  const auto size = static_cast<double>(std::filesystem::file_size(path, ignored));
  if (!(offset >= 0.0) || needed > size * (isCompressed(path) ? MostDeflated : 1.0))
  {
    return joined("its header states ", header->GetDim(1), " x ", header->GetDim(2), " x ",
      header->GetDim(3), " voxels from byte ", offset, " on, ", needed, " bytes, but it has ", size,
      isCompressed(path) ? ", compressed" : "");
  }
  return "";
}

std::string applyNiftiHeader(
  vtkNIFTIImageReader* reader, vtkImageData* image, std::vector<std::string>& notes)
{
  vtkNIFTIImageHeader* header = reader->GetNIFTIHeader();
  const char* const name = header->GetSFormCode() > 0 ? "sform"
    : header->GetQFormCode() > 0                      ? "qform"
                                                      : "pixdim";
  Affine affine = header->GetSFormCode() > 0 ? sform(header)
    : header->GetQFormCode() > 0             ? qform(header)
                                             : voxelAxes(header);
  const double unit = unitOf(header);
  affine *= unit;
  if (!spansVolume(affine))
  {
    return joined("the ", name, " of its header does not span a volume");
  }
  if (reader->GetQFac() < 0.0)
  { // The reader has reversed the order of the slices.
    affine.col(3) += (image->GetDimensions()[2] - 1) * affine.col(2);
    affine.col(2) *= -1.0;
  }
  place(image, affine);
  if (header->GetSFormCode() > 0 || header->GetQFormCode() > 0)
  {
    notes.push_back(joined("placed by the ", name, " of its header"));
  }
  if (unit != 1.0)
  {
    notes.push_back(joined("its header states ", unit > 1.0 ? "metres" : "micrometres"));
  }
  const double slope = reader->GetRescaleSlope();
  const double intercept = reader->GetRescaleIntercept();
  if (slope == 0.0 || (slope == 1.0 && intercept == 0.0))
  {
    return ""; // a slope of 0 means that the header defines no scaling
  }
  if (!std::isfinite(slope) || !std::isfinite(intercept))
  {
    return joined("scl_slope and scl_inter of its header are ", slope, " and ", intercept);
  }
  scaleValues(image, slope, intercept);
  notes.push_back(joined("values times ", slope, " plus ", intercept, ", as its header states"));
  return "";
}
} // namespace palpate

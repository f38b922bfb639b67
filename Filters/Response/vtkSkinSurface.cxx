// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkinSurface.h"

#include "Response/FilterStage.h"
#include "Response/Bodies/SkinLevel.h"
#include "Response/Bodies/SkinScan.h"

#include "vtkArrayDispatch.h"
#include "vtkCellArray.h"
#include "vtkCleanPolyData.h"
#include "vtkDataArrayRange.h"
#include "vtkFloatArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkImageResize.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataConnectivityFilter.h"
#include "vtkReverseSense.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTriangleMeshPointNormals.h"
#include "vtkWindowedSincPolyDataFilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>

vtkStandardNewMacro(vtkSkinSurface);

namespace
{
using Stage = palpate::FilterStage;

/// Pass band of the smoothing on a lattice as fine as the scan. It removes the traces of voxels,
/// waves of up to about ten spacings, and keeps longer waves.
constexpr double PassBand = 0.02;
constexpr double MaximumVoxels = 4e9; // largest number of voxels of the resampled scan: 16 GB
constexpr float Clearance = 0.005f;   // see KeepClearOfVoxels

/** The scalars as floats; NaN and infinities become the lowest value. */
palpate::SkinScan TakeScan(vtkImageData* image, vtkDataArray* scalars, double lowest)
{
  palpate::SkinScan scan;
  image->GetDimensions(scan.size.data());
  std::transform(image->GetSpacing(), image->GetSpacing() + 3, scan.spacing.begin(),
    [](double spacing) { return std::abs(spacing); });
  auto copy = [&scan](auto* array)
  {
    const auto values = vtk::DataArrayValueRange<1>(array);
    scan.values.assign(values.begin(), values.end());
  };
  if (!vtkArrayDispatch::Dispatch::Execute(scalars, copy))
  {
    copy(scalars);
  }
  std::replace_if(
    scan.values.begin(), scan.values.end(), [](float value) { return !std::isfinite(value); },
    static_cast<float>(lowest));
  return scan;
}

/** The scan as an image whose coordinates are index times spacing. */
vtkSmartPointer<vtkImageData> AsImage(palpate::SkinScan& scan)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(scan.size.data());
  image->SetSpacing(scan.spacing.data());
  vtkNew<vtkFloatArray> values;
  values->SetName("Grey");
  values->SetArray(scan.values.data(), static_cast<vtkIdType>(scan.values.size()), 1);
  image->GetPointData()->SetScalars(values);
  return image;
}

/** Size of a lattice with a spacing of about `resolution` over the same box; 0 = unchanged. */
std::array<int, 3> ResampledSize(const palpate::SkinScan& scan, double resolution)
{
  std::array<int, 3> size = scan.size;
  for (int axis = 0; axis < 3 && resolution > 0.0; ++axis)
  {
    const double length = (scan.size[axis] - 1) * scan.spacing[axis];
    size[axis] = static_cast<int>(std::max(1.0, std::round(length / resolution))) + 1;
  }
  return size;
}

/**
 * Moves grey levels away that are closer to the contour value than a small fraction of the step
 * from air to tissue. Voxels exactly at the contour value would give triangles without area.
 */
void KeepClearOfVoxels(vtkImageData* image, float contour, float tissue)
{
  const float margin = Clearance * (tissue - contour);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const float above = values[i] - contour;
    values[i] = std::abs(above) < margin ? contour + std::copysign(margin, above) : values[i];
  }
}

/** Returns the largest region of the contour; null if aborted. */
vtkSmartPointer<vtkPolyData> Contour(vtkImageData* image, double contour, vtkAlgorithm* self)
{
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(image);
  edges->SetValue(0, contour);
  edges->ComputeNormalsOff();
  edges->ComputeScalarsOff();
  vtkNew<vtkPolyDataConnectivityFilter> largest;
  largest->SetInputConnection(edges->GetOutputPort());
  largest->SetExtractionModeToLargestRegion();
  vtkNew<vtkCleanPolyData> used; // removes the points of the other regions
  used->SetInputConnection(largest->GetOutputPort());
  used->PointMergingOff();
  const bool done = palpate::runWithin(edges, { self, 0.35, 0.45 }) &&
    palpate::runWithin(largest, { self, 0.45, 0.6 }) &&
    palpate::runWithin(used, { self, 0.6, 0.7 });
  return done ? used->GetOutput() : nullptr;
}

/**
 * Sets the window for which PassBand was chosen: it leaves 3 % of waves of 8 spacings. Before March
 * 2024 (VTK 9.4, and the 9.3 in ParaView 5.13) VTK had no other window. Since then Nuttall's window
 * is the default. It needs more iterations for the same result, and leaves 54 %.
 */
template <typename TFilter>
auto UseHamming(TFilter* smooth, int) -> decltype(smooth->SetWindowFunctionToHamming())
{
  smooth->SetWindowFunctionToHamming();
}
template <typename TFilter>
void UseHamming(TFilter*, long)
{
}

/** Runs VTK's windowed-sinc filter. Smooth corrects the scale of the result. */
bool SmoothRaw(vtkPolyData* surface, int iterations, double passBand, Stage stage)
{
  vtkNew<vtkWindowedSincPolyDataFilter> smooth;
  smooth->SetInputData(surface);
  smooth->SetNumberOfIterations(iterations);
  smooth->SetPassBand(passBand);
  smooth->NormalizeCoordinatesOn();
  smooth->BoundarySmoothingOff();
  UseHamming(smooth.Get(), 0);
  const bool done = palpate::runWithin(smooth, stage);
  surface->ShallowCopy(smooth->GetOutput());
  return done;
}

/**
 * Windowed-sinc smoothing that does not move border points. The filter's gain at frequency zero is
 * not quite 1: it scales all points about the centre of the box by about 0.2 %. This function
 * reverses the scaling. The factor is found by smoothing a triangle, all of whose points are border
 * points.
 */
bool Smooth(vtkPolyData* surface, int iterations, double passBand, Stage stage)
{
  vtkNew<vtkPoints> corners;
  corners->InsertNextPoint(0.0, 0.0, 0.0);
  corners->InsertNextPoint(1.0, 0.0, 0.0);
  corners->InsertNextPoint(0.0, 1.0, 0.0);
  vtkNew<vtkCellArray> one;
  one->InsertNextCell({ 0, 1, 2 });
  vtkNew<vtkPolyData> triangle;
  triangle->SetPoints(corners);
  triangle->SetPolys(one);
  double centre[3];
  surface->GetCenter(centre);
  if (iterations < 1 ||
    !SmoothRaw(triangle, iterations, passBand, { stage.filter, stage.from, stage.from }) ||
    !SmoothRaw(surface, iterations, passBand, stage))
  {
    return stage(1.0);
  }
  const double gain = triangle->GetBounds()[1] - triangle->GetBounds()[0];
  vtkPoints* points = surface->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] = centre[axis] + (p[axis] - centre[axis]) / gain;
    }
    points->SetPoint(i, p);
  }
  return stage(1.0);
}

/** Transforms points from index times spacing to the physical coordinates of `image`. */
void PlaceAs(vtkImageData* image, vtkPoints* points)
{
  const int* extent = image->GetExtent();
  const double* spacing = image->GetSpacing();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double point[3];
    double index[3];
    points->GetPoint(i, point);
    for (int axis = 0; axis < 3; ++axis)
    {
      index[axis] = point[axis] / std::abs(spacing[axis]) + extent[2 * axis];
    }
    image->TransformContinuousIndexToPhysicalPoint(index, point);
    points->SetPoint(i, point);
  }
}

/** Adds outward point normals. Returns false if aborted. */
bool Orient(vtkPolyData* surface, vtkImageData* image, Stage stage)
{
  const double* spacing = image->GetSpacing();
  const double handedness = image->GetDirectionMatrix()->Determinant() * spacing[0] * spacing[1] *
    spacing[2]; // flying edges wind outward in a right-handed lattice
  vtkNew<vtkReverseSense> reverse;
  reverse->SetInputData(surface);
  reverse->SetReverseCells(handedness < 0.0);
  // vtkPolyDataNormals is not used, since it sums in the order of the threads.
  vtkNew<vtkTriangleMeshPointNormals> normals;
  normals->SetInputConnection(reverse->GetOutputPort());
  const bool done = palpate::runWithin(normals, stage);
  surface->ShallowCopy(normals->GetOutput());
  return done;
}

/** Checks the input and the properties. Returns "" if they are valid, else an error message. */
std::string Problem(vtkImageData* image, vtkDataArray* scalars, double closing, double resolution)
{
  std::ostringstream text;
  const int* size = image->GetDimensions();
  const double* spacing = image->GetSpacing();
  const double voxel = std::abs(spacing[0] * spacing[1] * spacing[2]);
  const double voxels = voxel * image->GetNumberOfPoints() / std::pow(resolution, 3);
  if (!scalars)
  {
    text << "the scan has no point scalars to contour.";
  }
  else if (scalars->GetNumberOfComponents() != 1)
  {
    text << "the scan's scalars have " << scalars->GetNumberOfComponents()
         << " components, but one is needed.";
  }
  else if (std::min({ size[0], size[1], size[2] }) < 2 || !(voxel > 0.0))
  {
    text << "the scan must extend in three dimensions, but has " << size[0] << " x " << size[1]
         << " x " << size[2] << " voxels of " << voxel << " mm^3.";
  }
  else if (!(closing >= 0.0 && resolution >= 0.0 && std::isfinite(closing + resolution)))
  {
    text << "Closing Radius and Resolution must be 0 mm or more, but are " << closing << " and "
         << resolution << ".";
  }
  else if (resolution > 0.0 && voxels > MaximumVoxels)
  {
    text << "Resolution " << resolution << " mm is too fine: it makes " << voxels << " voxels.";
  }
  return text.str();
}
} // namespace

//------------------------------------------------------------------------------
vtkSkinSurface::vtkSkinSurface()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

//------------------------------------------------------------------------------
int vtkSkinSurface::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSkinSurface::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector*)
{
  // The outer skin is a property of the whole scan.
  vtkInformation* info = input[0]->GetInformationObject(0);
  int whole[6];
  info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), whole, 6);
  return 1;
}

//------------------------------------------------------------------------------
int vtkSkinSurface::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkImageData* image = vtkImageData::GetData(input[0]);
  vtkPolyData* skin = vtkPolyData::GetData(output);
  const int piece =
    output->GetInformationObject(0)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER());
  if (image->GetNumberOfPoints() == 0 || piece > 0)
  {
    return 1; // the first piece has the whole skin
  }
  vtkDataArray* scalars = this->GetInputArrayToProcess(0, input);
  const std::string problem = Problem(image, scalars, this->ClosingRadius, this->Resolution);
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 0;
  }

  double range[2];
  scalars->GetFiniteRange(range);
  const palpate::SkinLevel level =
    palpate::skinLevel(scalars, this->ContourValue, range[0], range[1]);
  this->UsedContourValue = level.given;
  if (!(range[0] < this->UsedContourValue && this->UsedContourValue < range[1]))
  {
    vtkErrorMacro("nothing to contour: Contour Value "
      << this->UsedContourValue << " is not inside the scalars' range, " << range[0] << " to "
      << range[1] << ".");
    return 0;
  }

  // Close the openings, and fill the cavities behind them.
  palpate::SkinScan scan = TakeScan(image, scalars, range[0]);
  level.mark(scan.values);
  if (this->ClosingRadius > 0.0 &&
    !scan.closeOpenings(this->ClosingRadius, Stage{ this, 0.0, 0.2 }))
  {
    return 1;
  }
  const float contour = level.contour;
  const float tissue = level.tissue;
  if (!scan.fillCavities(contour, tissue))
  {
    vtkErrorMacro("nothing to contour: after closing by "
      << this->ClosingRadius << " mm no air, below Contour Value " << this->UsedContourValue
      << ", is left at the border of the scan.");
    return 0;
  }

  // Contour at the requested resolution.
  vtkSmartPointer<vtkImageData> lattice = AsImage(scan);
  std::array<int, 3> size = ResampledSize(scan, this->Resolution);
  if (size != scan.size)
  {
    vtkNew<vtkImageResize> resize;
    resize->SetInputData(lattice);
    resize->SetOutputDimensions(size.data());
    if (!palpate::runWithin(resize, { this, 0.2, 0.35 }))
    {
      return 1;
    }
    lattice = resize->GetOutput();
  }
  KeepClearOfVoxels(lattice, contour, tissue);
  vtkSmartPointer<vtkPolyData> surface = Contour(lattice, contour, this);
  if (surface && surface->GetNumberOfCells() == 0)
  {
    vtkErrorMacro("nothing to contour at Contour Value " << this->UsedContourValue << ".");
    return 0;
  }

  // Smooth the surface, move it to the scan's coordinates, and orient it.
  const double coarser = std::cbrt(1.0 * scan.values.size() / lattice->GetNumberOfPoints());
  const double passBand = PassBand * std::min(1.0, coarser * coarser); // removes waves of the same
                                                                       // length in mm
  if (!surface ||
    !Smooth(surface, this->NumberOfSmoothingIterations, passBand, { this, 0.7, 0.95 }))
  {
    return 1;
  }
  PlaceAs(image, surface->GetPoints());
  if (Orient(surface, image, { this, 0.95, 1.0 }))
  {
    skin->SetPoints(surface->GetPoints());
    skin->SetPolys(surface->GetPolys());
    skin->GetPointData()->SetNormals(surface->GetPointData()->GetNormals());
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkSkinSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ContourValue: " << this->ContourValue << "\n";
  os << indent << "UsedContourValue: " << this->UsedContourValue << "\n";
  os << indent << "ClosingRadius: " << this->ClosingRadius << " mm\n";
  os << indent << "Resolution: " << this->Resolution << " mm\n";
  os << indent << "NumberOfSmoothingIterations: " << this->NumberOfSmoothingIterations << "\n";
}

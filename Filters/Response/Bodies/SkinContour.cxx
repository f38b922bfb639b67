// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Bodies/SkinContour.h"

#include "vtkCellArray.h"
#include "vtkCleanPolyData.h"
#include "vtkFloatArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkImageResize.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataConnectivityFilter.h"
#include "vtkReverseSense.h"
#include "vtkTriangleMeshPointNormals.h"
#include "vtkWindowedSincPolyDataFilter.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
/// Pass band of the smoothing for a lattice as fine as the scan. The smoothing removes traces of
/// voxels, which are waves of up to about ten spacings. It keeps longer waves.
constexpr double PassBand = 0.02;
/// Distance from the contour value, as a fraction of the step from contour value to tissue; see
/// keepClearOfVoxels.
constexpr float Clearance = 0.005F;

/** Returns the stage for the part of `stage` between the fractions `from` and `to`. */
FilterStage part(const FilterStage& stage, double from, double to)
{
  const double length = stage.to - stage.from;
  return { stage.filter, stage.from + from * length, stage.from + to * length };
}

/** Returns the scan as an image. The coordinates of its points are index times spacing. */
vtkSmartPointer<vtkImageData> asImage(SkinScan& scan)
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

/**
 * Returns the size of a lattice over the same box with a spacing of about `resolution`. A
 * resolution of 0 keeps the size.
 */
std::array<int, 3> resampledSize(const SkinScan& scan, double resolution)
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
 * Moves each grey level that is too close to the contour value to a distance of Clearance times the
 * step from contour to tissue. Voxels with exactly the contour value would give triangles without
 * area.
 */
void keepClearOfVoxels(vtkImageData* image, float contour, float tissue)
{
  const float margin = Clearance * (tissue - contour);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const float above = values[i] - contour;
    values[i] = std::abs(above) < margin ? contour + std::copysign(margin, above) : values[i];
  }
}

/** Returns the contour or its largest region. Returns null if the work was aborted. */
vtkSmartPointer<vtkPolyData> contourOf(
  vtkImageData* image, const SkinContour& wanted, const FilterStage& stage)
{
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(image);
  edges->SetValue(0, wanted.value);
  edges->ComputeNormalsOff();
  edges->ComputeScalarsOff();
  vtkNew<vtkPolyDataConnectivityFilter> largest;
  largest->SetInputConnection(edges->GetOutputPort());
  if (wanted.isLargest)
  {
    largest->SetExtractionModeToLargestRegion();
  }
  else
  {
    largest->SetExtractionModeToAllRegions();
  }
  vtkNew<vtkCleanPolyData> used; // this removes the points of the other regions
  used->SetInputConnection(largest->GetOutputPort());
  used->PointMergingOff();
  const bool done = runWithin(edges, part(stage, 0.2, 0.3)) &&
    runWithin(largest, part(stage, 0.3, 0.5)) && runWithin(used, part(stage, 0.5, 0.6));
  return done ? used->GetOutput() : nullptr;
}

/**
 * Sets Hamming's window, for which PassBand was chosen. With this window, waves of 8 spacings keep
 * 3 % of their amplitude. Before March 2024 (VTK 9.4, and the 9.3 in ParaView 5.13) VTK had no
 * other window. Since then Nuttall's window is the default. With Nuttall's window, more iterations
 * are needed for the same result, and the waves keep 54 % of their amplitude.
 */
template <typename TFilter>
auto useHamming(TFilter* smooth, int) -> decltype(smooth->SetWindowFunctionToHamming())
{
  smooth->SetWindowFunctionToHamming();
}
template <typename TFilter>
void useHamming(TFilter*, long)
{
}

/** Runs VTK's windowed-sinc filter. The caller corrects the scale of the result (see smooth). */
bool smoothRaw(vtkPolyData* surface, int iterations, double passBand, FilterStage stage)
{
  vtkNew<vtkWindowedSincPolyDataFilter> smooth;
  smooth->SetInputData(surface);
  smooth->SetNumberOfIterations(iterations);
  smooth->SetPassBand(passBand);
  smooth->NormalizeCoordinatesOn();
  smooth->BoundarySmoothingOff();
  useHamming(smooth.Get(), 0);
  const bool done = runWithin(smooth, stage);
  surface->ShallowCopy(smooth->GetOutput());
  return done;
}

/**
 * Applies windowed-sinc smoothing that does not move border points. The filter's gain at frequency
 * zero is not exactly 1: the filter scales all points about the centre of the box by about 0.2 %.
 * This function reverses the scaling. It finds the factor by smoothing a triangle, because all
 * points of a triangle are border points.
 */
bool smooth(vtkPolyData* surface, int iterations, double passBand, FilterStage stage)
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
    !smoothRaw(triangle, iterations, passBand, { stage.filter, stage.from, stage.from }) ||
    !smoothRaw(surface, iterations, passBand, stage))
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
void placeAs(vtkImageData* image, vtkPoints* points)
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

/** Adds outward point normals. Returns false if the work was aborted. */
bool orient(vtkPolyData* surface, vtkImageData* image, FilterStage stage)
{
  const double* spacing = image->GetSpacing();
  const double handedness = image->GetDirectionMatrix()->Determinant() * spacing[0] * spacing[1] *
    spacing[2]; // flying edges give outward triangles in a right-handed lattice
  vtkNew<vtkReverseSense> reverse;
  reverse->SetInputData(surface);
  reverse->SetReverseCells(handedness < 0.0);
  // vtkPolyDataNormals is not used, because its order of summation depends on the threads.
  vtkNew<vtkTriangleMeshPointNormals> normals;
  normals->SetInputConnection(reverse->GetOutputPort());
  const bool done = runWithin(normals, stage);
  surface->ShallowCopy(normals->GetOutput());
  return done;
}

} // namespace

vtkSmartPointer<vtkPolyData> contourSkin(
  SkinScan& scan, const SkinContour& wanted, vtkImageData* placed, const FilterStage& stage)
{
  vtkSmartPointer<vtkImageData> lattice = asImage(scan);
  std::array<int, 3> size = resampledSize(scan, wanted.resolution);
  if (size != scan.size)
  {
    vtkNew<vtkImageResize> resize;
    resize->SetInputData(lattice);
    resize->SetOutputDimensions(size.data());
    if (!runWithin(resize, part(stage, 0.0, 0.2)))
    {
      return nullptr;
    }
    lattice = resize->GetOutput();
  }
  keepClearOfVoxels(lattice, wanted.value, wanted.tissue);
  vtkSmartPointer<vtkPolyData> surface = contourOf(lattice, wanted, stage);
  if (!surface || surface->GetNumberOfCells() == 0)
  {
    return surface;
  }
  const double coarser =
    std::cbrt(1.0 * static_cast<double>(scan.values.size()) / lattice->GetNumberOfPoints());
  // On a finer lattice, a smaller pass band removes waves of the same length in mm.
  const double passBand = PassBand * std::min(1.0, coarser * coarser);
  if (!smooth(surface, wanted.iterations, passBand, part(stage, 0.6, 0.93)))
  {
    return nullptr;
  }
  placeAs(placed, surface->GetPoints());
  return orient(surface, placed, part(stage, 0.93, 1.0)) ? surface : nullptr;
}
} // namespace palpate

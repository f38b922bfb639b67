// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLayerThickness.h"

#include "Response/Bodies/BaseDepth.h"
#include "Response/Bodies/BaseNeighbours.h"
#include "Contact/ResponseContract.h"
#include "Response/Bodies/SoundBody.h"
#include "Response/FilterStage.h"
#include "Response/Curves/PointNormals.h"

#include "vtkBoundingBox.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkImageInterpolator.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPTools.h"
#include "vtkStaticPointLocator.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

vtkStandardNewMacro(vtkLayerThickness);

namespace
{
constexpr double SamplesPerVoxel = 4.0;
constexpr double MostSamples = 1e6; // largest number of samples per ray
constexpr int ThicknessBlocks = 10;
constexpr float NotFound = std::numeric_limits<float>::infinity();
using Stage = palpate::FilterStage;

double SmallestSpacing(vtkImageData* scan)
{
  const double* spacing = scan->GetSpacing();
  return std::min({ std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2]) });
}

double LargestSpacing(vtkImageData* scan)
{
  const double* spacing = scan->GetSpacing();
  return std::max({ std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2]) });
}

/** Reads the grey values of the scan along rays into the body. */
class Rays
{
public:
  Rays(vtkImageData* scan, vtkDataArray* grey, double depth, double edge, double baseValue)
    : Scan(scan)
    , Step(SmallestSpacing(scan) / SamplesPerVoxel)
    , Samples(static_cast<std::size_t>(std::ceil((depth + edge) / this->Step)) + 1)
    , Depth(depth)
    , Criteria{ baseValue, static_cast<std::ptrdiff_t>(std::ceil(edge / this->Step)),
      static_cast<std::ptrdiff_t>(std::ceil(LargestSpacing(scan) / this->Step)) }
  {
    // The scalars are set as active scalars, because the interpolator reads the active scalars.
    this->Grey->CopyStructure(scan);
    this->Grey->GetPointData()->SetScalars(grey);
    this->Interpolator->SetInterpolationModeToLinear();
    this->Interpolator->SetTolerance(0.5); // in voxels; it allows a skin at the border of the scan
    this->Interpolator->Initialize(this->Grey);
  }

  std::size_t samples() const { return this->Samples; }

  /**
   * Returns the depth of the base under a point, mm; +inf if no base is found. `grey` is a buffer
   * for the samples.
   */
  double operator()(const double point[3], const float* normal, double* grey) const
  {
    double from[3];
    double to[3];
    double end[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      end[axis] = point[axis] - this->Step * static_cast<double>(normal[axis]);
    }
    this->Scan->TransformPhysicalPointToContinuousIndex(point, from);
    this->Scan->TransformPhysicalPointToContinuousIndex(end, to);
    std::size_t count = 0;
    for (; count < this->Samples; ++count)
    {
      double index[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        index[axis] = from[axis] + static_cast<double>(count) * (to[axis] - from[axis]);
      }
      if (!this->Interpolator->CheckBoundsIJK(index))
      {
        break;
      }
      this->Interpolator->InterpolateIJK(index, grey + count);
    }
    const double depth = this->Step * palpate::findBaseDepth(grey, count, this->Criteria);
    return depth <= this->Depth ? depth : std::numeric_limits<double>::infinity();
  }

private:
  vtkImageData* Scan;
  double Step;
  std::size_t Samples;
  double Depth;
  palpate::BaseCriteria Criteria;
  vtkNew<vtkImageData> Grey;
  vtkNew<vtkImageInterpolator> Interpolator;
};

/**
 * Returns whether a surface that faces away from the normal of point `i` is within the distance
 * `reach` of `place`.
 */
bool LeavesBody(const palpate::NormalSurface& surface, vtkIdType i, const double place[3],
  double reach, vtkIdList* near)
{
  surface.locator->FindPointsWithinRadius(reach, place, near);
  return std::any_of(
    near->begin(), near->end(), [&](vtkIdType j) { return surface.cosine(i, j) < 0.0; });
}

/** Runs a loop over `count` points in blocks. Returns false if the work was aborted. */
template <class Loop>
bool ForAll(vtkIdType count, Stage stage, const Loop& loop)
{
  for (vtkIdType block = 0; block < ThicknessBlocks; ++block)
  {
    vtkSMPTools::For(count * block / ThicknessBlocks, count * (block + 1) / ThicknessBlocks, loop);
    if (!stage(static_cast<double>(block + 1) / ThicknessBlocks))
    {
      return false;
    }
  }
  return true;
}
} // namespace

//------------------------------------------------------------------------------
vtkLayerThickness::vtkLayerThickness()
{
  this->SetNumberOfInputPorts(2);
  this->SetInputArrayToProcess(
    0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

//------------------------------------------------------------------------------
int vtkLayerThickness::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkLayerThickness::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  // Any piece of the body may need any part of the scan.
  vtkInformation* info = input[1]->GetInformationObject(0);
  if (info->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
  {
    int whole[6];
    info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), whole, 6);
  }
  return this->Superclass::RequestUpdateExtent(request, input, output);
}

//------------------------------------------------------------------------------
/** Checks the scan and the properties. Returns "" if they are valid, else an error message. */
std::string vtkLayerThickness::Problem(vtkImageData* scan, vtkDataArray* grey) const
{
  std::ostringstream text;
  const int* size = scan->GetDimensions();
  const double smallest = SmallestSpacing(scan);
  if (!grey)
  {
    text << "the scan has no point scalars to read.";
  }
  else if (grey->GetNumberOfComponents() != 1 ||
    grey->GetNumberOfTuples() != scan->GetNumberOfPoints())
  {
    text << "the scan's scalars have " << grey->GetNumberOfComponents() << " components and "
         << grey->GetNumberOfTuples() << " values, but 1 and " << scan->GetNumberOfPoints()
         << " are needed.";
  }
  else if (std::min({ size[0], size[1], size[2] }) < 2 || !(smallest > 0.0))
  {
    text << "the scan must extend in three dimensions, but has " << size[0] << " x " << size[1]
         << " x " << size[2] << " voxels with a smallest spacing of " << smallest << " mm.";
  }
  else if (!std::isfinite(this->BaseValue))
  {
    text << "Grey Value Of Bone (BaseValue) must be finite, but is " << this->BaseValue << ".";
  }
  else if (!(this->MaximumDepth > 0.0 && this->EdgeWidth > 0.0 && this->SmoothingRadius >= 0.0 &&
             std::isfinite(this->MaximumDepth + this->EdgeWidth + this->SmoothingRadius)))
  {
    text << "Maximum Depth and Edge Width must be positive, Smoothing Radius not negative, and all "
            "finite (mm); they are "
         << this->MaximumDepth << ", " << this->EdgeWidth << " and " << this->SmoothingRadius
         << ".";
  }
  else if (!((this->MaximumDepth + this->EdgeWidth) * SamplesPerVoxel / smallest < MostSamples))
  {
    text << "Maximum Depth " << this->MaximumDepth << " mm is too deep for voxels of " << smallest
         << " mm.";
  }
  return text.str();
}

//------------------------------------------------------------------------------
int vtkLayerThickness::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* outputVector)
{
  vtkPolyData* given = vtkPolyData::GetData(input[0]);
  vtkImageData* scan = vtkImageData::GetData(input[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (!given || given->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  const palpate::SoundBody sound(given);
  if (!sound.fault().empty())
  {
    vtkErrorMacro(<< "Wrong input: " << sound.fault() << ".");
    return 0;
  }
  vtkPolyData* body = sound.body();
  vtkDataArray* grey = this->GetInputArrayToProcess(0, input);
  const std::string problem =
    scan ? this->Problem(scan, grey) : std::string("a scan is required on port 1.");
  if (!problem.empty())
  {
    vtkErrorMacro(<< "Wrong input: " << problem);
    return 0;
  }
  if (!vtkBoundingBox(scan->GetBounds()).Intersects(vtkBoundingBox(body->GetBounds())))
  {
    const double* b = body->GetBounds();
    const double* s = scan->GetBounds();
    vtkErrorMacro(<< "Wrong input: the body lies outside the scan: x " << b[0] << " to " << b[1]
                  << ", y " << b[2] << " to " << b[3] << ", z " << b[4] << " to " << b[5]
                  << " mm, but the scan " << s[0] << " to " << s[1] << ", " << s[2] << " to "
                  << s[3] << ", " << s[4] << " to " << s[5] << " mm.");
    return 0;
  }

  const vtkIdType count = body->GetNumberOfPoints();
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);
  vtkNew<vtkUnsignedCharArray> status;
  status->SetNumberOfTuples(count);
  const std::string wrongSide = palpate::fillPointNormals(body, normals, status);
  if (!wrongSide.empty())
  {
    vtkErrorMacro(<< "Wrong input: " << wrongSide << ".");
    return 0;
  }
  const unsigned char* states = status->GetPointer(0);
  const vtkIdType notFinite = std::find(states, states + count,
                                static_cast<unsigned char>(palpate::ResponseStatus::NotFinite)) -
    states;
  if (notFinite < count)
  {
    vtkErrorMacro(<< "Wrong input: point " << notFinite << " or its normal is not finite.");
    return 0;
  }
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(body);
  locator->BuildLocator();
  const palpate::NormalSurface surface{ body->GetPoints(), normals->GetPointer(0), locator };
  const Rays findBase(scan, grey, this->MaximumDepth, this->EdgeWidth, this->BaseValue);

  // This step finds the base under each point.
  std::vector<float> depth(static_cast<std::size_t>(count), NotFound);
  vtkSMPThreadLocalObject<vtkIdList> lists;
  vtkSMPThreadLocal<std::vector<double>> samples;
  vtkSMPThreadLocal<std::vector<float>> neighbours;
  const bool read = ForAll(count, { this, 0.0, 0.4 },
    [&](vtkIdType first, vtkIdType last)
    {
      std::vector<double>& profile = samples.Local();
      profile.resize(findBase.samples());
      for (vtkIdType i = first; i < last; ++i)
      {
        double place[3];
        const float* normal = surface.normals + 3 * i;
        surface.points->GetPoint(i, place);
        const double below = states[i] == 0 ? findBase(place, normal, profile.data())
                                            : std::numeric_limits<double>::infinity();
        for (int axis = 0; axis < 3; ++axis)
        {
          place[axis] -= below * static_cast<double>(normal[axis]);
        }
        if (std::isfinite(below) && !LeavesBody(surface, i, place, this->EdgeWidth, lists.Local()))
        {
          depth[static_cast<std::size_t>(i)] = static_cast<float>(below);
        }
      }
    });

  // This step combines the depths around each point. Without neighbours, each point keeps its own
  // depth.
  const palpate::BaseNeighbours around(surface, this->SmoothingRadius);
  std::vector<float> medians = depth;
  const bool smoothed = read &&
    (this->SmoothingRadius == 0.0 ||
      ForAll(count, { this, 0.4, 0.7 },
        [&](vtkIdType first, vtkIdType last)
        {
          for (vtkIdType i = first; i < last; ++i)
          {
            medians[static_cast<std::size_t>(i)] =
              around.median(i, depth, lists.Local(), neighbours.Local());
          }
        }));
  vtkNew<vtkFloatArray> thickness;
  thickness->SetName("LayerThickness");
  thickness->SetNumberOfTuples(count);
  vtkNew<vtkFloatArray> error;
  error->SetName("LayerThicknessError");
  error->SetNumberOfTuples(count);
  const double depthError = 0.5 * LargestSpacing(scan);
  const bool done = smoothed &&
    ForAll(count, { this, 0.7, 1.0 },
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          const palpate::InverseDepth found =
            around.mean(i, depth, medians, this->MaximumDepth, depthError, lists.Local());
          thickness->SetValue(i, found.value > 0.0 ? static_cast<float>(1.0 / found.value) : 0.0F);
          error->SetValue(i, static_cast<float>(found.error));
        }
      });
  if (done)
  {
    output->ShallowCopy(body);
    output->GetPointData()->AddArray(thickness);
    output->GetPointData()->AddArray(error);
    sound.giveBack(output);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkLayerThickness::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "BaseValue: " << this->BaseValue << "\n";
  os << indent << "MaximumDepth: " << this->MaximumDepth << " mm\n";
  os << indent << "EdgeWidth: " << this->EdgeWidth << " mm\n";
  os << indent << "SmoothingRadius: " << this->SmoothingRadius << " mm\n";
}

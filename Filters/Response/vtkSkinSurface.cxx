// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkinSurface.h"

#include "vtkArrayDispatch.h"
#include "vtkCallbackCommand.h"
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
#include "vtkPolyDataNormals.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkWindowedSincPolyDataFilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkSkinSurface);

namespace
{
constexpr double PassBand = 0.1;       // of the smoothing; 2 would keep every detail
constexpr double MaximumVoxels = 4e9;  // of the resampled scan: 16 GB
constexpr double ClearOfVoxels = 0.05; // see KeepClearOfVoxels

/** A scan as floats, x running fastest. */
struct Scan
{
  std::array<int, 3> Size;
  std::array<double, 3> Spacing;
  std::vector<float> Values;

  vtkIdType Row(vtkIdType j, vtkIdType k) const { return (k * this->Size[1] + j) * this->Size[0]; }
};

/** Shares of the whole work: reports progress within [From, To] and tells whether to go on. */
struct Stage
{
  vtkAlgorithm* Filter;
  double From;
  double To;

  bool operator()(double done) const
  {
    this->Filter->UpdateProgress(this->From + done * (this->To - this->From));
    return !this->Filter->GetAbortExecute();
  }
};

/** Update an inner filter, its progress forwarded; false when aborted. */
bool Run(vtkAlgorithm* inner, Stage stage)
{
  vtkNew<vtkCallbackCommand> forward;
  forward->SetClientData(&stage);
  forward->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* filter = static_cast<vtkAlgorithm*>(caller);
      if (!(*static_cast<Stage*>(data))(filter->GetProgress()))
      {
        filter->SetAbortExecute(1);
      }
    });
  const unsigned long tag = inner->AddObserver(vtkCommand::ProgressEvent, forward);
  inner->Update();
  inner->RemoveObserver(tag);
  return stage(1.0);
}

/** Copies any array to floats; what is not finite becomes the lowest value. Range: of the rest. */
struct ToFloats
{
  std::vector<float>& Values;
  std::array<float, 2> Range = { std::numeric_limits<float>::max(),
    std::numeric_limits<float>::lowest() };

  template <typename ArrayT>
  void operator()(ArrayT* array)
  {
    const auto values = vtk::DataArrayValueRange<1>(array);
    this->Values.assign(values.begin(), values.end());
    for (const float value : this->Values)
    {
      if (std::isfinite(value))
      {
        this->Range = { std::min(this->Range[0], value), std::max(this->Range[1], value) };
      }
    }
    for (float& value : this->Values)
    {
      value = std::isfinite(value) ? value : this->Range[0];
    }
  }
};

/**
 * A ball as a bundle of runs of voxels along x: Runs[w] holds the places (j, k) of the runs
 * reaching from -w to w.
 */
struct Ball
{
  std::vector<std::vector<std::pair<int, int>>> Runs;

  Ball(double radius, const Scan& scan)
  {
    auto voxels = [&](double length, int axis) {
      return static_cast<int>(std::min(length / scan.Spacing[axis] + 1e-9, 1.0 * scan.Size[axis]));
    };
    this->Runs.resize(voxels(radius, 0) + 1);
    const int J = voxels(radius, 1);
    const int K = voxels(radius, 2);
    for (int k = -K; k <= K; ++k)
    {
      for (int j = -J; j <= J; ++j)
      {
        const double y = j * scan.Spacing[1];
        const double z = k * scan.Spacing[2];
        const double rest = radius * radius - y * y - z * z;
        if (rest >= 0.0)
        {
          this->Runs[voxels(std::sqrt(rest), 0)].emplace_back(j, k);
        }
      }
    }
  }
};

/**
 * Each voxel becomes the extremum over the ball around it, as far as that lies in the scan: a flat
 * grey-level dilation (pick = max) or erosion (pick = min). Runs of one length share their extrema.
 */
template <typename Pick>
bool SpreadOverBall(Scan& scan, const Ball& ball, Pick pick, Stage stage)
{
  const int X = scan.Size[0];
  const int Y = scan.Size[1];
  const int Z = scan.Size[2];
  std::vector<float> extrema = scan.Values; // along x, over the current run
  for (std::size_t w = 0; w < ball.Runs.size(); ++w)
  {
    if (w > 0)
    {
      vtkSMPTools::For(0, static_cast<vtkIdType>(Y) * Z,
        [&extrema, X, pick](vtkIdType begin, vtkIdType end)
        {
          std::vector<float> shorter(X);
          for (vtkIdType row = begin; row < end; ++row)
          {
            float* longer = extrema.data() + row * X;
            std::copy(longer, longer + X, shorter.begin());
            for (int i = 1; i < X; ++i)
            {
              longer[i] = pick(longer[i], shorter[i - 1]);
            }
            for (int i = 0; i + 1 < X; ++i)
            {
              longer[i] = pick(longer[i], shorter[i + 1]);
            }
          }
        });
    }
    const auto& runs = ball.Runs[w];
    vtkSMPTools::For(0, Z,
      [&scan, &extrema, &runs, X, Y, Z, pick](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType k = begin; k < end; ++k)
        {
          for (vtkIdType j = 0; j < Y; ++j)
          {
            float* target = scan.Values.data() + scan.Row(j, k);
            for (const auto& run : runs)
            {
              const vtkIdType jj = j + run.first;
              const vtkIdType kk = k + run.second;
              if (jj >= 0 && jj < Y && kk >= 0 && kk < Z)
              {
                const float* source = extrema.data() + scan.Row(jj, kk);
                for (int i = 0; i < X; ++i)
                {
                  target[i] = pick(target[i], source[i]);
                }
              }
            }
          }
        }
      });
    if (!stage((w + 1.0) / ball.Runs.size()))
    {
      return false;
    }
  }
  return true;
}

/** Grey-level closing: dilation, then erosion. */
bool CloseOpenings(Scan& scan, double radius, Stage stage)
{
  if (radius == 0.0)
  {
    return stage(1.0);
  }
  const Ball ball(radius, scan);
  const double middle = 0.5 * (stage.From + stage.To);
  return SpreadOverBall(scan, ball, [](float a, float b) { return a < b ? b : a; },
           { stage.Filter, stage.From, middle }) &&
    SpreadOverBall(scan, ball, [](float a, float b) { return b < a ? b : a; },
      { stage.Filter, middle, stage.To });
}

/** The voxels below `contour` that are connected to `seed` through faces; taken out of `below`. */
std::vector<vtkIdType> TakeRegion(vtkIdType seed, std::vector<char>& below, const Scan& scan)
{
  const vtkIdType X = scan.Size[0];
  const vtkIdType Y = scan.Size[1];
  const vtkIdType Z = scan.Size[2];
  std::vector<vtkIdType> region;
  auto take = [&below, &region](vtkIdType voxel, bool inside)
  {
    if (inside && below[voxel])
    {
      below[voxel] = 0;
      region.push_back(voxel);
    }
  };
  take(seed, true);
  for (std::size_t next = 0; next < region.size(); ++next)
  {
    const vtkIdType voxel = region[next];
    const vtkIdType i = voxel % X;
    const vtkIdType j = voxel / X % Y;
    const vtkIdType k = voxel / (X * Y);
    take(voxel - 1, i > 0);
    take(voxel + 1, i + 1 < X);
    take(voxel - X, j > 0);
    take(voxel + X, j + 1 < Y);
    take(voxel - X * Y, k > 0);
    take(voxel + X * Y, k + 1 < Z);
  }
  return region;
}

/**
 * Raises every voxel below `contour` to `tissue`, but for the air: the largest connected region
 * that reaches the border of the scan. False when there is none.
 */
bool FillCavities(Scan& scan, float contour, float tissue)
{
  std::vector<char> below(scan.Values.size());
  std::transform(scan.Values.begin(), scan.Values.end(), below.begin(),
    [contour](float value) { return value < contour; });
  std::vector<vtkIdType> air;
  for (int k = 0; k < scan.Size[2]; ++k)
  {
    for (int j = 0; j < scan.Size[1]; ++j)
    {
      const bool face = j == 0 || j + 1 == scan.Size[1] || k == 0 || k + 1 == scan.Size[2];
      for (int i = 0; i < scan.Size[0]; i += face ? 1 : scan.Size[0] - 1)
      {
        std::vector<vtkIdType> region = TakeRegion(scan.Row(j, k) + i, below, scan);
        if (region.size() > air.size())
        {
          air.swap(region);
        }
      }
    }
  }
  std::fill(below.begin(), below.end(), 0);
  for (const vtkIdType voxel : air)
  {
    below[voxel] = 1;
  }
  for (std::size_t voxel = 0; voxel < below.size(); ++voxel)
  {
    if (!below[voxel] && scan.Values[voxel] < contour)
    {
      scan.Values[voxel] = tissue;
    }
  }
  return !air.empty();
}

/** The scan as an image whose coordinates are index times spacing. */
vtkSmartPointer<vtkImageData> AsImage(Scan& scan)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(scan.Size.data());
  image->SetSpacing(scan.Spacing.data());
  vtkNew<vtkFloatArray> values;
  values->SetName("Grey");
  values->SetArray(scan.Values.data(), static_cast<vtkIdType>(scan.Values.size()), 1);
  image->GetPointData()->SetScalars(values);
  return image;
}

/** Lattice of about `resolution` over the same box; 0 = as it is. */
std::array<int, 3> ResampledSize(const Scan& scan, double resolution)
{
  std::array<int, 3> size = scan.Size;
  for (int axis = 0; axis < 3 && resolution > 0.0; ++axis)
  {
    const double length = (scan.Size[axis] - 1) * scan.Spacing[axis];
    size[axis] = static_cast<int>(std::clamp(length / resolution, 1.0, 1e6) + 0.5) + 1;
  }
  return size;
}

/**
 * Voxels at the very contour value give triangles without area: move grey levels closer than a
 * small fraction of the step air-tissue away from it.
 */
void KeepClearOfVoxels(vtkImageData* image, float contour, float tissue)
{
  const float margin = static_cast<float>(ClearOfVoxels) * (tissue - contour);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  vtkSMPTools::For(0, image->GetNumberOfPoints(),
    [values, contour, margin](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        if (std::abs(values[i] - contour) < margin)
        {
          values[i] = values[i] < contour ? contour - margin : contour + margin;
        }
      }
    });
}

/** The largest region of the contour, smoothed; null when aborted. */
vtkSmartPointer<vtkPolyData> Contour(
  vtkImageData* image, double contour, int iterations, vtkAlgorithm* self)
{
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(image);
  edges->SetValue(0, contour);
  edges->ComputeNormalsOff();
  edges->ComputeScalarsOff();
  vtkNew<vtkPolyDataConnectivityFilter> largest;
  largest->SetInputConnection(edges->GetOutputPort());
  largest->SetExtractionModeToLargestRegion();
  vtkNew<vtkCleanPolyData> used; // drops the points of the other regions
  used->SetInputConnection(largest->GetOutputPort());
  used->PointMergingOff();
  vtkNew<vtkWindowedSincPolyDataFilter> smooth;
  smooth->SetInputConnection(used->GetOutputPort());
  smooth->SetNumberOfIterations(iterations);
  smooth->SetPassBand(PassBand);
  smooth->NormalizeCoordinatesOn();
  smooth->BoundarySmoothingOff();
  smooth->FeatureEdgeSmoothingOff();
  vtkAlgorithm* last = iterations > 0 ? static_cast<vtkAlgorithm*>(smooth) : used;
  const bool done = Run(edges, { self, 0.35, 0.45 }) && Run(largest, { self, 0.45, 0.6 }) &&
    Run(used, { self, 0.6, 0.7 }) && Run(last, { self, 0.7, 0.9 });
  return done ? vtkPolyData::SafeDownCast(last->GetOutputDataObject(0)) : nullptr;
}

/** From index times spacing to the physical coordinates of `image`. */
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

/** Whether the voxel axes of `image` form a left-handed system. */
bool IsLeftHanded(vtkImageData* image)
{
  const double* spacing = image->GetSpacing();
  return image->GetDirectionMatrix()->Determinant() * spacing[0] * spacing[1] * spacing[2] < 0.0;
}

/** Outward point normals; a left-handed image has turned the triangles inside out. */
vtkSmartPointer<vtkPolyData> WithNormals(vtkPolyData* skin, bool leftHanded, vtkAlgorithm* self)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(skin);
  normals->SplittingOff();
  normals->ConsistencyOff(); // flying edges are consistent
  normals->SetFlipNormals(leftHanded);
  return Run(normals, { self, 0.9, 1.0 }) ? normals->GetOutput() : nullptr;
}

/** What is wrong with the input or the properties; empty when nothing is. */
std::string Problem(vtkImageData* image, vtkDataArray* scalars, double closing, double resolution)
{
  std::ostringstream text;
  const int* size = image->GetDimensions();
  if (!scalars)
  {
    text << "the scan has no point scalars to contour";
  }
  else if (scalars->GetNumberOfComponents() != 1)
  {
    text << "the scalars \"" << (scalars->GetName() ? scalars->GetName() : "") << "\" have "
         << scalars->GetNumberOfComponents() << " components, one is needed";
  }
  else if (scalars->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    text << "the scalars have " << scalars->GetNumberOfTuples() << " values for "
         << image->GetNumberOfPoints() << " voxels";
  }
  else if (std::min({ size[0], size[1], size[2] }) < 2)
  {
    text << "the scan must have three dimensions, it has " << size[0] << " x " << size[1] << " x "
         << size[2] << " voxels";
  }
  else if (!(image->GetSpacing()[0] * image->GetSpacing()[1] * image->GetSpacing()[2] != 0.0))
  {
    text << "the spacing of the scan must not be zero";
  }
  else if (!(closing >= 0.0) || !std::isfinite(closing))
  {
    text << "ClosingRadius must not be negative, it is " << closing << " mm";
  }
  else if (!(resolution >= 0.0) || !std::isfinite(resolution))
  {
    text << "Resolution must not be negative, it is " << resolution << " mm";
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
    return 1; // one piece holds it all
  }
  vtkDataArray* scalars = this->GetInputArrayToProcess(0, input);
  const std::string problem = Problem(image, scalars, this->ClosingRadius, this->Resolution);
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem << ".");
    return 0;
  }

  // Take the scan, in floats.
  Scan scan;
  image->GetDimensions(scan.Size.data());
  std::transform(image->GetSpacing(), image->GetSpacing() + 3, scan.Spacing.begin(),
    [](double spacing) { return std::abs(spacing); });
  ToFloats copy{ scan.Values };
  if (!vtkArrayDispatch::Dispatch::Execute(scalars, copy))
  {
    copy(scalars);
  }
  const float contour = static_cast<float>(this->ContourValue);
  if (!(copy.Range[0] < contour && contour < copy.Range[1]))
  {
    vtkErrorMacro("nothing to contour: ContourValue "
      << this->ContourValue << " is not inside the scalars' range, " << copy.Range[0] << " to "
      << copy.Range[1] << ".");
    return 0;
  }
  const float tissue = 2.0f * contour - copy.Range[0]; // as far above the contour as air is below

  // Shut the openings, fill what they led to.
  if (!CloseOpenings(scan, this->ClosingRadius, { this, 0.05, 0.2 }))
  {
    return 1;
  }
  if (!FillCavities(scan, contour, tissue))
  {
    vtkErrorMacro("nothing to contour: after closing by "
      << this->ClosingRadius << " mm no air, below ContourValue " << this->ContourValue
      << ", is left at the border of the scan.");
    return 0;
  }

  // Contour at the wanted resolution.
  std::array<int, 3> size = ResampledSize(scan, this->Resolution);
  if (1.0 * size[0] * size[1] * size[2] > MaximumVoxels)
  {
    vtkErrorMacro("Resolution " << this->Resolution << " mm is too fine: it makes " << size[0]
                                << " x " << size[1] << " x " << size[2] << " voxels.");
    return 0;
  }
  vtkSmartPointer<vtkImageData> lattice = AsImage(scan);
  if (size != scan.Size)
  {
    vtkNew<vtkImageResize> resize;
    resize->SetInputData(lattice);
    resize->SetOutputDimensions(size.data());
    if (!Run(resize, { this, 0.25, 0.35 }))
    {
      return 1;
    }
    lattice = resize->GetOutput();
  }
  KeepClearOfVoxels(lattice, contour, tissue);
  vtkSmartPointer<vtkPolyData> surface =
    Contour(lattice, contour, this->NumberOfSmoothingIterations, this);
  if (surface && surface->GetNumberOfCells() == 0)
  {
    vtkErrorMacro("nothing to contour at ContourValue " << this->ContourValue << ".");
    return 0;
  }

  // Put it where the scan is, and orient it.
  if (surface)
  {
    PlaceAs(image, surface->GetPoints());
    surface = WithNormals(surface, IsLeftHanded(image), this);
  }
  if (surface)
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
  os << indent << "ClosingRadius: " << this->ClosingRadius << " mm\n";
  os << indent << "Resolution: " << this->Resolution << " mm\n";
  os << indent << "NumberOfSmoothingIterations: " << this->NumberOfSmoothingIterations << "\n";
}

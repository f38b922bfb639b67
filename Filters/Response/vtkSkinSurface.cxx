// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkinSurface.h"

#include "Response/Bodies/SkinContour.h"
#include "Response/Bodies/SkinLevel.h"
#include "Response/Bodies/SkinScan.h"
#include "Response/FilterStage.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArrayRange.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

vtkStandardNewMacro(vtkSkinSurface);

namespace
{
using Stage = palpate::FilterStage;

// Largest number of voxels of the resampled scan, which take 16 GB.
constexpr double MaximumVoxels = 4e9;

/**
 * Returns the scan with its scalars as floats. NaN and infinite values are replaced by `lowest`.
 */
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
  // The outer skin can be found only from the whole scan.
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
    return 1; // only the first piece of the output contains the skin, as a whole
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

  // This step closes the openings, and fills the cavities behind them.
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

  const palpate::SkinContour wanted{ contour, tissue, this->Resolution,
    this->NumberOfSmoothingIterations };
  const vtkSmartPointer<vtkPolyData> surface =
    palpate::contourSkin(scan, wanted, image, { this, 0.2, 1.0 });
  if (surface && surface->GetNumberOfCells() == 0)
  {
    vtkErrorMacro("nothing to contour at Contour Value " << this->UsedContourValue << ".");
    return 0;
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
  os << indent << "UsedContourValue: " << this->UsedContourValue << "\n";
  os << indent << "ClosingRadius: " << this->ClosingRadius << " mm\n";
  os << indent << "Resolution: " << this->Resolution << " mm\n";
  os << indent << "NumberOfSmoothingIterations: " << this->NumberOfSmoothingIterations << "\n";
}

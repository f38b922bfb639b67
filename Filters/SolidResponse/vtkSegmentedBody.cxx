// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSegmentedBody.h"

#include "Mechanics/Checked.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/ReducedModulus.h"
#include "Response/Bodies/SkinContour.h"
#include "Response/FilterStage.h"
#include "SolidResponse/Bodies/ChosenSpacing.h"
#include "SolidResponse/Bodies/FactorisedBody.h"
#include "SolidResponse/Bodies/SegmentedVoxels.h"
#include "SolidResponse/Bodies/SourceSpacing.h"
#include "SolidResponse/Bodies/TissueCells.h"
#include "SolidResponse/Mesher/GradedFilling.h"
#include "SolidResponse/Mesher/SurfaceMesher.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
// Fractions of the progress at the end of the steps.
constexpr double TakenShare = 0.05;
constexpr double ContouredShare = 0.1;
constexpr double FilledShare = 0.95;

/// Desired number of cells at the surface. It is also the largest number of cells that all enclosed
/// regions together may add.
constexpr double UsualCells = 10000.0;
/// Side length of the largest cavities that are filled, in spacings.
constexpr double LeastCavity = 2.0;
/// The lattice of the contour may be coarser than the voxels, but not coarser than this fraction of
/// the spacing.
constexpr double LatticeOfSpacing = 0.25;
/// Length of the cells in an enclosed region, as a fraction of the depth or of the radius of the
/// region.
constexpr double CellsOfRegion = 0.5;
/// Largest number of surface points for which a response should solve the body.
constexpr double UsualSources = 2500.0;
constexpr double CoarseningStep = 1.1;
constexpr std::size_t MostFineRegions = 64;
} // namespace

vtkStandardNewMacro(vtkSegmentedBody);

vtkSegmentedBody::vtkSegmentedBody()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

bool vtkSegmentedBody::IsAvailable()
{
  return palpate::hasSurfaceMesher();
}

void vtkSegmentedBody::AddTissue(double label, double youngsModulus, double poissonRatio)
{
  this->Tissues.push_back({ label, youngsModulus, poissonRatio });
  this->Modified();
}

void vtkSegmentedBody::ClearTissues()
{
  if (!this->Tissues.empty())
  {
    this->Tissues.clear();
    this->Modified();
  }
}

int vtkSegmentedBody::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkSegmentedBody::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector*)
{
  // The whole image is requested, because the body depends on all of it.
  vtkInformation* info = input[0]->GetInformationObject(0);
  std::array<int, 6> whole{};
  info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole.data());
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), whole.data(), 6);
  return 1;
}

int vtkSegmentedBody::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->UsedSpacing = 0.0;
  this->NumberOfFineRegions = 0;
  vtkImageData* image = vtkImageData::GetData(inputVector[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const int piece = outputVector->GetInformationObject(0)->Get(Pipeline::UPDATE_PIECE_NUMBER());
  if (!image || image->GetNumberOfPoints() == 0 || piece > 0)
  {
    return 1; // only the first piece contains the body, as a whole
  }
  const std::string fault = palpate::firstFault([this] { return this->CheckTissues(); },
    [&] { return this->Make(image, this->GetInputArrayToProcess(0, inputVector), output); });
  if (!fault.empty() || palpate::isAborted(this))
  {
    output->Initialize();
  }
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    return 0;
  }
  return 1;
}

std::string vtkSegmentedBody::CheckTissues() const
{
  if (!palpate::hasSurfaceMesher())
  {
    return std::string("No tissue can be filled: ") + palpate::missingMesher();
  }
  if (!(this->SurfaceSpacing >= 0.0 && std::isfinite(this->SurfaceSpacing)))
  {
    return palpate::joined(
      "Surface Spacing must be 0 or positive and finite (mm), but is ", this->SurfaceSpacing);
  }
  if (this->Tissues.empty())
  {
    return "Tissues are required, a row for each label of the body (AddTissue)";
  }
  for (std::size_t i = 0; i < this->Tissues.size(); ++i)
  {
    const Row& row = this->Tissues[i];
    const auto wrong = [&row](const char* what, double value)
    { return palpate::joined("Tissue of label ", row.Label, ": ", what, ", but is ", value); };
    if (!std::isfinite(row.Label))
    {
      return palpate::joined("Tissue ", i, ": its label must be finite, but is ", row.Label);
    }
    if (!palpate::isYoungsModulus(row.YoungsModulus))
    {
      return wrong("its Young's modulus must be positive and finite (MPa)", row.YoungsModulus);
    }
    if (!palpate::isElementRatio(row.PoissonRatio))
    {
      return wrong("its Poisson's ratio must lie between 0 and 0.499", row.PoissonRatio);
    }
    const auto same = [&row](const Row& other) { return other.Label == row.Label; };
    if (std::any_of(this->Tissues.begin(), this->Tissues.begin() + static_cast<long>(i), same))
    {
      return palpate::joined("Label ", row.Label, " has two tissues");
    }
  }
  return {};
}

std::string vtkSegmentedBody::Make(
  vtkImageData* image, vtkDataArray* values, vtkUnstructuredGrid* output)
{
  if (!values || values->GetNumberOfComponents() != 1 ||
    values->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    return "Wrong input: the image has no labels, point scalars of one component";
  }
  std::array<double, 3> side{};
  image->GetSpacing(side.data());
  if (image->GetDataDimension() != 3 || side[0] * side[1] * side[2] == 0.0)
  {
    const int* size = image->GetDimensions();
    return palpate::joined("Wrong input: the image must extend in three dimensions, but has ",
      size[0], " x ", size[1], " x ", size[2], " voxels");
  }
  std::vector<palpate::Tissue> tissues;
  for (const Row& row : this->Tissues)
  {
    tissues.push_back({ row.Label, { row.YoungsModulus, row.PoissonRatio } });
  }
  palpate::SegmentedVoxels voxels;
  std::string fault = voxels.take(image, values, tissues);
  if (!fault.empty())
  {
    return "Wrong input: " + fault;
  }
  const double lost = voxels.keepLargestRegion();
  if (lost > 0.0)
  {
    vtkWarningMacro(<< "The tissues are not connected: " << 100.0 * lost
                    << " % of their voxels, outside the largest region, are left out.");
  }
  palpate::GradedCells cells;
  this->ChooseCells(voxels, cells);
  voxels.fillCavities(std::pow(LeastCavity * cells.spacing, 3));
  if (!palpate::FilterStage{ this, 0.0, TakenShare }(1.0))
  {
    return {};
  }
  const vtkSmartPointer<vtkImageData> numbers = voxels.spreadTissues();
  palpate::SkinScan mask = voxels.mask();
  palpate::SkinContour wanted{ 0.5F, 1.0F };
  const double lattice = LatticeOfSpacing * cells.spacing;
  wanted.resolution = lattice > voxels.smallestSide() ? lattice : 0.0;
  wanted.isLargest = false;
  const vtkSmartPointer<vtkPolyData> surface =
    palpate::contourSkin(mask, wanted, numbers, { this, TakenShare, ContouredShare });
  if (!surface)
  {
    return {};
  }
  vtkNew<vtkUnstructuredGrid> filled;
  palpate::GradedReport report;
  fault = palpate::fillGraded(
    surface, cells, palpate::FilterStage{ this, ContouredShare, FilledShare }, filled, report);
  if (!fault.empty())
  {
    return "The surface of the tissues cannot be filled: " + fault;
  }
  for (const std::string& warning : report.warnings)
  {
    vtkWarningMacro(<< "Surface of the tissues: " << warning);
  }
  if (filled->GetNumberOfCells() == 0)
  {
    return {};
  }
  palpate::TissueScan scan{ numbers, numbers->GetPointData()->GetScalars(), {}, true,
    tissues.front().material };
  for (std::size_t i = 0; i < tissues.size(); ++i)
  {
    scan.map[static_cast<double>(i)] = tissues[i].material;
  }
  fault = palpate::mapTissues(filled, scan, palpate::FilterStage{ this, FilledShare, 1.0 }, output);
  if (fault.empty() && !palpate::isAborted(this))
  {
    double sources = cells.spacing;
    for (const palpate::FineBall& ball : cells.balls)
    {
      sources = std::min(sources, ball.spacing);
    }
    vtkNew<vtkDoubleArray> spacing;
    spacing->SetName(palpate::SourceSpacingName);
    spacing->InsertNextValue(std::max(sources, std::sqrt(voxels.area() / UsualSources)));
    output->GetFieldData()->AddArray(spacing);
    this->UpdateProgress(1.0);
  }
  return fault;
}

/// Chooses the length of the cells at the surface and in enclosed regions.
void vtkSegmentedBody::ChooseCells(
  const palpate::SegmentedVoxels& voxels, palpate::GradedCells& cells)
{
  cells.fixedFaces = this->FixedFaces;
  cells.spacing = this->SurfaceSpacing > 0.0
    ? this->SurfaceSpacing
    : palpate::chosenSpacing(voxels.area(), voxels.volume(), UsualCells);
  this->UsedSpacing = cells.spacing;
  std::vector<palpate::EnclosedRegion> regions = voxels.findEnclosedRegions();
  regions.resize(std::min(regions.size(), MostFineRegions));
  double factor = CellsOfRegion;
  double expected = 0.0;
  do
  {
    cells.balls.clear();
    expected = 0.0;
    for (const palpate::EnclosedRegion& region : regions)
    {
      const double length = std::min(region.depth, region.radius);
      const palpate::FineBall ball{ region.middle, region.radius + region.depth, factor * length };
      if (ball.spacing < cells.spacing)
      {
        cells.balls.push_back(ball);
        expected += palpate::expectedBallCells(ball, cells.spacing, cells.growth);
      }
    }
    factor *= CoarseningStep;
  } while (expected > UsualCells);
  this->NumberOfFineRegions = static_cast<int>(cells.balls.size());
}

void vtkSegmentedBody::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tissues: " << this->Tissues.size() << "\n";
  os << indent << "SurfaceSpacing: " << this->SurfaceSpacing << " mm\n";
  os << indent << "FixedFaces: " << this->FixedFaces << "\n";
  os << indent << "UsedSpacing: " << this->UsedSpacing << " mm\n";
  os << indent << "NumberOfFineRegions: " << this->NumberOfFineRegions << "\n";
}

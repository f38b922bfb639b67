// SPDX-License-Identifier: BSD-3-Clause
#include "vtkElasticCompliance.h"

#include "Mechanics/Checked.h"
#include "Response/BodyConversion.h"
#include "Response/BodyField.h"
#include "Solids/FiniteElements/CouplingModes.h"
#include "Mechanics/JoinedText.h"
#include "Response/FilterStage.h"
#include "Response/FilterThreads.h"
#include "Solids/FiniteElements/GlobalModes.h"
#include "Solids/FiniteElements/PatchCompliance.h"
#include "Solids/TrueShape/ComplianceError.h"
#include "SolidResponse/Bodies/FactorisedBody.h"
#include "SolidResponse/Bodies/VolumeConversion.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace
{
void attachCompliances(
  const palpate::PatchCompliances& compliances, vtkPolyData* output, vtkIdType count)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName("GlobalCompliance");
  values->SetNumberOfTuples(count);
  vtkNew<vtkUnsignedCharArray> status;
  status->SetName("ComplianceStatus");
  status->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    values->SetValue(i, compliances.compliance[static_cast<std::size_t>(i)]);
    status->SetValue(
      i, static_cast<unsigned char>(compliances.status[static_cast<std::size_t>(i)]));
  }
  output->GetPointData()->AddArray(values);
  output->GetPointData()->AddArray(status);
}

/// Attaches the errors. The error of an interpolated compliance is set to at least the absolute
/// value of the compliance.
void attachErrors(const palpate::PatchCompliances& compliances, const std::vector<double>& errors,
  vtkPolyData* output)
{
  if (errors.empty() || std::isnan(errors.front()))
  {
    return;
  }
  vtkNew<vtkDoubleArray> values;
  values->SetName("GlobalComplianceError");
  for (std::size_t i = 0; i < errors.size(); ++i)
  {
    const double guessed = compliances.status[i] == palpate::PatchStatus::Valid
      ? 0.0
      : std::abs(compliances.compliance[i]);
    values->InsertNextValue(std::max(errors[i], guessed));
  }
  output->GetPointData()->AddArray(values);
}

void attachModes(const palpate::GlobalModes& modes, vtkPolyData* output)
{
  vtkNew<vtkIntArray> signs;
  signs->SetName(palpate::GlobalModeSignArray);
  for (std::size_t k = 0; k < modes.fields.size(); ++k)
  {
    const Eigen::Matrix3Xd& field = modes.fields[k];
    vtkNew<vtkFloatArray> vectors;
    vectors->SetName(palpate::globalModeName(k).c_str());
    vectors->SetNumberOfComponents(3);
    vectors->SetNumberOfTuples(field.cols());
    for (vtkIdType i = 0; i < field.cols(); ++i)
    {
      vectors->SetTuple(i, field.col(i).data());
    }
    output->GetPointData()->AddArray(vectors);
    signs->InsertNextValue(modes.signs[k]);
  }
  output->GetFieldData()->AddArray(signs);
}

void attachCouplingModes(const Eigen::MatrixXd& modes, vtkPolyData* output)
{
  vtkNew<vtkFloatArray> values;
  values->SetName(palpate::CouplingModesName);
  values->SetNumberOfComponents(static_cast<int>(modes.rows()));
  values->SetNumberOfTuples(modes.cols());
  for (vtkIdType i = 0; i < modes.cols(); ++i)
  {
    const Eigen::VectorXd each = modes.col(i);
    values->SetTuple(i, each.data());
  }
  output->GetPointData()->AddArray(values);
}

void attachDisplacement(const palpate::ElasticBody& body, std::int32_t point, double radius,
  double force, vtkPolyData* output)
{
  const Eigen::Matrix3Xd moved =
    body.displacement(force * palpate::patchForces(body, point, radius));
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("LoadedDisplacement");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(body.surface().pointTotal());
  for (std::int32_t i = 0; i < body.surface().pointTotal(); ++i)
  {
    vectors->SetTuple(i, moved.col(body.surface().node(i)).data());
  }
  output->GetPointData()->AddArray(vectors);
}
} // namespace

vtkStandardNewMacro(vtkElasticCompliance);

int vtkElasticCompliance::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

int vtkElasticCompliance::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* grid = vtkUnstructuredGrid::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->MemoryEstimate = 0.0;
  this->NeglectedByModes = 0.0;
  this->NeglectedByCouplingModes = 0.0;
  if (!grid || grid->GetNumberOfCells() == 0)
  {
    return 1;
  }
  palpate::FactorRequest request;
  request.material = { this->YoungsModulus, this->PoissonRatio };
  request.solver = this->Solver;
  request.memoryLimit = this->MemoryLimit;
  const auto find = [this, grid](int index) { return this->GetInputArrayToProcess(index, grid); };
  std::string fault = palpate::firstFault([&] { return this->CheckProperties(request); },
    [&] { return palpate::findCellArray(this, grid, 0, find, request.young); },
    [&] { return palpate::findCellArray(this, grid, 1, find, request.poisson); });
  const palpate::FilterThreads threads;
  palpate::ElasticBody body;
  bool isEnded = false;
  if (fault.empty())
  {
    fault = palpate::factoriseBody(
      grid, request, palpate::FilterStage{ this, 0.0, 0.4 }, body, this->MemoryEstimate, isEnded);
  }
  if (fault.empty() && !isEnded && this->LoadedPoint >= body.surface().pointTotal())
  {
    fault = palpate::joined("Loaded Point must be -1 or the index of a surface point (0 to ",
      body.surface().pointTotal() - 1, "), but is ", this->LoadedPoint);
  }
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    return 0;
  }
  if (isEnded)
  {
    return 1;
  }

  const palpate::BodySurface& surface = body.surface();
  std::vector<std::int32_t> points(static_cast<std::size_t>(surface.pointTotal()));
  std::iota(points.begin(), points.end(), 0);
  palpate::PatchCompliances compliances = palpate::patchCompliances(
    body, points, this->PatchRadius, palpate::FilterStage{ this, 0.4, 0.7 });
  if (compliances.compliance.empty())
  {
    return 1; // aborted
  }
  const std::vector<double> errors =
    palpate::complianceErrors(body, compliances, palpate::FilterStage{ this, 0.7, 0.8 });
  if (errors.empty())
  {
    return 1; // aborted
  }
  palpate::GlobalModes modes;
  if (this->NumberOfModes > 0)
  {
    modes = palpate::globalModes(body, compliances, this->PatchRadius, this->NumberOfModes,
      palpate::FilterStage{ this, 0.8, this->NumberOfCouplingModes > 0 ? 0.9 : 0.99 });
    if (modes.fields.empty())
    {
      return 1; // aborted
    }
    this->NeglectedByModes = modes.neglected;
  }
  palpate::CouplingModes coupling;
  if (this->NumberOfCouplingModes > 0)
  {
    coupling = palpate::couplingModes(body, compliances, this->PatchRadius,
      this->NumberOfCouplingModes, palpate::FilterStage{ this, 0.9, 0.99 });
    if (coupling.values.rows() == 0)
    {
      return 1; // aborted
    }
    this->NeglectedByCouplingModes = coupling.neglected;
  }
  palpate::spreadValidCompliances(surface, compliances);
  std::size_t without = 0;
  for (const double compliance : compliances.compliance)
  {
    without += std::isnan(compliance) ? 1 : 0;
  }
  if (without > 0)
  {
    vtkWarningMacro(
      << without << " of " << points.size()
      << " points have no compliance: no patch is valid on their part of the surface, "
         "see array 'ComplianceStatus'.");
  }

  palpate::convertSurface(surface, grid, output);
  attachCompliances(compliances, output, surface.pointTotal());
  attachErrors(compliances, errors, output);
  if (this->NumberOfModes > 0)
  {
    attachModes(modes, output);
  }
  if (this->NumberOfCouplingModes > 0)
  {
    attachCouplingModes(coupling.values, output);
  }
  if (this->LoadedPoint >= 0)
  {
    attachDisplacement(body, static_cast<std::int32_t>(this->LoadedPoint), this->PatchRadius,
      this->LoadForce, output);
  }
  this->UpdateProgress(1.0);
  return 1;
}

std::string vtkElasticCompliance::CheckProperties(const palpate::FactorRequest& request)
{
  std::string fault = palpate::checkFactorRequest(request);
  if (!fault.empty())
  {
    return fault;
  }
  if (!(this->PatchRadius >= 0.0 && std::isfinite(this->PatchRadius)))
  {
    return palpate::joined("Patch Radius must be 0 or positive (mm), but is ", this->PatchRadius);
  }
  if (this->NumberOfModes < 0 || this->NumberOfModes > palpate::MostGlobalModes)
  {
    return palpate::joined("Number Of Modes must lie between 0 and ", palpate::MostGlobalModes,
      ", but is ", this->NumberOfModes);
  }
  if (this->NumberOfCouplingModes < 0 || this->NumberOfCouplingModes > palpate::MostCouplingModes)
  {
    return palpate::joined("Number Of Coupling Modes must lie between 0 and ",
      palpate::MostCouplingModes, ", but is ", this->NumberOfCouplingModes);
  }
  if (this->LoadedPoint < -1 || !std::isfinite(this->LoadForce))
  {
    return palpate::joined(
      "Loaded Point must be -1 or the index of a surface point, and Load Force "
      "must be finite, but they are ",
      this->LoadedPoint, " and ", this->LoadForce, " N");
  }
  return {};
}

void vtkElasticCompliance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "YoungsModulus: " << this->YoungsModulus << " MPa\n";
  os << indent << "PoissonRatio: " << this->PoissonRatio << "\n";
  os << indent << "PatchRadius: " << this->PatchRadius << " mm\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << " MiB\n";
  os << indent << "MemoryEstimate: " << this->MemoryEstimate << " MiB\n";
  os << indent << "Solver: " << this->Solver << "\n";
  os << indent << "NumberOfModes: " << this->NumberOfModes << "\n";
  os << indent << "NeglectedByModes: " << this->NeglectedByModes << "\n";
  os << indent << "NumberOfCouplingModes: " << this->NumberOfCouplingModes << "\n";
  os << indent << "NeglectedByCouplingModes: " << this->NeglectedByCouplingModes << "\n";
  os << indent << "LoadedPoint: " << this->LoadedPoint << "\n";
  os << indent << "LoadForce: " << this->LoadForce << " N\n";
}

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkElasticCompliance.h"

#include "Mechanics/Numerics/AvailableMemory.h"
#include "Response/FilterStage.h"
#include "Response/FilterThreads.h"
#include "Mechanics/FiniteElements/GlobalModes.h"
#include "Mechanics/FiniteElements/PatchCompliance.h"
#include "Mechanics/ReducedModulus.h"
#include "Response/Bodies/VolumeConversion.h"

#include "vtkCellData.h"
#include "vtkDataObject.h"
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

#include <cmath>
#include <numeric>
#include <utility>

namespace
{
using palpate::Mebibyte;

/// Of the memory that is available: what the factorisation may take, so that the solutions have
/// room, and others.
constexpr double MemoryShare = 0.9;

palpate::StiffnessFactor::Kind kindOf(int solver)
{
  return solver == vtkElasticCompliance::Supernodal ? palpate::StiffnessFactor::Kind::Supernodal
    : solver == vtkElasticCompliance::Simplicial    ? palpate::StiffnessFactor::Kind::Simplicial
                                                    : palpate::StiffnessFactor::Kind::Automatic;
}

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

void attachModes(const palpate::GlobalModes& modes, vtkPolyData* output)
{
  vtkNew<vtkIntArray> signs;
  signs->SetName("GlobalModeSign");
  for (std::size_t k = 0; k < modes.fields.size(); ++k)
  {
    const Eigen::Matrix3Xd& field = modes.fields[k];
    vtkNew<vtkFloatArray> vectors;
    vectors->SetName(("GlobalMode" + std::to_string(k)).c_str());
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
  if (!grid || grid->GetNumberOfCells() == 0)
  {
    return 1;
  }
  vtkDataArray* young = nullptr;
  vtkDataArray* poisson = nullptr;
  if (!this->CheckProperties() || !this->FetchCellArray(grid, 0, young) ||
    !this->FetchCellArray(grid, 1, poisson))
  {
    return 0;
  }
  const auto failed = [this](const std::string& error)
  {
    if (!error.empty())
    {
      vtkErrorMacro(<< "Wrong input: " << error << ".");
    }
    return !error.empty();
  };
  palpate::ElasticBodyInput input;
  if (failed(palpate::convertVolume(grid, input.mesh)) ||
    failed(palpate::convertFixed(grid, input.fixed)))
  {
    return 0;
  }
  input.materials = palpate::convertMaterials(
    grid->GetNumberOfCells(), young, poisson, { this->YoungsModulus, this->PoissonRatio });

  const auto goOn = [this](double done) { return palpate::FilterStage{ this, 0.0, 1.0 }(done); };
  const palpate::FilterThreads threads;
  palpate::ElasticBody body;
  if (failed(body.take(std::move(input))))
  {
    return 0;
  }
  const palpate::MemoryForecast forecast = body.memoryForecast();
  if (forecast.exceeds(this->AllowedMemory()))
  {
    this->RefuseMemory(3 * grid->GetNumberOfPoints(), forecast.matrix + forecast.factor);
    return 0;
  }
  if (failed(body.assemble()))
  {
    return 0;
  }
  if (this->LoadedPoint >= body.surface().pointTotal())
  {
    vtkErrorMacro(<< "LoadedPoint must be -1 or a point of the surface, which has "
                  << body.surface().pointTotal() << ", but is " << this->LoadedPoint << ".");
    return 0;
  }
  if (!goOn(0.05))
  {
    return 1;
  }
  if (failed(body.analyse(kindOf(this->Solver))))
  {
    return 0;
  }
  this->MemoryEstimate = body.memoryEstimate() / Mebibyte;
  if (body.memoryEstimate() > this->AllowedMemory())
  {
    this->RefuseMemory(body.unknowns(), body.memoryEstimate());
    return 0;
  }
  if (!goOn(0.1))
  {
    return 1;
  }
  if (failed(body.factorise()))
  {
    return 0;
  }
  if (!goOn(0.4))
  {
    return 1;
  }

  const palpate::BodySurface& surface = body.surface();
  std::vector<std::int32_t> points(static_cast<std::size_t>(surface.pointTotal()));
  std::iota(points.begin(), points.end(), 0);
  palpate::PatchCompliances compliances = palpate::patchCompliances(
    body, points, this->PatchRadius, palpate::FilterStage{ this, 0.4, 0.8 });
  if (compliances.compliance.empty())
  {
    return 1; // aborted
  }
  palpate::GlobalModes modes;
  if (this->NumberOfModes > 0)
  {
    modes = palpate::globalModes(body, compliances, this->PatchRadius, this->NumberOfModes,
      palpate::FilterStage{ this, 0.8, 0.99 });
    if (modes.fields.empty())
    {
      return 1; // aborted
    }
    this->NeglectedByModes = modes.neglected;
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
  if (this->NumberOfModes > 0)
  {
    attachModes(modes, output);
  }
  if (this->LoadedPoint >= 0)
  {
    attachDisplacement(body, static_cast<std::int32_t>(this->LoadedPoint), this->PatchRadius,
      this->LoadForce, output);
  }
  this->UpdateProgress(1.0);
  return 1;
}

double vtkElasticCompliance::AllowedMemory() const
{
  return this->MemoryLimit > 0.0 ? Mebibyte * this->MemoryLimit
                                 : MemoryShare * palpate::availableMemory();
}

void vtkElasticCompliance::RefuseMemory(vtkIdType unknowns, double bytes)
{
  this->MemoryEstimate = bytes / Mebibyte;
  vtkErrorMacro(<< "The factorisation of " << unknowns << " unknowns needs about "
                << this->MemoryEstimate << " MiB, more than "
                << (this->MemoryLimit > 0.0 ? "MemoryLimit, "
                                            : "what is available (MemoryLimit is 0), ")
                << this->AllowedMemory() / Mebibyte << " MiB.");
}

bool vtkElasticCompliance::CheckProperties()
{
  if (!palpate::isYoungsModulus(this->YoungsModulus))
  {
    vtkErrorMacro(<< "YoungsModulus must be positive and finite (MPa), but is "
                  << this->YoungsModulus << ".");
    return false;
  }
  if (!(this->PoissonRatio >= 0.0 && this->PoissonRatio <= palpate::LargestPoissonRatio))
  {
    vtkErrorMacro(<< "PoissonRatio must lie between 0 and " << palpate::LargestPoissonRatio
                  << " (finite elements need a compressible material), but is "
                  << this->PoissonRatio << ".");
    return false;
  }
  if (!(this->PatchRadius >= 0.0 && std::isfinite(this->PatchRadius)))
  {
    vtkErrorMacro(<< "PatchRadius must be 0 or positive (mm), but is " << this->PatchRadius << ".");
    return false;
  }
  if (!(this->MemoryLimit >= 0.0))
  {
    vtkErrorMacro(<< "MemoryLimit must be 0 or positive (MiB), but is " << this->MemoryLimit
                  << ".");
    return false;
  }
  if (this->Solver < Automatic || this->Solver > Simplicial)
  {
    vtkErrorMacro(<< "Solver must be 0, 1 or 2, but is " << this->Solver << ".");
    return false;
  }
  if (this->NumberOfModes < 0 || this->NumberOfModes > palpate::MostGlobalModes)
  {
    vtkErrorMacro(<< "NumberOfModes must lie between 0 and " << palpate::MostGlobalModes
                  << ", but is " << this->NumberOfModes << ".");
    return false;
  }
  if (this->LoadedPoint < -1 || !std::isfinite(this->LoadForce))
  {
    vtkErrorMacro(<< "LoadedPoint must be -1 or a point and LoadForce finite, but they are "
                  << this->LoadedPoint << " and " << this->LoadForce << " N.");
    return false;
  }
  return true;
}

bool vtkElasticCompliance::FetchCellArray(
  vtkUnstructuredGrid* grid, int index, vtkDataArray*& array)
{
  array = nullptr;
  vtkInformationVector* wanted = this->GetInformation()->Get(INPUT_ARRAYS_TO_PROCESS());
  if (!wanted || index >= wanted->GetNumberOfInformationObjects() ||
    !wanted->GetInformationObject(index)->Has(INPUT_PORT()))
  {
    return true; // never set: the constant property holds
  }
  vtkInformation* which = wanted->GetInformationObject(index);
  const char* name =
    which->Has(vtkDataObject::FIELD_NAME()) ? which->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  if (name && !*name)
  {
    return true; // an empty name takes the setting back
  }
  array = name ? grid->GetCellData()->GetArray(name) : this->GetInputArrayToProcess(index, grid);
  if (!array)
  {
    vtkErrorMacro(<< "Array to process " << index << " ('" << (name ? name : "active attribute")
                  << "') is not on the input's cells.");
    return false;
  }
  if (array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != grid->GetNumberOfCells())
  {
    vtkErrorMacro(<< "Array '" << array->GetName() << "' must have 1 component and "
                  << grid->GetNumberOfCells() << " tuples, but has "
                  << array->GetNumberOfComponents() << " and " << array->GetNumberOfTuples()
                  << ".");
    return false;
  }
  return true;
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
  os << indent << "LoadedPoint: " << this->LoadedPoint << "\n";
  os << indent << "LoadForce: " << this->LoadForce << " N\n";
}

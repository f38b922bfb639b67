// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeasuredContactResponse.h"

#include "Mechanics/Checked.h"
#include "Response/Bodies/SoundBody.h"
#include "Response/BodyConversion.h"
#include "Identification/CurvesFile.h"
#include "Laws/ResponseFiller.h"
#include "MeasuredResponse/DataError.h"
#include "Response/FilterStage.h"
#include "Response/BodyLaws.h"
#include "MeasuredResponse/MeasuredMaterial.h"
#include "MeasuredResponse/MeasuredRelaxation.h"
#include "Identification/MeasuredSite.h"
#include "Mechanics/ReducedModulus.h"
#include "MeasuredResponse/SiteMeasurement.h"
#include "MeasuredResponse/SiteRegistration.h"
#include "MeasuredResponse/SiteTables.h"
#include "Response/Pieces/OwnPiece.h"
#include "vtkContactTool.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace
{
// Fraction of the progress that is reported when all sites are identified.
constexpr double IdentifiedShare = 0.5;
} // namespace

vtkStandardNewMacro(vtkMeasuredContactResponse);

vtkMeasuredContactResponse::vtkMeasuredContactResponse()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

vtkMeasuredContactResponse::~vtkMeasuredContactResponse() = default;

void vtkMeasuredContactResponse::AddFileName(const std::string& fileName)
{
  this->FileNames.push_back(fileName);
  this->Modified();
}

void vtkMeasuredContactResponse::ClearFileNames()
{
  if (!this->FileNames.empty())
  {
    this->FileNames.clear();
    this->Modified();
  }
}

int vtkMeasuredContactResponse::GetNumberOfFileNames()
{
  return static_cast<int>(this->FileNames.size());
}

std::string vtkMeasuredContactResponse::GetFileName(int index)
{
  return index >= 0 && index < this->GetNumberOfFileNames()
    ? this->FileNames[static_cast<std::size_t>(index)]
    : std::string();
}

void vtkMeasuredContactResponse::AddCurvesConnection(vtkAlgorithmOutput* table)
{
  this->AddInputConnection(1, table);
}

int vtkMeasuredContactResponse::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkTable");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  }
  return 1;
}

int vtkMeasuredContactResponse::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

int vtkMeasuredContactResponse::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  if (!input || input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  const palpate::SoundBody sound(input);
  std::string fault = palpate::prefixed("Wrong input: ", sound.fault());
  if (!fault.empty())
  {
    return this->Report(fault);
  }
  vtkPolyData* body = sound.body();
  palpate::SiteMeasurement measurement;
  fault = palpate::firstFault([this] { return this->CheckProperties(); },
    [&] { return this->ReadSites(inputVector[1], measurement); });
  if (!fault.empty())
  {
    return this->Report(fault);
  }
  measurement.Mesh = std::make_unique<palpate::BodyMesh>(palpate::makeBodyMesh(body));
  this->SiteResidual = measurement.place(this->MaximumSiteDistance);
  if (!this->IdentifySites(measurement))
  {
    return 1; // the filter was aborted
  }
  fault = palpate::prefixed("No site can be used: ", this->JudgeSites(measurement));
  if (!fault.empty())
  {
    return this->Report(fault);
  }

  vtkNew<vtkPolyData> spread;
  palpate::spreadMaterial(body, this->PoissonRatio, this->Reach, measurement, spread);
  fault = this->RespondTo(measurement, spread, output);
  if (fault.empty() && output->GetNumberOfPoints() > 0) // not empty unless the filter was aborted
  {
    palpate::limitToData(measurement, this->ResponseName, this->MaximumDeflection, output);
    palpate::attachMeasuredRelaxation(measurement, this->ResponseName, output);
    sound.giveBack(output);
    palpate::tabulateSites(measurement.Sites, vtkTable::GetData(outputVector, 1));
    palpate::tabulateCurves(
      measurement.Sites, measurement.Identification->kernel(), vtkTable::GetData(outputVector, 2));
  }
  return this->Report(fault);
}

std::string vtkMeasuredContactResponse::CheckProperties()
{
  std::ostringstream fault;
  const auto require = [&fault](bool good, const char* name, const char* range, double value)
  {
    if (!good && fault.str().empty())
    {
      fault << name << " must be " << range << ", but is " << value;
    }
  };
  const auto positive = [&](const char* name, double value)
  { require(std::isfinite(value) && value > 0.0, name, "positive and finite", value); };
  require(palpate::isPoissonsRatio(this->PoissonRatio), "Poisson's Ratio", "between 0 and 0.5",
    this->PoissonRatio);
  require(std::isfinite(this->Noise) && this->Noise >= 0.0, "Noise Of Force (Noise)",
    "0 or more (N)", this->Noise);
  positive("Maximum Hysteresis", this->MaximumHysteresis);
  positive("Maximum Rate Effect", this->MaximumRateEffect);
  positive("Maximum Strain", this->MaximumStrain);
  positive("Maximum Misfit", this->MaximumMisfit);
  positive("Maximum Uncertainty", this->MaximumUncertainty);
  positive("Maximum Site Distance", this->MaximumSiteDistance);
  positive("Reach", this->Reach);
  const int tables = this->GetNumberOfInputConnections(1);
  if (this->FileNames.empty() && tables == 0)
  {
    return "Curves are required: give their files (AddFileName), or a Curve Table (input port 1)";
  }
  if (tables > 0 && this->MeasuringTool.empty())
  {
    return "The Measuring Tool of the table of curves is required, for example 'sphere:6.35'";
  }
  palpate::PronySeries series;
  return fault.str().empty() ? this->Relaxations.fillSeries(series) : fault.str();
}

std::string vtkMeasuredContactResponse::ReadSites(
  vtkInformationVector* tables, palpate::SiteMeasurement& measurement)
{
  for (const std::string& name : this->FileNames)
  {
    palpate::MeasuredCurves curves;
    std::string fault = palpate::readCurves(name, curves);
    if (!fault.empty())
    {
      return fault;
    }
    measurement.Files.push_back(std::move(curves));
  }
  for (int i = 0; i < tables->GetNumberOfInformationObjects(); ++i)
  {
    palpate::MeasuredCurves curves;
    std::string fault = palpate::curvesFromTable(vtkTable::GetData(tables, i),
      "Table " + std::to_string(i) + " of curves", this->MeasuringTool, curves);
    if (!fault.empty())
    {
      return fault;
    }
    measurement.Files.push_back(std::move(curves));
  }
  palpate::SiteRegistration registration;
  std::string fault = this->RegistrationFile.empty()
    ? std::string()
    : palpate::readRegistration(this->RegistrationFile, registration);
  this->RegistrationResidual =
    registration.pairs > 0 ? registration.residual : std::numeric_limits<double>::quiet_NaN();

  std::vector<palpate::MeasuredSite> sites;
  if (fault.empty())
  {
    fault = palpate::collectSites(measurement.Files, sites);
  }
  for (palpate::MeasuredSite& site : sites)
  {
    const Eigen::Vector3d position = registration.motion * site.position;
    measurement.Sites.push_back({ std::move(site), position, 0.0 });
  }
  palpate::IdentificationOptions options;
  if (this->BodyModel != Automatic)
  {
    options.model = static_cast<palpate::BodyModel>(this->BodyModel - HalfSpace);
  }
  options.noise = this->Noise;
  options.poissonRatio = this->PoissonRatio;
  options.base = static_cast<palpate::LayerBase>(this->LayerBase);
  options.findContact = this->FindContact;
  options.largestStrain = this->MaximumStrain;
  options.largestMisfit = this->MaximumMisfit;
  options.largestUncertainty = this->MaximumUncertainty;
  // CheckProperties() has already checked the relaxation.
  this->Relaxations.fillSeries(options.relaxation);
  measurement.Identification = std::make_unique<palpate::BodyIdentification>(options);
  return fault;
}

/// Returns false if the filter was aborted.
bool vtkMeasuredContactResponse::IdentifySites(palpate::SiteMeasurement& measurement)
{
  const palpate::ElasticityLimits limits{ this->MaximumHysteresis, this->MaximumRateEffect };
  const auto count = static_cast<vtkIdType>(measurement.Sites.size());
  const vtkIdType block = std::max(1, 4 * vtkSMPTools::GetEstimatedNumberOfThreads());
  for (vtkIdType first = 0; first < count; first += block)
  {
    vtkSMPTools::For(first, std::min(count, first + block), 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          palpate::MeasuredSite& site = measurement.Sites[static_cast<std::size_t>(i)].measured;
          if (site.refusal.empty())
          {
            palpate::identifySite(limits, *measurement.Identification, site);
          }
        }
      });
    this->UpdateProgress(IdentifiedShare * static_cast<double>(first) / static_cast<double>(count));
    if (palpate::isAborted(this))
    {
      return false;
    }
  }
  return true;
}

/// Warns of refused sites. If all sites are refused, returns their names and the reasons.
std::string vtkMeasuredContactResponse::JudgeSites(const palpate::SiteMeasurement& measurement)
{
  std::string refused;
  const std::size_t count = measurement.countRefused(refused);
  if (count == measurement.Sites.size())
  {
    return refused;
  }
  if (count > 0)
  {
    vtkWarningMacro(<< count << " of " << measurement.Sites.size()
                    << " sites are not used: " << refused << ".");
  }
  return {};
}

std::string vtkMeasuredContactResponse::RespondTo(
  const palpate::SiteMeasurement& measurement, vtkPolyData* body, vtkPolyData* output)
{
  const auto anywhere = [body](const char* name)
  { return std::string(body->GetPointData()->GetArray(name)->GetMaxNorm() > 0.0 ? name : ""); };
  palpate::LawRequest request;
  request.tool = this->Tool;
  request.responseName = this->ResponseName;
  request.deflection = this->MaximumDeflection;
  request.samples = this->NumberOfSamples;
  request.terms = palpate::LawTerms::plain(); // the law with which the sites were identified
  request.terms.errorTolerance = this->ErrorTolerance;
  request.terms.storeError = this->StoreError;
  request.terms.tilt = this->MaximumTilt;
  std::unique_ptr<palpate::DataError> data;
  palpate::MeasuredBodyError known;
  if (this->ErrorTolerance > 0.0 && palpate::checkRequest(request).empty())
  {
    data = std::make_unique<palpate::DataError>(
      measurement, *this->Tool->GetKernel(), this->MaximumDeflection, this->NumberOfSamples);
    known = { [&data](std::size_t point, std::size_t sample) { return data->at(point, sample); },
      [&data](std::size_t point) { return data->contactAt(point); } };
    request.measured = &known;
  }
  request.material.poissonRatio = this->PoissonRatio;
  request.material.base = static_cast<palpate::LayerBase>(this->LayerBase);
  // No site has both a compliance and a layer. Between sites both are interpolated.
  request.material.complianceExcludesLayer = true;
  request.arrays = palpate::materialArrays(body,
    { palpate::MeasuredMaterial::YoungArray, anywhere(palpate::MeasuredMaterial::ThicknessArray),
      anywhere(palpate::MeasuredMaterial::ComplianceArray), "" });
  const palpate::Ranks ranks(vtkMultiProcessController::GetGlobalController());
  std::string warning;
  std::string fault = palpate::attachResponse(ranks, palpate::ownPiece(body, ranks), request,
    palpate::FilterStage{ this, IdentifiedShare, 1.0 }, output, warning);
  if (fault.empty() && !warning.empty())
  {
    vtkWarningMacro(<< warning << ".");
  }
  output->GetPointData()->RemoveArray(palpate::MeasuredMaterial::YoungArray);
  return fault;
}

void vtkMeasuredContactResponse::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileNames: " << this->FileNames.size() << "\n";
  for (const std::string& name : this->FileNames)
  {
    os << indent.GetNextIndent() << name << "\n";
  }
  os << indent << "MeasuringTool: " << this->MeasuringTool << "\n";
  os << indent << "RegistrationFile: " << this->RegistrationFile << "\n";
  os << indent << "BodyModel: " << this->BodyModel << "\n";
  os << indent << "PoissonRatio: " << this->PoissonRatio << "\n";
  os << indent << "LayerBase: " << this->LayerBase << "\n";
  os << indent << "FindContact: " << this->FindContact << "\n";
  os << indent << "Noise: " << this->Noise << " N\n";
  os << indent << "MaximumHysteresis: " << this->MaximumHysteresis << "\n";
  os << indent << "MaximumRateEffect: " << this->MaximumRateEffect << "\n";
  os << indent << "Relaxations: " << this->Relaxations.count() << "\n";
  os << indent << "MaximumStrain: " << this->MaximumStrain << "\n";
  os << indent << "MaximumMisfit: " << this->MaximumMisfit << "\n";
  os << indent << "MaximumUncertainty: " << this->MaximumUncertainty << "\n";
  os << indent << "MaximumSiteDistance: " << this->MaximumSiteDistance << " mm\n";
  os << indent << "Reach: " << this->Reach << " mm\n";
  os << indent << "MaximumDeflection: " << this->MaximumDeflection << " mm\n";
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n";
  os << indent << "MaximumTilt: " << this->MaximumTilt << " degrees\n";
  os << indent << "StoreError: " << this->StoreError << "\n";
  os << indent << "RegistrationResidual: " << this->RegistrationResidual << " mm\n";
  os << indent << "SiteResidual: " << this->SiteResidual << " mm\n";
}

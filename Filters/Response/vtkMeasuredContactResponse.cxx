// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeasuredContactResponse.h"

#include "BodyConversion.h"
#include "CurvesFile.h"
#include "DataEnd.h"
#include "FilterStage.h"
#include "InnerMessages.h"
#include "MeasuredSite.h"
#include "ReducedModulus.h"
#include "SiteMeasurement.h"
#include "SiteRegistration.h"
#include "SiteTables.h"
#include "vtkContactTool.h"
#include "vtkToolContactResponse.h"

#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace
{
constexpr double IdentifiedShare = 0.5; // of the work, as progress tells it
constexpr unsigned char OutOfReach = 4;
constexpr unsigned char DataEndLimit = 6;
constexpr double PlaceholderModulus = 1.0; // MPa, of points that get no response

const char* const ModulusArray = "IdentifiedModulus";
const char* const ComplianceArray = "IdentifiedCompliance";
const char* const ThicknessArray = "IdentifiedThickness";
const char* const YoungArray = "palpate:YoungsModulus"; // between this filter and the next

vtkSmartPointer<vtkDoubleArray> addPointArray(vtkPolyData* body, const char* name)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfTuples(body->GetNumberOfPoints());
  body->GetPointData()->AddArray(array);
  return array;
}
} // namespace

/// Everything between the files and the response.
struct vtkMeasuredContactResponse::Measurement : public palpate::SiteMeasurement
{
};

vtkStandardNewMacro(vtkMeasuredContactResponse);

vtkMeasuredContactResponse::vtkMeasuredContactResponse()
{
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

void vtkMeasuredContactResponse::SetTool(vtkContactTool* tool)
{
  if (this->Tool != tool)
  {
    this->Tool = tool;
    this->Modified();
  }
}

vtkContactTool* vtkMeasuredContactResponse::GetTool()
{
  return this->Tool;
}

vtkMTimeType vtkMeasuredContactResponse::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Tool ? std::max(own, this->Tool->GetMTime()) : own;
}

int vtkMeasuredContactResponse::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

int vtkMeasuredContactResponse::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* body = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  if (!body || body->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  std::string fault = palpate::checkTriangles(body);
  if (!fault.empty())
  {
    vtkErrorMacro(<< "Wrong input: " << fault << ".");
    return 0;
  }
  Measurement measurement;
  fault = this->CheckProperties();
  if (fault.empty())
  {
    fault = this->ReadSites(measurement);
  }
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    return 0;
  }
  measurement.Mesh = std::make_unique<palpate::BodyMesh>(palpate::makeBodyMesh(body));
  this->SiteResidual = measurement.place(this->MaximumSiteDistance);
  if (!this->IdentifySites(measurement))
  {
    return 1; // aborted
  }
  fault = this->JudgeSites(measurement);
  if (!fault.empty())
  {
    vtkErrorMacro(<< "No site can be used: " << fault << ".");
    return 0;
  }

  vtkNew<vtkPolyData> spread;
  this->SpreadSites(body, measurement, spread);
  if (!this->RespondTo(spread, output))
  {
    return 0;
  }
  if (output->GetNumberOfPoints() > 0) // not aborted
  {
    this->LimitToData(measurement, output);
    palpate::tabulateSites(measurement.Sites, vtkTable::GetData(outputVector, 1));
    palpate::tabulateCurves(
      measurement.Sites, measurement.Identification->kernel(), vtkTable::GetData(outputVector, 2));
  }
  return 1;
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
  require(palpate::isPoissonsRatio(this->PoissonRatio), "PoissonRatio", "between 0 and 0.5",
    this->PoissonRatio);
  require(std::isfinite(this->Noise) && this->Noise >= 0.0, "Noise", "0 or more (N)", this->Noise);
  positive("MaximumHysteresis", this->MaximumHysteresis);
  positive("MaximumRateEffect", this->MaximumRateEffect);
  positive("MaximumStrain", this->MaximumStrain);
  positive("MaximumMisfit", this->MaximumMisfit);
  positive("MaximumUncertainty", this->MaximumUncertainty);
  positive("MaximumSiteDistance", this->MaximumSiteDistance);
  positive("Reach", this->Reach);
  if (this->FileNames.empty())
  {
    return "A file of curves is required: call AddFileName";
  }
  return fault.str();
}

std::string vtkMeasuredContactResponse::ReadSites(Measurement& measurement)
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
  options.poissonsRatio = this->PoissonRatio;
  options.base = static_cast<palpate::LayerBase>(this->LayerBase);
  options.findContact = this->FindContact;
  options.largestStrain = this->MaximumStrain;
  options.largestMisfit = this->MaximumMisfit;
  options.largestUncertainty = this->MaximumUncertainty;
  measurement.Identification = std::make_unique<palpate::BodyIdentification>(options);
  return fault;
}

/// False when aborted.
bool vtkMeasuredContactResponse::IdentifySites(Measurement& measurement)
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
    if (this->GetAbortExecute())
    {
      return false;
    }
  }
  return true;
}

/// Warns of refused sites; returns their names and reasons if there are no others.
std::string vtkMeasuredContactResponse::JudgeSites(const Measurement& measurement)
{
  std::string refused;
  std::size_t count = 0;
  for (const palpate::PlacedSite& site : measurement.Sites)
  {
    if (!site.measured.refusal.empty())
    {
      refused += (refused.empty() ? "site '" : "; site '") + site.measured.name +
        "': " + site.measured.refusal;
      ++count;
    }
  }
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

/// The body with what its points are made of.
void vtkMeasuredContactResponse::SpreadSites(
  vtkPolyData* body, Measurement& measurement, vtkPolyData* spread)
{
  std::vector<palpate::SiteAnchor> anchors;
  for (std::size_t i = 0; i < measurement.Sites.size(); ++i)
  {
    if (measurement.Sites[i].measured.refusal.empty())
    {
      anchors.push_back(measurement.Anchors[i]);
      measurement.Used.push_back(&measurement.Sites[i].measured.body);
    }
  }
  measurement.Spread =
    std::make_unique<palpate::SiteSpread>(*measurement.Mesh, anchors, this->Reach);

  std::vector<double> moduli;
  std::vector<double> compliances;
  std::vector<double> slenderness; // 1/h, 0 for a half-space
  for (const palpate::IdentifiedBody* site : measurement.Used)
  {
    moduli.push_back(site->body.reducedModulus);
    compliances.push_back(site->body.compliance);
    slenderness.push_back(site->body.thickness > 0.0 ? 1.0 / site->body.thickness : 0.0);
  }
  spread->ShallowCopy(body);
  const auto modulus = addPointArray(spread, ModulusArray);
  const auto compliance = addPointArray(spread, ComplianceArray);
  const auto thickness = addPointArray(spread, ThicknessArray);
  const auto young = addPointArray(spread, YoungArray);
  const double plane = 1.0 - this->PoissonRatio * this->PoissonRatio;
  vtkSMPTools::For(0, body->GetNumberOfPoints(),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        const auto point = static_cast<std::int32_t>(i);
        const bool reached = measurement.Spread->reaches(point);
        const double e = reached ? measurement.Spread->at(point, moduli) : 0.0;
        const double inverse = reached ? measurement.Spread->at(point, slenderness) : 0.0;
        modulus->SetValue(i, e);
        young->SetValue(i, plane * (reached ? e : PlaceholderModulus));
        compliance->SetValue(i, reached ? measurement.Spread->at(point, compliances) : 0.0);
        thickness->SetValue(i, inverse > 0.0 ? 1.0 / inverse : 0.0);
      }
    });
}

/// False after an error, which has been passed on.
bool vtkMeasuredContactResponse::RespondTo(vtkPolyData* body, vtkPolyData* output)
{
  vtkNew<vtkToolContactResponse> response;
  palpate::InnerMessages complaints;
  palpate::listen(response, complaints);
  palpate::listen(response->GetExecutive(), complaints);
  response->SetInputData(body);
  response->SetTool(this->Tool);
  response->SetPoissonRatio(this->PoissonRatio);
  response->SetLayerBase(this->LayerBase);
  response->ComplianceExcludesLayerOn(); // no site has both; between sites, each has its share
  response->SetMaximumDeflection(this->MaximumDeflection);
  response->SetNumberOfSamples(this->NumberOfSamples);
  response->SetResponseName(this->ResponseName);
  const auto use = [&](int index, const char* name)
  { response->SetInputArrayToProcess(index, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name); };
  const auto anywhere = [body](const char* name)
  { return body->GetPointData()->GetArray(name)->GetMaxNorm() > 0.0; };
  use(0, YoungArray);
  if (anywhere(ThicknessArray))
  {
    use(1, ThicknessArray);
  }
  if (anywhere(ComplianceArray))
  {
    use(2, ComplianceArray);
  }
  palpate::runWithin(response, { this, IdentifiedShare, 1.0 });
  if (!complaints.error.empty())
  {
    vtkErrorMacro(<< complaints.error << ".");
    return false;
  }
  if (!complaints.warning.empty())
  {
    vtkWarningMacro(<< complaints.warning << ".");
  }
  output->ShallowCopy(response->GetOutput());
  output->GetPointData()->RemoveArray(YoungArray);
  return true;
}

/// Takes the response away where no site reaches, and marks where the data end elsewhere.
void vtkMeasuredContactResponse::LimitToData(const Measurement& measurement, vtkPolyData* output)
{
  const auto array = [&](const char* suffix)
  { return output->GetPointData()->GetArray((this->ResponseName + suffix).c_str()); };
  auto* force = vtkFloatArray::SafeDownCast(array("Force"));
  auto* stiffness = vtkFloatArray::SafeDownCast(array("Stiffness"));
  auto* validity = vtkFloatArray::SafeDownCast(array("Validity"));
  auto* status = vtkUnsignedCharArray::SafeDownCast(array("Status"));
  auto* limit = vtkUnsignedCharArray::SafeDownCast(array("Limit"));
  const double exponent =
    output->GetFieldData()->GetArray((this->ResponseName + "Exponent").c_str())->GetTuple1(0);
  const palpate::ResponseSampling sampling(this->NumberOfSamples, exponent);
  const std::vector<double> forces = measurement.collect(&palpate::IdentifiedBody::endForce);
  const std::vector<double> stiffnesses =
    measurement.collect(&palpate::IdentifiedBody::endStiffness);
  const int n = this->NumberOfSamples;
  vtkSMPTools::For(0, output->GetNumberOfPoints(),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        const auto point = static_cast<std::int32_t>(i);
        float* f = force->GetPointer(n * i);
        float* k = stiffness->GetPointer(n * i);
        if (!measurement.Spread->reaches(point))
        {
          std::fill_n(f, n, 0.0F);
          std::fill_n(k, n, 0.0F);
          status->SetValue(i, status->GetValue(i) == 0 ? OutOfReach : status->GetValue(i));
          validity->SetValue(i, 0.0F);
          limit->SetValue(i, 0);
        }
        else if (status->GetValue(i) == 0)
        {
          const double depth = palpate::depthOfDataEnd(sampling, this->MaximumDeflection, f, k,
            { measurement.Spread->at(point, forces), measurement.Spread->at(point, stiffnesses) });
          if (depth < static_cast<double>(validity->GetValue(i)))
          {
            validity->SetValue(i, static_cast<float>(depth));
            limit->SetValue(i, DataEndLimit);
          }
        }
      }
    });
  palpate::describeResponse(output, this->ResponseName,
    { exponent, n, palpate::responseText(output, this->ResponseName, "Tool"),
      measurement.describe() });
}

void vtkMeasuredContactResponse::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileNames: " << this->FileNames.size() << "\n";
  for (const std::string& name : this->FileNames)
  {
    os << indent.GetNextIndent() << name << "\n";
  }
  os << indent << "RegistrationFile: " << this->RegistrationFile << "\n";
  os << indent << "Tool: " << this->Tool.Get() << "\n";
  os << indent << "BodyModel: " << this->BodyModel << "\n";
  os << indent << "PoissonRatio: " << this->PoissonRatio << "\n";
  os << indent << "LayerBase: " << this->LayerBase << "\n";
  os << indent << "FindContact: " << this->FindContact << "\n";
  os << indent << "Noise: " << this->Noise << " N\n";
  os << indent << "MaximumHysteresis: " << this->MaximumHysteresis << "\n";
  os << indent << "MaximumRateEffect: " << this->MaximumRateEffect << "\n";
  os << indent << "MaximumStrain: " << this->MaximumStrain << "\n";
  os << indent << "MaximumMisfit: " << this->MaximumMisfit << "\n";
  os << indent << "MaximumUncertainty: " << this->MaximumUncertainty << "\n";
  os << indent << "MaximumSiteDistance: " << this->MaximumSiteDistance << " mm\n";
  os << indent << "Reach: " << this->Reach << " mm\n";
  os << indent << "MaximumDeflection: " << this->MaximumDeflection << " mm\n";
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "ResponseName: " << this->ResponseName << "\n";
  os << indent << "RegistrationResidual: " << this->RegistrationResidual << " mm\n";
  os << indent << "SiteResidual: " << this->SiteResidual << " mm\n";
}

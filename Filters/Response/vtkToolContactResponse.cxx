// SPDX-License-Identifier: BSD-3-Clause
#include "vtkToolContactResponse.h"

#include "AxisymmetricTool.h"
#include "BodyConversion.h"
#include "CurvatureBound.h"
#include "PointNormals.h"
#include "ReducedModulus.h"
#include "ResponseFiller.h"
#include "ResponseLaw.h"
#include "vtkContactTool.h"

#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
constexpr vtkIdType ProgressBlocks = 20;

enum ArrayIndex
{
  YoungsModulusArray,
  LayerThicknessArray,
  GlobalComplianceArray,
  PoissonRatioArray
};
} // namespace

/// Modulus and compliance per point; empty vectors mean constants.
struct vtkToolContactResponse::Material
{
  double ConstantModulus = 0.0;
  std::vector<double> ReducedModulus;
  std::vector<double> Compliance;

  double modulusAt(vtkIdType i) const
  {
    return this->ReducedModulus.empty() ? this->ConstantModulus
                                        : this->ReducedModulus[static_cast<std::size_t>(i)];
  }

  palpate::ResponseMaterial view() const
  {
    return { this->ConstantModulus,
      this->ReducedModulus.empty() ? nullptr : this->ReducedModulus.data(),
      this->Compliance.empty() ? nullptr : this->Compliance.data() };
  }

  /// The exponent with the smaller storage error at the softest and the stiffest series.
  double bestExponent(const palpate::AxisymmetricTool& tool, const palpate::ResponseLaw& law) const
  {
    const double tip = tool.forceExponent();
    if (this->Compliance.empty() || tip == 1.0)
    {
      return tip;
    }
    std::array<std::size_t, 2> extreme = { 0, 0 };
    const auto product = [this](std::size_t i)
    { return this->modulusAt(static_cast<vtkIdType>(i)) * this->Compliance[i]; };
    for (std::size_t i = 1; i < this->Compliance.size(); ++i)
    {
      extreme[0] = product(i) < product(extreme[0]) ? i : extreme[0];
      extreme[1] = product(i) > product(extreme[1]) ? i : extreme[1];
    }
    const auto worst = [&](double exponent)
    {
      double largest = 0.0;
      for (const std::size_t i : extreme)
      {
        const double error = law.storageError(
          exponent, this->modulusAt(static_cast<vtkIdType>(i)), this->Compliance[i]);
        largest = std::isfinite(error) ? std::max(largest, error) : largest;
      }
      return largest;
    };
    return worst(1.0) < worst(tip) ? 1.0 : tip;
  }
};

vtkStandardNewMacro(vtkToolContactResponse);

vtkToolContactResponse::vtkToolContactResponse() = default;
vtkToolContactResponse::~vtkToolContactResponse() = default;

void vtkToolContactResponse::SetTool(vtkContactTool* tool)
{
  if (this->Tool != tool)
  {
    this->Tool = tool;
    this->Modified();
  }
}

vtkContactTool* vtkToolContactResponse::GetTool()
{
  return this->Tool;
}

vtkMTimeType vtkToolContactResponse::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Tool ? std::max(own, this->Tool->GetMTime()) : own;
}

int vtkToolContactResponse::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* body = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (!body || body->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  const std::string fault = palpate::checkTriangles(body);
  if (!fault.empty())
  {
    vtkErrorMacro(<< "Wrong input: " << fault << ".");
    return 0;
  }
  Material material;
  if (!this->CheckProperties() || !this->ReadMaterial(body, material))
  {
    return 0;
  }

  const vtkIdType count = body->GetNumberOfPoints();
  const palpate::AxisymmetricTool& tool = *this->Tool->GetKernel();
  const palpate::ResponseLaw law(tool, this->MaximumDeflection, this->NumberOfSamples);
  palpate::ResponseStorage storage(this->ResponseName, count, this->NumberOfSamples);
  const std::string wrongSide = palpate::fillPointNormals(body, storage.Normal, storage.Status);
  if (!wrongSide.empty())
  {
    vtkErrorMacro(<< "Wrong input: " << wrongSide << ".");
    return 0;
  }
  const palpate::CurvatureBound curvature(body, storage.Normal->GetPointer(0));

  const palpate::ResponseFiller filler(
    tool, law, curvature, material.view(), this->MaximumDeflection, storage);
  for (vtkIdType block = 0; block < ProgressBlocks; ++block)
  {
    vtkSMPTools::For(count * block / ProgressBlocks, count * (block + 1) / ProgressBlocks,
      [&filler](vtkIdType first, vtkIdType last) { filler.fill(first, last); });
    this->UpdateProgress(static_cast<double>(block + 1) / ProgressBlocks);
    if (this->GetAbortExecute())
    {
      output->Initialize();
      return 1;
    }
  }

  const vtkIdType without = std::count_if(storage.Status->GetPointer(0),
    storage.Status->GetPointer(0) + count, [](unsigned char status) { return status != 0; });
  if (without > 0)
  {
    vtkWarningMacro(<< without << " of " << count << " points have no response: see array '"
                    << this->ResponseName << "Status'.");
  }

  output->ShallowCopy(body);
  storage.attach(output);
  palpate::describeResponse(output, this->ResponseName,
    { material.bestExponent(tool, law), this->NumberOfSamples, tool.specification(),
      material.Compliance.empty() ? "half-space" : "half-space in series with global compliance" });
  return 1;
}

bool vtkToolContactResponse::CheckProperties()
{
  if (!this->Tool)
  {
    vtkErrorMacro(<< "A Tool is required: call SetTool.");
    return false;
  }
  if (!this->Tool->GetKernel())
  {
    vtkErrorMacro(<< "The Tool is invalid.");
    return false;
  }
  if (!palpate::isYoungsModulus(this->YoungsModulus))
  {
    vtkErrorMacro(<< "YoungsModulus must be positive and finite (MPa), but is "
                  << this->YoungsModulus << ".");
    return false;
  }
  if (!palpate::isPoissonsRatio(this->PoissonRatio))
  {
    vtkErrorMacro(<< "PoissonRatio must lie between 0 and 0.5, but is " << this->PoissonRatio
                  << ".");
    return false;
  }
  if (!(std::isfinite(this->MaximumDeflection) &&
        this->MaximumDeflection > static_cast<double>(std::numeric_limits<float>::min())))
  {
    vtkErrorMacro(<< "MaximumDeflection must be positive and finite (mm), but is "
                  << this->MaximumDeflection << ".");
    return false;
  }
  if (this->NumberOfSamples < 2 || this->NumberOfSamples > palpate::ResponseSampling::LargestCount)
  {
    vtkErrorMacro(<< "NumberOfSamples must lie between 2 and "
                  << palpate::ResponseSampling::LargestCount << ", but is " << this->NumberOfSamples
                  << ".");
    return false;
  }
  if (this->ResponseName.empty())
  {
    vtkErrorMacro(<< "ResponseName must not be empty.");
    return false;
  }
  return true;
}

bool vtkToolContactResponse::ReadMaterial(vtkPolyData* body, Material& material)
{
  vtkDataArray* young = nullptr;
  vtkDataArray* thickness = nullptr;
  vtkDataArray* compliance = nullptr;
  vtkDataArray* poisson = nullptr;
  if (!this->FetchArray(body, YoungsModulusArray, young) ||
    !this->FetchArray(body, LayerThicknessArray, thickness) ||
    !this->FetchArray(body, GlobalComplianceArray, compliance) ||
    !this->FetchArray(body, PoissonRatioArray, poisson))
  {
    return false;
  }
  if (thickness)
  {
    vtkErrorMacro(<< "Array to process 1, layer thickness ('" << thickness->GetName()
                  << "'): layers are not available in this version.");
    return false;
  }
  material.ConstantModulus = palpate::reducedModulus(this->YoungsModulus, this->PoissonRatio);
  const vtkIdType count = body->GetNumberOfPoints();
  if (young || poisson)
  {
    const auto youngAt = [&](vtkIdType i)
    { return young ? young->GetComponent(i, 0) : this->YoungsModulus; };
    const auto poissonAt = [&](vtkIdType i)
    { return poisson ? poisson->GetComponent(i, 0) : this->PoissonRatio; };
    material.ReducedModulus.resize(static_cast<std::size_t>(count));
    double* modulus = material.ReducedModulus.data();
    vtkSMPTools::For(0, count,
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          modulus[i] = palpate::reducedModulus(youngAt(i), poissonAt(i)); // NaN if one is wrong
        }
      });
    const vtkIdType wrong =
      std::find_if(modulus, modulus + count, [](double m) { return std::isnan(m); }) - modulus;
    if (wrong < count && !palpate::isYoungsModulus(youngAt(wrong)))
    {
      vtkErrorMacro(<< "Array '" << young->GetName() << "': Young's modulus of point " << wrong
                    << " must be positive and finite (MPa), but is " << youngAt(wrong) << ".");
      return false;
    }
    if (wrong < count)
    {
      vtkErrorMacro(<< "Array '" << poisson->GetName() << "': Poisson's ratio of point " << wrong
                    << " must lie between 0 and 0.5, but is " << poissonAt(wrong) << ".");
      return false;
    }
  }
  if (compliance)
  {
    material.Compliance.resize(static_cast<std::size_t>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      const double c = compliance->GetTuple1(i);
      if (!std::isfinite(c))
      {
        vtkErrorMacro(<< "Array '" << compliance->GetName() << "': global compliance of point " << i
                      << " must be finite (mm/N), but is " << c << ".");
        return false;
      }
      material.Compliance[static_cast<std::size_t>(i)] = c;
    }
  }
  return true;
}

bool vtkToolContactResponse::FetchArray(vtkPolyData* body, int index, vtkDataArray*& array)
{
  array = nullptr;
  vtkInformationVector* wanted = this->GetInformation()->Get(INPUT_ARRAYS_TO_PROCESS());
  if (!wanted || index >= wanted->GetNumberOfInformationObjects() ||
    !wanted->GetInformationObject(index)->Has(INPUT_PORT()))
  {
    return true; // never set: the constant property holds
  }
  vtkInformation* which = wanted->GetInformationObject(index);
  if (which->Has(vtkDataObject::FIELD_NAME()) && !*which->Get(vtkDataObject::FIELD_NAME()))
  {
    return true; // an empty name takes the setting back
  }
  array = this->GetInputArrayToProcess(index, body);
  if (!array)
  {
    vtkErrorMacro(<< "Array to process " << index << " ('"
                  << (which->Has(vtkDataObject::FIELD_NAME())
                         ? which->Get(vtkDataObject::FIELD_NAME())
                         : "active attribute")
                  << "') is not on the input's points.");
    return false;
  }
  if (array->GetNumberOfComponents() != 1 ||
    array->GetNumberOfTuples() != body->GetNumberOfPoints())
  {
    vtkErrorMacro(<< "Array '" << array->GetName() << "' must have 1 component and "
                  << body->GetNumberOfPoints() << " tuples, but has "
                  << array->GetNumberOfComponents() << " and " << array->GetNumberOfTuples()
                  << ".");
    return false;
  }
  return true;
}

void vtkToolContactResponse::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tool: " << this->Tool.Get() << "\n";
  os << indent << "YoungsModulus: " << this->YoungsModulus << " MPa\n";
  os << indent << "PoissonRatio: " << this->PoissonRatio << "\n";
  os << indent << "MaximumDeflection: " << this->MaximumDeflection << " mm\n";
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "ResponseName: " << this->ResponseName << "\n";
}

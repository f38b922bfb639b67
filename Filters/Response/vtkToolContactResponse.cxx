// SPDX-License-Identifier: BSD-3-Clause
#include "vtkToolContactResponse.h"

#include "AxisymmetricTool.h"
#include "BodyConversion.h"
#include "CurvatureBound.h"
#include "PointNormals.h"
#include "ReducedModulus.h"
#include "ResponseLaw.h"
#include "vtkContactTool.h"

#include "vtkDataSetAttributes.h"
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
#include "vtkSMPTools.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace
{
constexpr int LargestSampleCount = 256;
constexpr double StrainRatio = 0.4; // a/R: about 8 % strain (Tabor's 0.2 a/R)
constexpr double NormalTurn = 0.2;  // rad the body's normal may turn under the contact radius
constexpr vtkIdType ProgressBlocks = 20;

enum ArrayIndex
{
  YoungsModulusArray,
  LayerThicknessArray,
  GlobalComplianceArray,
  PoissonRatioArray
};

enum Limit : unsigned char
{
  NoLimit,
  StrainLimit,
  CurvatureLimit
};

/// The point arrays of one response, allocated together, attached together.
struct ResponseStorage
{
  vtkNew<vtkFloatArray> Force;
  vtkNew<vtkFloatArray> Stiffness;
  vtkNew<vtkFloatArray> Normal;
  vtkNew<vtkFloatArray> Range;
  vtkNew<vtkFloatArray> Validity;
  vtkNew<vtkUnsignedCharArray> Status;
  vtkNew<vtkUnsignedCharArray> LimitReached;

  ResponseStorage(const std::string& name, vtkIdType points, int samples)
  {
    allocate(this->Force.Get(), name + "Force", samples, points);
    allocate(this->Stiffness.Get(), name + "Stiffness", samples, points);
    allocate(this->Normal.Get(), name + "Normal", 3, points);
    allocate(this->Range.Get(), name + "Range", 1, points);
    allocate(this->Validity.Get(), name + "Validity", 1, points);
    allocate(this->Status.Get(), name + "Status", 1, points);
    allocate(this->LimitReached.Get(), name + "Limit", 1, points);
  }

  void attach(vtkPolyData* output)
  {
    for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{ this->Force, this->Stiffness,
           this->Normal, this->Range, this->Validity, this->Status, this->LimitReached })
    {
      output->GetPointData()->AddArray(array);
    }
  }

private:
  static void allocate(
    vtkDataArray* array, const std::string& name, int components, vtkIdType tuples)
  {
    array->SetName(name.c_str());
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(tuples);
  }
};

/// What stands in one point: the curve, and how deep it may be trusted.
struct PointFiller
{
  const palpate::AxisymmetricTool& Tool;
  const palpate::ResponseLaw& Law;
  const std::vector<float>& Curvature;
  std::function<double(vtkIdType)> ReducedModulus;
  std::function<double(vtkIdType)> Compliance;
  ResponseStorage& Storage;
  float Range;
  double StrainDepth;

  void fill(vtkIdType first, vtkIdType last) const
  {
    const int n = this->Storage.Force->GetNumberOfComponents();
    for (vtkIdType i = first; i < last; ++i)
    {
      float* force = this->Storage.Force->GetPointer(n * i);
      float* stiffness = this->Storage.Stiffness->GetPointer(n * i);
      unsigned char& status = *this->Storage.Status->GetPointer(i);
      const double curvature = static_cast<double>(this->Curvature[static_cast<std::size_t>(i)]);
      this->Storage.Range->SetValue(i, this->Range);
      if (status == static_cast<unsigned char>(palpate::ResponseStatus::Valid) && curvature < 0.0)
      {
        status = static_cast<unsigned char>(palpate::ResponseStatus::Degenerate);
      }
      const double compliance = this->Compliance ? this->Compliance(i) : 0.0;
      const double modulus = this->ReducedModulus(i);
      if (status != static_cast<unsigned char>(palpate::ResponseStatus::Valid))
      {
        std::fill_n(force, n, 0.0F);
        std::fill_n(stiffness, n, 0.0F);
      }
      else if (compliance == 0.0)
      {
        this->Law.sample(modulus, force, stiffness);
      }
      else if (!this->Law.sampleSeries(modulus, compliance, force, stiffness))
      {
        status = static_cast<unsigned char>(palpate::ResponseStatus::Folded);
      }
      this->fillValidity(i, status, curvature, modulus, compliance);
    }
  }

  void fillValidity(
    vtkIdType i, unsigned char status, double curvature, double modulus, double compliance) const
  {
    double depth = this->StrainDepth;
    unsigned char limit = StrainLimit;
    if (curvature > 0.0)
    {
      const double turned = this->Tool.depthAtContactRadius(NormalTurn / curvature);
      if (turned < depth)
      {
        depth = turned;
        limit = CurvatureLimit;
      }
    }
    if (compliance != 0.0 && std::isfinite(depth))
    {
      depth = this->Law.totalDeflection(modulus, compliance, depth);
    }
    if (!(depth < static_cast<double>(this->Range)))
    {
      depth = static_cast<double>(this->Range);
      limit = NoLimit;
    }
    const bool valid = status == static_cast<unsigned char>(palpate::ResponseStatus::Valid);
    this->Storage.Validity->SetValue(i, valid ? static_cast<float>(depth) : 0.0F);
    this->Storage.LimitReached->SetValue(i, valid ? limit : static_cast<unsigned char>(NoLimit));
  }
};

template <class Array, class Value>
void addFieldValue(vtkPolyData* output, const std::string& name, const Value& value)
{
  vtkNew<Array> array;
  array->SetName(name.c_str());
  array->InsertNextValue(value);
  output->GetFieldData()->AddArray(array);
}
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
  ResponseStorage storage(this->ResponseName, count, this->NumberOfSamples);
  const std::string wrongSide = palpate::fillPointNormals(body, storage.Normal, storage.Status);
  if (!wrongSide.empty())
  {
    vtkErrorMacro(<< "Wrong input: " << wrongSide << ".");
    return 0;
  }
  const std::vector<float> curvature = palpate::curvatureBound(body, storage.Normal->GetPointer(0));

  PointFiller filler{ tool, law, curvature,
    [&material](vtkIdType i) { return material.modulusAt(i); }, {}, storage,
    static_cast<float>(this->MaximumDeflection), tool.depthAtStrain(StrainRatio) };
  if (!material.Compliance.empty())
  {
    filler.Compliance = [&material](vtkIdType i)
    { return material.Compliance[static_cast<std::size_t>(i)]; };
  }
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
  const double exponent = material.bestExponent(tool, law);
  addFieldValue<vtkDoubleArray>(output, this->ResponseName + "Exponent", exponent);
  addFieldValue<vtkIntArray>(output, this->ResponseName + "Samples", this->NumberOfSamples);
  addFieldValue<vtkStringArray>(output, this->ResponseName + "Tool", tool.specification());
  addFieldValue<vtkStringArray>(output, this->ResponseName + "Model",
    material.Compliance.empty() ? "half-space" : "half-space in series with global compliance");
  addFieldValue<vtkStringArray>(output, this->ResponseName + "Units", "mm,N,MPa");
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
  if (this->NumberOfSamples < 2 || this->NumberOfSamples > LargestSampleCount)
  {
    vtkErrorMacro(<< "NumberOfSamples must lie between 2 and " << LargestSampleCount << ", but is "
                  << this->NumberOfSamples << ".");
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
    material.ReducedModulus.resize(static_cast<std::size_t>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      const double e = young ? young->GetTuple1(i) : this->YoungsModulus;
      const double nu = poisson ? poisson->GetTuple1(i) : this->PoissonRatio;
      if (!palpate::isYoungsModulus(e))
      {
        vtkErrorMacro(<< "Array '" << young->GetName() << "': Young's modulus of point " << i
                      << " must be positive and finite (MPa), but is " << e << ".");
        return false;
      }
      if (!palpate::isPoissonsRatio(nu))
      {
        vtkErrorMacro(<< "Array '" << poisson->GetName() << "': Poisson's ratio of point " << i
                      << " must lie between 0 and 0.5, but is " << nu << ".");
        return false;
      }
      material.ReducedModulus[static_cast<std::size_t>(i)] = palpate::reducedModulus(e, nu);
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

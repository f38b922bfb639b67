// SPDX-License-Identifier: BSD-3-Clause
#include "vtkToolContactResponse.h"

#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Response/BodyConversion.h"
#include "Laws/BodyMaterial.h"
#include "Response/Pieces/BodySeam.h"
#include "Response/Curves/CurvatureBound.h"
#include "Response/FilterStage.h"
#include "Response/Curves/MaterialArrays.h"
#include "Response/Pieces/OwnPiece.h"
#include "Response/Curves/PointNormals.h"
#include "Response/Pieces/Ranks.h"
#include "Laws/ResponseFiller.h"
#include "Laws/ResponseLaw.h"
#include "Response/Curves/ResponseStorage.h"
#include "vtkContactTool.h"

#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace
{
constexpr vtkIdType ProgressBlocks = 20;

/// The middle one of the three lengths of the whole body's box, mm: no circle much wider fits it.
double widthOf(vtkPolyData* body, const palpate::Ranks& ranks)
{
  std::array<double, 6> bounds{};
  body->GetBounds(bounds.data());
  const bool hasBounds = vtkMath::AreBoundsInitialized(bounds.data()) != 0;
  constexpr double none = std::numeric_limits<double>::infinity();
  std::array<double, 3> length{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    length[axis] = ranks.largest(hasBounds ? bounds[2 * axis + 1] : -none) -
      ranks.smallest(hasBounds ? bounds[2 * axis] : none);
  }
  std::sort(length.begin(), length.end());
  return length[1];
}
} // namespace

vtkStandardNewMacro(vtkToolContactResponse);

vtkToolContactResponse::vtkToolContactResponse()
  : Controller(vtkMultiProcessController::GetGlobalController())
{
}

vtkToolContactResponse::~vtkToolContactResponse() = default;

void vtkToolContactResponse::SetController(vtkMultiProcessController* controller)
{
  if (this->Controller != controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkToolContactResponse::GetController()
{
  return this->Controller;
}

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
  const palpate::Ranks ranks(this->Controller);
  const auto body = palpate::ownPiece(vtkPolyData::GetData(inputVector[0]), ranks);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const bool hasPiece = body->GetNumberOfPoints() > 0;
  if (!ranks.any(hasPiece))
  {
    return 1;
  }
  const std::string fault =
    ranks.firstFault(hasPiece ? palpate::checkTriangles(body) : std::string());
  if (!fault.empty())
  {
    vtkErrorMacro(<< "Wrong input: " << fault << ".");
    return 0;
  }
  if (!this->CheckProperties())
  {
    return 0;
  }
  palpate::BodyMaterial material({ this->YoungsModulus, this->PoissonRatio, this->LayerThickness,
    static_cast<palpate::LayerBase>(this->LayerBase), this->ComplianceExcludesLayer });
  const auto find = [this, &body](int index) { return this->GetInputArrayToProcess(index, body); };
  const std::string wrongMaterial =
    ranks.firstFault(hasPiece ? palpate::readMaterial(this, body, find, material) : std::string());
  if (!wrongMaterial.empty())
  {
    vtkErrorMacro(<< wrongMaterial << ".");
    return 0;
  }
  palpate::agreeOnRange(ranks, hasPiece, material);

  const vtkIdType count = body->GetNumberOfPoints();
  const palpate::AxisymmetricTool& tool = *this->Tool->GetKernel();
  const std::string tooDeep = tool.checkDepth(this->MaximumDeflection);
  if (!tooDeep.empty())
  {
    vtkErrorMacro(<< "MaximumDeflection: " << tooDeep << ".");
    return 0;
  }
  palpate::ResponseLaw law(tool, this->MaximumDeflection, this->NumberOfSamples);
  if (material.range().hasLayers())
  {
    law.prepareLayers(material.range().layers, material.range().stiffens);
  }
  palpate::ResponseStorage storage(this->ResponseName, count, this->NumberOfSamples);
  const palpate::BodySeam seam(ranks, body);
  const std::string wrongSide =
    palpate::fillPointNormals(body, seam, storage.Normal, storage.Status);
  if (!wrongSide.empty())
  {
    vtkErrorMacro(<< "Wrong input: " << wrongSide << ".");
    return 0;
  }
  const palpate::CurvatureBound curvature(body, seam, storage.Normal->GetPointer(0));
  const double width = widthOf(body, ranks);
  if (!hasPiece)
  {
    return 1;
  }

  const palpate::ContactSpots spots = material.spots();
  const palpate::ResponseFiller filler(tool, law, this->MaximumDeflection, width, storage.spans());
  const auto fill = [&](vtkIdType first, vtkIdType last)
  {
    for (vtkIdType i = first; i < last; ++i)
    {
      const auto point = static_cast<std::size_t>(i);
      filler.fill(point, spots.at(point), static_cast<double>(curvature.at(i)));
    }
  };
  for (vtkIdType block = 0; block < ProgressBlocks; ++block)
  {
    vtkSMPTools::For(count * block / ProgressBlocks, count * (block + 1) / ProgressBlocks, fill);
    this->UpdateProgress(static_cast<double>(block + 1) / ProgressBlocks);
    if (palpate::isAborted(this))
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
      material.describe(), material.modelParts() });
  palpate::attachLayers(material, this->ResponseName, output);
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

void vtkToolContactResponse::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller.Get() << "\n";
  os << indent << "Tool: " << this->Tool.Get() << "\n";
  os << indent << "YoungsModulus: " << this->YoungsModulus << " MPa\n";
  os << indent << "PoissonRatio: " << this->PoissonRatio << "\n";
  os << indent << "LayerThickness: " << this->LayerThickness << " mm\n";
  os << indent << "LayerBase: " << this->LayerBase << "\n";
  os << indent << "ComplianceExcludesLayer: " << this->ComplianceExcludesLayer << "\n";
  os << indent << "MaximumDeflection: " << this->MaximumDeflection << " mm\n";
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "ResponseName: " << this->ResponseName << "\n";
}

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBodyCompliance.h"

#include "Mechanics/Checked.h"
#include "Response/Bodies/SoundBody.h"
#include "Response/FilterThreads.h"
#include "SolidResponse/Bodies/YieldSolution.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkBodyCompliance);

int vtkBodyCompliance::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* body = vtkPolyData::GetData(inputVector[0]);
  if (!body || body->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  const std::string fault = this->Attach(body, vtkPolyData::GetData(outputVector));
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    return 0;
  }
  return 1;
}

std::string vtkBodyCompliance::Attach(vtkPolyData* body, vtkPolyData* output)
{
  const palpate::FilterThreads threads;
  const palpate::YieldRequest request{ this->YoungsModulus, this->PoissonRatio, this->ContactRadius,
    this->FixedFaces, this->NumberOfCells };
  const palpate::SoundBody sound(body);
  if (!sound.fault().empty())
  {
    return "Wrong input: " + sound.fault();
  }
  palpate::BodyYield found;
  const std::string fault = palpate::firstFault([&] { return palpate::checkYieldRequest(request); },
    [&] { return palpate::solveYield(sound.body(), request, this, found); });
  for (const std::string& warning : found.warnings)
  {
    vtkWarningMacro(<< warning);
  }
  if (!fault.empty() || found.compliance.empty())
  {
    return fault;
  }
  this->HeldAt = found.heldAt;
  output->ShallowCopy(sound.body());
  palpate::attachYield(found, output);
  sound.giveBack(output);
  this->UpdateProgress(1.0);
  return {};
}

void vtkBodyCompliance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "YoungsModulus: " << this->YoungsModulus << " MPa\n";
  os << indent << "PoissonRatio: " << this->PoissonRatio << "\n";
  os << indent << "ContactRadius: " << this->ContactRadius << " mm\n";
  os << indent << "FixedFaces: " << this->FixedFaces << "\n";
  os << indent << "NumberOfCells: " << this->NumberOfCells << "\n";
  os << indent << "HeldAt: " << this->HeldAt << "\n";
}

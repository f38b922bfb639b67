// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticSafety.h"

#include "Haptics/Safety/SafetySettings.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkHapticSafety);

vtkHapticSafety::vtkHapticSafety() = default;
vtkHapticSafety::~vtkHapticSafety() = default;

void vtkHapticSafety::AddFitResponse(const std::string& responseName)
{
  this->FitResponses.push_back(responseName);
  this->Modified();
}

void vtkHapticSafety::ClearFitResponses()
{
  this->FitResponses.clear();
  this->Modified();
}

palpate::SafetySettings vtkHapticSafety::GetSettings(
  const palpate::DeviceSpecification& device, bool isStiff) const
{
  auto safety = palpate::SafetySettings::of(device);
  // A limit that is NaN stays NaN, so that the error message can name it.
  safety.maximumForce = std::min(this->ForceLimit, safety.maximumForce);
  safety.maximumStiffness = std::min(this->StiffnessLimit, safety.maximumStiffness);
  safety.maximumTorque = std::min(this->TorqueLimit, safety.maximumTorque);
  safety.maximumTorsionalStiffness =
    std::min(this->TorsionalStiffnessLimit, safety.maximumTorsionalStiffness);
  safety.entryRamp = this->EntryRamp;
  safety.gate = this->Gate;
  safety.capStiffness = this->StiffnessCap;
  safety.controlPassivity = this->PassivityControl && !isStiff;
  return safety;
}

void vtkHapticSafety::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Gate: " << this->Gate << "\n";
  os << indent << "EntryRamp: " << this->EntryRamp << " s\n";
  os << indent << "StiffnessCap: " << this->StiffnessCap << "\n";
  os << indent << "PassivityControl: " << this->PassivityControl << "\n";
  os << indent << "ForceLimit: " << this->ForceLimit << " N\n";
  os << indent << "StiffnessLimit: " << this->StiffnessLimit << " N/m\n";
  os << indent << "TorqueLimit: " << this->TorqueLimit << " N m\n";
  os << indent << "TorsionalStiffnessLimit: " << this->TorsionalStiffnessLimit << " N m/rad\n";
  os << indent << "FitForce: " << this->FitForce << "\n";
  os << indent << "FitDepth: " << this->FitDepth << " mm\n";
}

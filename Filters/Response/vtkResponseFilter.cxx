// SPDX-License-Identifier: BSD-3-Clause
#include "vtkResponseFilter.h"

#include "Response/BodyLaws.h"
#include "vtkContactTool.h"

void vtkResponseFilter::AddRelaxation(double strength, double seconds)
{
  this->Relaxations.add(strength, seconds);
  this->Modified();
}

void vtkResponseFilter::ClearRelaxations()
{
  if (this->Relaxations.clear())
  {
    this->Modified();
  }
}

std::string vtkResponseFilter::FillRequest(palpate::LawRequest& request)
{
  request.tool = this->Tool;
  request.responseName = this->ResponseName;
  request.deflection = this->MaximumDeflection;
  request.samples = this->NumberOfSamples;
  request.terms.strain = this->strainLaw();
  request.terms.errorTolerance = this->ErrorTolerance;
  request.terms.storeError = this->StoreError;
  request.terms.automatic = this->AutomaticTerms;
  request.terms.changeTolerance = this->TermTolerance;
  request.terms.edges = this->EdgeCorrection;
  request.terms.tilt = this->MaximumTilt;
  return this->Relaxations.fillSeries(request.relaxation.series);
}

void vtkResponseFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "StoreError: " << this->StoreError << "\n";
  os << indent << "LayerThickness: " << this->LayerThickness << " mm\n";
  os << indent << "EdgeCorrection: " << this->EdgeCorrection << "\n";
  os << indent << "MaximumTilt: " << this->MaximumTilt << " degrees\n";
  os << indent << "Relaxations: " << this->Relaxations.count() << "\n";
  os << indent << "AutomaticTerms: " << this->AutomaticTerms << "\n";
  os << indent << "TermTolerance: " << this->TermTolerance << "\n";
  os << indent << "TermReason: " << this->TermReason << "\n";
}

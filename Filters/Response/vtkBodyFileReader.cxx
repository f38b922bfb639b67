// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBodyFileReader.h"

#include "Response/Files/BodyData.h"

#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkRectilinearGrid.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"

vtkStandardNewMacro(vtkBodyFileReader);

//------------------------------------------------------------------------------
vtkBodyFileReader::vtkBodyFileReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkBodyFileReader::~vtkBodyFileReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
std::string vtkBodyFileReader::GetFileExtensions()
{
  return palpate::bodyFileExtensions();
}

//------------------------------------------------------------------------------
std::string vtkBodyFileReader::GetNote(int index)
{
  return index >= 0 && index < this->GetNumberOfNotes()
    ? this->Notes[static_cast<std::size_t>(index)]
    : "";
}

//------------------------------------------------------------------------------
int vtkBodyFileReader::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkBodyFileReader::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  if (this->ReadTime < this->GetMTime())
  {
    const palpate::BodyData read = palpate::readBodyData(this->FileName ? this->FileName : "");
    this->Fault = read.fault;
    this->Notes = read.notes;
    this->Content = read.data;
    this->ReadTime.Modified();
    if (!this->Content)
    {
      vtkErrorMacro(<< (this->FileName ? this->FileName : "") << ": " << this->Fault << ".");
    }
  }
  if (!this->Content)
  {
    return 0;
  }
  vtkInformation* info = output->GetInformationObject(0);
  vtkDataObject* made = info->Get(vtkDataObject::DATA_OBJECT());
  if (!made || !made->IsA(this->Content->GetClassName()))
  {
    info->Set(vtkDataObject::DATA_OBJECT(),
      vtkSmartPointer<vtkDataSet>::Take(this->Content->NewInstance()));
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkBodyFileReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  vtkInformation* info = output->GetInformationObject(0);
  const auto passExtent = [info](auto* grid)
  { info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), grid->GetExtent(), 6); };
  if (auto* image = vtkImageData::SafeDownCast(this->Content))
  {
    passExtent(image);
    info->Set(vtkDataObject::ORIGIN(), image->GetOrigin(), 3);
    info->Set(vtkDataObject::SPACING(), image->GetSpacing(), 3);
    info->Set(vtkDataObject::DIRECTION(), image->GetDirectionMatrix()->GetData(), 9);
  }
  else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(this->Content))
  {
    passExtent(rectilinear);
  }
  else if (auto* structured = vtkStructuredGrid::SafeDownCast(this->Content))
  {
    passExtent(structured);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkBodyFileReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  vtkDataObject::GetData(output)->ShallowCopy(this->Content);
  return 1;
}

//------------------------------------------------------------------------------
void vtkBodyFileReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}

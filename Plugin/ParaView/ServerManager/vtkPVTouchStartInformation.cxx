// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVTouchStartInformation.h"

#include "Response/Touch/TouchStart.h"

#include "vtkAlgorithm.h"
#include "vtkClientServerStream.h"
#include "vtkMultiProcessStream.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkPVTouchStartInformation);

vtkPVTouchStartInformation::vtkPVTouchStartInformation()
  : View(std::make_unique<palpate::Sight>())
{
}

vtkPVTouchStartInformation::~vtkPVTouchStartInformation() = default;

void vtkPVTouchStartInformation::Ask(
  int port, const std::string& responseName, const palpate::Sight& sight)
{
  this->Port = port;
  this->ResponseName = responseName;
  *this->View = sight;
}

void vtkPVTouchStartInformation::CopyFromObject(vtkObject* source)
{
  auto* algorithm = vtkAlgorithm::SafeDownCast(source);
  auto* body = algorithm && this->Port < algorithm->GetNumberOfOutputPorts()
    ? vtkPolyData::SafeDownCast(algorithm->GetOutputDataObject(this->Port))
    : nullptr;
  const palpate::TouchedPlace place =
    palpate::findTouchStart(body, this->ResponseName, *this->View);
  this->Found = place.cell >= 0;
  std::copy_n(place.point.data(), 3, this->Start);
}

void vtkPVTouchStartInformation::AddInformation(vtkPVInformation* other)
{
  auto* rank = vtkPVTouchStartInformation::SafeDownCast(other);
  if (!this->Found && rank && rank->Found)
  {
    this->Found = true;
    std::copy_n(rank->Start, 3, this->Start);
  }
}

void vtkPVTouchStartInformation::CopyToStream(vtkClientServerStream* stream)
{
  stream->Reset();
  *stream << vtkClientServerStream::Reply << static_cast<int>(this->Found) << this->Start[0]
          << this->Start[1] << this->Start[2] << vtkClientServerStream::End;
}

void vtkPVTouchStartInformation::CopyFromStream(const vtkClientServerStream* stream)
{
  int found = 0;
  double start[3];
  const bool isWhole = stream->GetArgument(0, 0, &found) && stream->GetArgument(0, 1, &start[0]) &&
    stream->GetArgument(0, 2, &start[1]) && stream->GetArgument(0, 3, &start[2]);
  this->Found = isWhole && found != 0;
  if (this->Found)
  {
    std::copy_n(start, 3, this->Start);
  }
}

void vtkPVTouchStartInformation::CopyParametersToStream(vtkMultiProcessStream& stream)
{
  stream << this->Port << this->ResponseName << static_cast<int>(this->View->isNear)
         << this->View->halfWidth << this->View->halfHeight;
  for (const palpate::Vector3* vector : { &this->View->towards, &this->View->up, &this->View->eye })
  {
    stream << vector->x() << vector->y() << vector->z();
  }
}

void vtkPVTouchStartInformation::CopyParametersFromStream(vtkMultiProcessStream& stream)
{
  int isNear = 0;
  stream >> this->Port >> this->ResponseName >> isNear >> this->View->halfWidth >>
    this->View->halfHeight;
  this->View->isNear = isNear != 0;
  for (palpate::Vector3* vector : { &this->View->towards, &this->View->up, &this->View->eye })
  {
    stream >> vector->x() >> vector->y() >> vector->z();
  }
}

void vtkPVTouchStartInformation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Found: " << this->Found << "\n";
  os << indent << "Start: " << this->Start[0] << ", " << this->Start[1] << ", " << this->Start[2]
     << " mm\n";
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/DentMapper.h"

#include "Interaction/Display/DeflectionShader.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkScalarsToColors.h"

#include <algorithm>

namespace palpate
{
vtkStandardNewMacro(DentMapper);

DentMapper::DentMapper()
{
  this->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
}

void DentMapper::setDent(const double deepest[3], double around)
{
  std::copy_n(deepest, 3, this->Deepest);
  this->Around = around;
}

void DentMapper::ComputeBounds()
{
  this->Superclass::ComputeBounds();
  if (this->Around >= 0.0 && vtkBoundingBox(this->Bounds).IsValid())
  {
    vtkBoundingBox box(this->Bounds);
    box.Inflate(this->Around);
    box.AddPoint(this->Deepest);
    box.GetBounds(this->Bounds);
  }
}

void DentMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  this->updateColors();
  DeflectionShader::setColors(
    actor->GetShaderProperty(), this->Coordinates[0], this->Coordinates[1], this->Coordinates[2]);
  this->Superclass::RenderPiece(renderer, actor);
}

// The mapper makes a texture of the lookup table. Where a value lies in it the mapper alone knows,
// and it is asked about the ends of the range.
void DentMapper::updateColors()
{
  vtkScalarsToColors* colors = this->GetLookupTable();
  if (colors->GetMTime() == this->ColorsTime)
  {
    return;
  }
  const double* range = colors->GetRange();
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> ends;
  for (int i = 0; i < 2; ++i)
  {
    points->InsertNextPoint(i, 0.0, 0.0);
    ends->InsertNextValue(static_cast<float>(range[i]));
  }
  vtkNew<vtkPolyData> two;
  two->SetPoints(points);
  two->GetPointData()->SetScalars(ends);
  vtkNew<vtkPolyDataMapper> asked;
  asked->SetInputData(two);
  asked->SetLookupTable(colors);
  asked->UseLookupTableScalarRangeOn();
  asked->InterpolateScalarsBeforeMappingOn();
  asked->MapScalars(two, 1.0);
  vtkFloatArray* found = asked->GetColorCoordinates();
  if (found && range[1] > range[0])
  {
    const float low = found->GetTypedComponent(0, 0);
    const float perLength =
      (found->GetTypedComponent(1, 0) - low) / static_cast<float>(range[1] - range[0]);
    this->Coordinates[0] = low - perLength * static_cast<float>(range[0]);
    this->Coordinates[1] = perLength;
    this->Coordinates[2] = found->GetTypedComponent(0, 1);
  }
  this->ColorsTime = colors->GetMTime();
}
} // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Panel/PixelBox.h"

#include "vtkCellArray.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"

namespace palpate
{
PixelBox::PixelBox()
{
  this->Corners->SetNumberOfPoints(4);
  vtkNew<vtkCellArray> face;
  face->InsertNextCell({ 0, 1, 2, 3 });
  this->Area->SetPoints(this->Corners);
  this->Area->SetPolys(face);
  vtkNew<vtkCellArray> loop;
  loop->InsertNextCell({ 0, 1, 2, 3, 0 });
  this->Line->SetPoints(this->Corners);
  this->Line->SetLines(loop);
  vtkNew<vtkPolyDataMapper2D> areaMapper;
  areaMapper->SetInputData(this->Area);
  this->Fill->SetMapper(areaMapper);
  vtkNew<vtkPolyDataMapper2D> lineMapper;
  lineMapper->SetInputData(this->Line);
  this->Outline->SetMapper(lineMapper);
  this->place(0.0, 0.0, 0.0, 0.0);
}

void PixelBox::place(double left, double bottom, double width, double height)
{
  this->Left = left;
  this->Bottom = bottom;
  this->Width = width;
  this->Height = height;
  this->Corners->SetPoint(0, left, bottom, 0.0);
  this->Corners->SetPoint(1, left + width, bottom, 0.0);
  this->Corners->SetPoint(2, left + width, bottom + height, 0.0);
  this->Corners->SetPoint(3, left, bottom + height, 0.0);
  this->Corners->Modified();
  this->Area->Modified();
  this->Line->Modified();
}

void PixelBox::setColors(const Color& fill, const Color& outline)
{
  this->Fill->GetProperty()->SetColor(fill[0], fill[1], fill[2]);
  this->Outline->GetProperty()->SetColor(outline[0], outline[1], outline[2]);
}

void PixelBox::setOpacity(double opacity)
{
  this->Fill->GetProperty()->SetOpacity(opacity);
}

bool PixelBox::contains(double x, double y) const
{
  return x >= this->Left && x <= this->Left + this->Width && y >= this->Bottom &&
    y <= this->Bottom + this->Height;
}
} // namespace palpate

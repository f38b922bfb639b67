// SPDX-License-Identifier: BSD-3-Clause
#ifndef PixelBox_h
#define PixelBox_h

#include "Interaction/Display/DisplayColors.h"

#include "vtkActor2D.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace palpate
{
/// A filled rectangle with an outline, in pixels of a viewport.
class PixelBox
{
public:
  PixelBox();
  PixelBox(const PixelBox&) = delete;
  PixelBox& operator=(const PixelBox&) = delete;

  void place(double left, double bottom, double width, double height);
  void setColors(const Color& fill, const Color& outline);
  void setOpacity(double opacity);

  bool contains(double x, double y) const;
  double left() const { return this->Left; }
  double bottom() const { return this->Bottom; }
  double width() const { return this->Width; }
  double height() const { return this->Height; }

  vtkActor2D* fill() { return this->Fill; }
  vtkActor2D* outline() { return this->Outline; }

private:
  vtkNew<vtkPoints> Corners;
  vtkNew<vtkPolyData> Area;
  vtkNew<vtkPolyData> Line;
  vtkNew<vtkActor2D> Fill;
  vtkNew<vtkActor2D> Outline;
  double Left = 0.0;
  double Bottom = 0.0;
  double Width = 0.0;
  double Height = 0.0;
};
} // namespace palpate

#endif

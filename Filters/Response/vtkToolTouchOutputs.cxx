// SPDX-License-Identifier: BSD-3-Clause
// Creation of the outputs of vtkToolTouch: dents, tools and arrows.
#include "vtkToolTouch.h"

#include "Response/Touch/ContactArrow.h"
#include "Response/Touch/DentedBody.h"
#include "Response/BodyField.h"
#include "Response/Pieces/ChosenTip.h"
#include "Response/Pieces/Ranks.h"
#include "Response/Touch/ToolSurface.h"
#include "Response/Touch/TouchText.h"
#include "vtkContactTool.h"

#include "vtkAppendPolyData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <functional>
#include <vector>

namespace
{
constexpr double ToolShare = 0.25;
constexpr double ArrowThickness = 0.012;
// Radius at which a tool that widens without end is cut, as a fraction of its drawn length.
constexpr double WidestTool = 0.25;

/// Adds an array with one number or one vector per touch.
void addField(vtkPolyData* to, const char* name, const std::vector<palpate::Touch>& touches,
  int components, const std::function<const double*(const palpate::Touch&)>& valuesOf)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  for (const palpate::Touch& touch : touches)
  {
    array->InsertNextTuple(valuesOf(touch));
  }
  to->GetFieldData()->AddArray(array);
}

/// Appends all pieces, with their normals and point arrays.
void appendTo(vtkPolyData* output, const std::vector<vtkSmartPointer<vtkPolyData>>& pieces)
{
  if (pieces.size() == 1)
  {
    output->ShallowCopy(pieces.front());
    return;
  }
  vtkNew<vtkAppendPolyData> append;
  for (const auto& piece : pieces)
  {
    append->AddInputData(piece);
  }
  append->Update();
  output->ShallowCopy(append->GetOutput());
}
} // namespace

bool vtkToolTouch::MakeDent(const std::vector<palpate::Touch>& touches, vtkPolyData* output)
{
  std::vector<palpate::Dent> dents;
  for (std::size_t i = 0; i < touches.size(); ++i)
  {
    const palpate::Touch& touch = touches[i];
    const double radius =
      // Contact radius, mm.
      touch.touches() ? this->Tool->GetContactRadius(touch.contact.deflection) : 0.0;
    palpate::ChosenTip tip;
    palpate::chooseTip(palpate::Ranks(), this->Probed, static_cast<vtkIdType>(i), tip);
    if (touch.sunk != 0.0)
    {
      tip.contact.depth = touch.contact.deflection + touch.sunk;
    }
    palpate::Dent dent{ vtkSmartPointer<vtkFloatArray>::New(), touch.contact.normal };
    palpate::BodyField& field = i == 0 ? *this->Field : *this->SecondField;
    const std::string fault = field.displace(palpate::Ranks(), this->Body, tip.contact, 0,
      { this->Tool->GetKernel(), this->ResponseName,
        { this->PoissonRatio, std::isfinite(radius) ? this->Reach * radius : 0.0 } },
      dent.displacement);
    if (this->Fail(fault))
    {
      return false;
    }
    for (const std::string& warning : field.warnings())
    {
      vtkWarningMacro(<< warning << ".");
    }
    dents.push_back(dent);
  }
  output->ShallowCopy(this->Body);
  palpate::dentBody(output, dents);
  return true;
}

bool vtkToolTouch::MakeTools(const std::vector<palpate::Touch>& touches, vtkPolyData* output)
{
  const double length =
    this->ToolLength > 0.0 ? this->ToolLength : ToolShare * this->Body->GetLength();
  std::vector<vtkSmartPointer<vtkPolyData>> tools;
  for (const palpate::Touch& touch : touches)
  {
    auto tool = vtkSmartPointer<vtkPolyData>::New();
    if (this->Fail(palpate::makeToolSurface(
          *this->Tool->GetKernel(), { length, WidestTool * length }, tool)))
    {
      return false;
    }
    palpate::standTool(touch.tip, touch.contact.normal, tool);
    tools.push_back(tool);
  }
  appendTo(output, tools);
  return true;
}

void vtkToolTouch::MakeArrows(const std::vector<palpate::Touch>& touches, vtkPolyData* output)
{
  std::vector<vtkSmartPointer<vtkPolyData>> arrows;
  for (const palpate::Touch& touch : touches)
  {
    const auto arrow = palpate::makeContactArrow(
      touch.tip, touch.scale * touch.contact.force, ArrowThickness * this->Body->GetLength());
    vtkNew<vtkDoubleArray> force;
    force->SetName("Force");
    force->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < arrow->GetNumberOfPoints(); ++i)
    {
      force->InsertNextTuple(touch.contact.force.data());
    }
    arrow->GetPointData()->AddArray(force);
    arrows.push_back(arrow);
  }
  appendTo(output, arrows);
  vtkPointData* probed = this->Probed->GetPointData();
  for (int i = 0; i < probed->GetNumberOfArrays(); ++i)
  {
    output->GetFieldData()->AddArray(probed->GetArray(i));
  }
  using palpate::Touch;
  addField(output, "TipPosition", touches, 3, [](const Touch& touch) { return touch.tip.data(); });
  addField(output, "Stiffness", touches, 1, [](const Touch& touch) { return &touch.stiffness; });
  addField(output, "Validity", touches, 1,
    [](const Touch& touch)
    {
      static constexpr double endless = HUGE_VAL;
      return touch.validity.known ? &touch.validity.depth : &endless;
    });
  addField(
    output, "RelativeError", touches, 1, [](const Touch& touch) { return &touch.validity.error; });
  addField(output, "ForceScale", touches, 1, [](const Touch& touch) { return &touch.scale; });
}

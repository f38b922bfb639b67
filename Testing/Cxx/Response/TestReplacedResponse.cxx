// SPDX-License-Identifier: BSD-3-Clause
// A response replaces an older response of the same name completely: no array of a term, of another
// form or of a text remains, and the force is that of a body without the older response.
#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkFieldData.h"
#include "vtkReducedContactResponse.h"
#include "vtkResponseChoice.h"
#include "vtkToolContactProbe.h"

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace
{
using namespace palpate::testing;

constexpr double Half = 20.0; // half side of the block, mm

std::set<std::string> namesOf(vtkPolyData* body)
{
  std::set<std::string> names;
  for (vtkFieldData* data :
    { static_cast<vtkFieldData*>(body->GetPointData()), body->GetFieldData() })
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      const std::string name = data->GetArrayName(i);
      if (name.rfind("Response", 0) == 0)
      {
        names.insert(name);
      }
    }
  }
  return names;
}

/// The force on a tip that is pressed 0.5 mm deep, 1.5 mm from an edge of the block.
double forceNearEdge(vtkPolyData* body)
{
  vtkNew<vtkPolyData> tips;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(Half - 1.5, 0.3, Half - 0.5);
  tips->SetPoints(points);
  vtkNew<vtkToolContactProbe> probe;
  probe->SetInputData(body);
  probe->SetTipData(tips);
  probe->Update();
  return probe->GetOutput()->GetPointData()->GetArray("NormalForce")->GetTuple1(0);
}

vtkSmartPointer<vtkToolContactResponse> plainOf(vtkPolyData* body)
{
  auto filter = filterOf(body, "sphere:5", 1.0);
  filter->SetCurvatureCorrection(false);
  filter->StoreErrorOff();
  return filter;
}

void checkReplaced(vtkPolyData* older, const std::set<std::string>& names, double force)
{
  PALPATE_CHECK(namesOf(older) != names); // the older response has more arrays
  const auto again = plainOf(older);
  again->Update();
  PALPATE_CHECK(namesOf(again->GetOutput()) == names);
  PALPATE_CHECK(forceNearEdge(again->GetOutput()) == force);
}
} // namespace

int TestReplacedResponse(int, char*[])
{
  const Body block = boxBody(Half, Half, Half, 8);
  const auto fresh = plainOf(block);
  fresh->Update();
  const std::set<std::string> names = namesOf(fresh->GetOutput());
  const double force = forceNearEdge(fresh->GetOutput());
  // Hertz's paraboloid with E* = 0.1/(1 - 0.45²); at a tenth of its radius a sphere has 2 % less
  // force.
  PALPATE_CHECK_NEAR(force / (4.0 / 3.0 * 0.1 / 0.7975 * std::sqrt(5.0 * 0.125)), 1.0, 0.02);

  using Filter = vtkToolContactResponse;
  const std::vector<std::function<void(Filter*)>> terms = {
    [](Filter* filter) { filter->StoreErrorOn(); },
    [](Filter* filter) { filter->EdgeCorrectionOn(); },
    [](Filter* filter) { filter->SetMaximumTilt(10.0); },
    [](Filter* filter) { filter->AddRelaxation(0.5, 0.1); },
    [](Filter* filter) { filter->CouplingOn(); },
    [](Filter* filter) { filter->SetLayerThickness(15.0); },
    [](Filter* filter)
    {
      filter->SetLayerThickness(15.0);
      filter->AddLayer(10.0, 0.2, 0.4);
    },
    [](Filter* filter) { filter->AutomaticTermsOn(); },
  };
  const auto all = plainOf(block);
  for (const auto& add : terms)
  {
    const auto older = plainOf(block);
    add(older);
    add(all);
    older->Update();
    checkReplaced(older->GetOutput(), names, force);
  }
  all->Update();
  checkReplaced(all->GetOutput(), names, force);

  vtkNew<vtkReducedContactResponse> reduced;
  reduced->SetInputConnection(all->GetOutputPort());
  reduced->Update();
  checkReplaced(reduced->GetOutput(), names, force);
  vtkNew<vtkResponseChoice> chosen;
  chosen->SetInputConnection(all->GetOutputPort());
  chosen->SetTolerance(0.05);
  chosen->Update();
  checkReplaced(chosen->GetOutput(), names, force);
  return result();
}

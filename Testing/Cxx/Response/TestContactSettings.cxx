// SPDX-License-Identifier: BSD-3-Clause
// The object that holds the contact settings: defaults, table, fault messages, and filters that
// share it.
#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkContactSettings.h"
#include "vtkTable.h"
#include "vtkToolContactProbe.h"
#include "vtkToolTouch.h"

#include <cmath>
#include <sstream>

namespace
{
using namespace palpate::testing;

/// A slide along x, 0.5 mm deep in the plane z = 0.
Body slide()
{
  auto tips = Body::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(8);
  for (int i = 0; i < 8; ++i)
  {
    line->InsertCellPoint(points->InsertNextPoint(0.3 + 0.4 * i, 0.1, i == 0 ? 0.5 : -0.5));
  }
  tips->SetPoints(points);
  tips->SetLines(line);
  return tips;
}

double lastFriction(vtkToolContactProbe* probe)
{
  probe->Update();
  double friction[3];
  probe->GetOutput()->GetPointData()->GetArray("FrictionForce")->GetTuple(7, friction);
  return vtkMath::Norm(friction);
}

void checkModifiedTime()
{
  vtkNew<vtkContactSettings> settings;
  vtkMTimeType time = settings->GetMTime();
  const auto changed = [&]
  {
    const vtkMTimeType before = time;
    time = settings->GetMTime();
    return time > before;
  };
  settings->SetForceForm(vtkContactSettings::NormalizedDirection); // the value that is already set
  settings->SetContactSurface(vtkContactSettings::Facets);
  settings->SetFrictionModel(vtkContactSettings::ElastoPlastic);
  settings->SetFrictionCoefficient(0.0);
  settings->SetTangentialStiffness(1.0);
  settings->SetFrictionBreakaway(0.8);
  settings->SetFrictionStickRadius(0.9);
  settings->SetPoissonRatio(0.5);
  PALPATE_CHECK(!changed());
  settings->SetForceForm(vtkContactSettings::Paper);
  PALPATE_CHECK(changed() && settings->GetForceForm() == vtkContactSettings::Paper);
  settings->SetContactSurface(vtkContactSettings::Smooth);
  PALPATE_CHECK(changed() && settings->GetContactSurface() == vtkContactSettings::Smooth);
  settings->SetFrictionModel(vtkContactSettings::Dahl);
  PALPATE_CHECK(changed() && settings->GetFrictionModel() == vtkContactSettings::Dahl);
  settings->SetFrictionCoefficient(0.1);
  PALPATE_CHECK(changed() && settings->GetFrictionCoefficient() == 0.1);
  settings->SetTangentialStiffness(2.0);
  PALPATE_CHECK(changed() && settings->GetTangentialStiffness() == 2.0);
  settings->SetFrictionBreakaway(0.3);
  PALPATE_CHECK(changed() && settings->GetFrictionBreakaway() == 0.3);
  settings->SetFrictionStickRadius(0.4);
  PALPATE_CHECK(changed() && settings->GetFrictionStickRadius() == 0.4);
  settings->SetPoissonRatio(0.45);
  PALPATE_CHECK(changed() && settings->GetPoissonRatio() == 0.45);
  std::ostringstream text;
  settings->Print(text);
  PALPATE_CHECK_TEXT(text.str(), "TangentialStiffness: 2 N/mm", "FrictionModel: 1");
}

void checkFaults()
{
  vtkNew<vtkContactSettings> settings;
  PALPATE_CHECK(settings->GetFault().empty());
  settings->SetFrictionCoefficient(-1.0);
  PALPATE_CHECK(
    settings->GetFault() == "Friction Coefficient must be finite and not negative, but is -1");
  settings->SetFrictionCoefficient(std::nan(""));
  PALPATE_CHECK_TEXT(settings->GetFault(), "Friction Coefficient", "nan");
  settings->SetFrictionCoefficient(0.2);
  settings->SetFrictionModel(3);
  PALPATE_CHECK_TEXT(settings->GetFault(), "Friction Model", "2 (ShapeDerived)", "but is 3");
  settings->SetFrictionModel(0);
  settings->SetFrictionStickRadius(0.5); // invalid until the breakaway is set
  PALPATE_CHECK_TEXT(settings->GetFault(), "Friction Stick Radius", "breakaway", "0.5");
  settings->SetFrictionBreakaway(0.4);
  PALPATE_CHECK(settings->GetFault().empty());
}

void checkTable()
{
  vtkNew<vtkTable> table;
  vtkContactSettings::GetTable(table);
  vtkContactSettings::GetTable(table); // clears the previous content
  PALPATE_CHECK(table->GetNumberOfRows() == 9 && table->GetNumberOfColumns() == 8);
  const auto text = [&](int row, const char* column)
  { return table->GetValueByName(row, column).ToString(); };
  const auto number = [&](int row, const char* column)
  { return table->GetValueByName(row, column).ToDouble(); };
  PALPATE_CHECK(text(0, "Name") == "ForceForm" && number(0, "Default") == 1.0);
  PALPATE_CHECK(text(0, "Values") == "Paper NormalizedDirection EnergyConsistent");
  PALPATE_CHECK(text(4, "Name") == "TangentialStiffness" && text(4, "Unit") == "N/mm");
  PALPATE_CHECK(number(4, "Minimum") == 0.0 && number(4, "IncludesMinimum") == 0.0);
  PALPATE_CHECK(std::isinf(number(4, "Maximum")) && text(4, "Values").empty());
  PALPATE_CHECK_TEXT(text(7, "Help"), "of the body");
  PALPATE_CHECK(text(8, "Name") == "RelaxationElements" && number(8, "Default") == 16.0);
  PALPATE_CHECK(number(8, "Minimum") == 0.0 && number(8, "Maximum") == 32.0);
}

/// Two probes and a touch share one object, so a setting changed at one applies to all.
void checkSharing()
{
  const Body body = withResponse(planeBody(5.0, 10), "flat:1");
  vtkNew<vtkToolContactProbe> first;
  vtkNew<vtkToolContactProbe> second;
  vtkNew<vtkToolTouch> touch;
  touch->SetInputData(body);
  for (vtkToolContactProbe* probe : { first.Get(), second.Get() })
  {
    probe->SetInputData(body);
    probe->SetTipData(slide());
    PALPATE_CHECK(lastFriction(probe) == 0.0);
  }
  touch->Update();
  PALPATE_CHECK(first->GetSettings() != second->GetSettings());
  second->SetSettings(first->GetSettings());
  touch->SetSettings(first->GetSettings());
  PALPATE_CHECK(touch->GetSettings() == first->GetSettings());
  const vtkMTimeType touched = touch->GetMTime();
  first->SetFrictionCoefficient(0.3);
  PALPATE_CHECK(second->GetFrictionCoefficient() == 0.3);
  PALPATE_CHECK(touch->GetMTime() > touched);
  PALPATE_CHECK(lastFriction(first) > 0.5 && lastFriction(second) == lastFriction(first));

  Messages messages(second);
  Messages touching(touch);
  first->GetSettings()->SetFrictionBreakaway(2.0);
  second->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Friction Breakaway must lie between 0 and 1", "is 2");
  touch->Update();
  PALPATE_CHECK_TEXT(touching.takeErrors(), "Friction Breakaway must lie between 0 and 1", "is 2");
  second->SetSettings(nullptr); // the probe has its own settings again
  PALPATE_CHECK(second->GetSettings() && second->GetSettings() != first->GetSettings());
  PALPATE_CHECK(lastFriction(second) == 0.0 && messages.none());
}
} // namespace

int TestContactSettings(int, char*[])
{
  checkModifiedTime();
  checkFaults();
  checkTable();
  checkSharing();
  return palpate::testing::result();
}

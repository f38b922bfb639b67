// SPDX-License-Identifier: BSD-3-Clause
// The probe's settings: the defaults are those of the kernel, and errors name property, range and
// value. Also the times of trajectories.
#include "FilterChecks.h"
#include "Contact/ContactSettings.h"
#include "TestBodies.h"

#include "vtkStringArray.h"
#include "vtkToolContactProbe.h"
#include "Mechanics/Numerics/Constants.h"

#include <functional>

namespace
{
using namespace palpate::testing;
using palpate::Infinity;
using palpate::NotANumber;

/// A polyline of `count` tips from above a plate into the plate, with `Time` in steps of 0.1 s.
Body pressingLine(int count)
{
  auto tips = Body::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(count);
  for (int i = 0; i < count; ++i)
  {
    line->InsertCellPoint(points->InsertNextPoint(0.3, 0.1, 0.4 - 0.1 * i));
  }
  tips->SetPoints(points);
  tips->SetLines(line);
  pointArray(tips, "Time", [](vtkIdType i) { return 0.1 * static_cast<double>(i); });
  return tips;
}

void checkDefaults()
{
  vtkNew<vtkToolContactProbe> probe;
  const palpate::ContactSettings kernel;
  PALPATE_CHECK(probe->GetForceForm() == static_cast<int>(kernel.form));
  PALPATE_CHECK(probe->GetContactSurface() == static_cast<int>(kernel.surface));
  PALPATE_CHECK(probe->GetFrictionModel() == static_cast<int>(kernel.friction.model));
  PALPATE_CHECK(probe->GetFrictionCoefficient() == kernel.friction.coefficient);
  PALPATE_CHECK(probe->GetTangentialStiffness() == kernel.friction.tangentialStiffness);
  PALPATE_CHECK(probe->GetFrictionBreakaway() == kernel.friction.breakaway);
  PALPATE_CHECK(probe->GetFrictionStickRadius() == kernel.friction.stickRadius);
  PALPATE_CHECK(probe->GetPoissonRatio() == kernel.friction.poissonRatio);
  PALPATE_CHECK(probe->GetRelaxationElements() == kernel.relaxationElements);
}

void checkNames()
{
  vtkNew<vtkToolContactProbe> probe;
  probe->SetForceFormToPaper();
  PALPATE_CHECK(probe->GetForceForm() == static_cast<int>(palpate::ForceForm::Paper));
  probe->SetForceFormToNormalizedDirection();
  PALPATE_CHECK(probe->GetForceForm() == static_cast<int>(palpate::ForceForm::NormalizedDirection));
  probe->SetForceFormToEnergyConsistent();
  PALPATE_CHECK(probe->GetForceForm() == static_cast<int>(palpate::ForceForm::EnergyConsistent));
  probe->SetContactSurfaceToSmooth();
  PALPATE_CHECK(probe->GetContactSurface() == static_cast<int>(palpate::ContactSurface::Smooth));
  probe->SetContactSurfaceToFacets();
  PALPATE_CHECK(probe->GetContactSurface() == static_cast<int>(palpate::ContactSurface::Facets));
  probe->SetFrictionModelToDahl();
  PALPATE_CHECK(probe->GetFrictionModel() == static_cast<int>(palpate::FrictionModel::Dahl));
  probe->SetFrictionModelToShapeDerived();
  PALPATE_CHECK(
    probe->GetFrictionModel() == static_cast<int>(palpate::FrictionModel::ShapeDerived));
  probe->SetFrictionModelToElastoPlastic();
  PALPATE_CHECK(
    probe->GetFrictionModel() == static_cast<int>(palpate::FrictionModel::ElastoPlastic));
}

struct WrongSetting
{
  const char* name;
  const char* range;
  const char* value;
  std::function<void(vtkToolContactProbe*)> set;
};

/// Each invalid value causes exactly one error. Each limit itself is accepted.
void checkWrongSettings()
{
  using Probe = vtkToolContactProbe*;
  const std::vector<WrongSetting> wrong = {
    { "Force Form", "0 (Paper)", "3", [](Probe p) { p->SetForceForm(3); } },
    { "Force Form", "2 (EnergyConsistent)", "-1", [](Probe p) { p->SetForceForm(-1); } },
    { "Contact Surface", "1 (Smooth)", "2", [](Probe p) { p->SetContactSurface(2); } },
    { "Friction Model", "2 (ShapeDerived)", "256", [](Probe p) { p->SetFrictionModel(256); } },
    { "Friction Coefficient", "not negative", "-0.5",
      [](Probe p) { p->SetFrictionCoefficient(-0.5); } },
    { "Friction Coefficient", "finite", "nan",
      [](Probe p) { p->SetFrictionCoefficient(NotANumber); } },
    { "Friction Coefficient", "finite", "inf",
      [](Probe p) { p->SetFrictionCoefficient(Infinity); } },
    { "Tangential Stiffness", "positive", "0", [](Probe p) { p->SetTangentialStiffness(0.0); } },
    { "Tangential Stiffness", "N/mm", "nan",
      [](Probe p) { p->SetTangentialStiffness(NotANumber); } },
    { "Friction Breakaway", "between 0 and 1", "1.5",
      [](Probe p) { p->SetFrictionBreakaway(1.5); } },
    { "Friction Stick Radius", "breakaway", "0.5",
      [](Probe p) { p->SetFrictionStickRadius(0.5); } },
    { "Poisson's Ratio", "between 0 and 0.5", "0.6", [](Probe p) { p->SetPoissonRatio(0.6); } },
    { "Poisson's Ratio", "between 0 and 0.5", "nan",
      [](Probe p) { p->SetPoissonRatio(NotANumber); } },
  };
  const Body body = withResponse(planeBody(5.0, 4), "flat:1");
  for (const WrongSetting& setting : wrong)
  {
    vtkNew<vtkToolContactProbe> probe;
    probe->SetInputData(body);
    probe->SetTipData(pressingLine(6));
    Messages messages(probe);
    probe->Update();
    PALPATE_CHECK(messages.none() && probe->GetOutput()->GetNumberOfPoints() == 6);
    setting.set(probe);
    probe->Update();
    PALPATE_CHECK_TEXT(messages.takeErrors(), setting.name, setting.range, setting.value);
    PALPATE_CHECK(probe->GetOutput()->GetNumberOfPoints() == 0);
  }
}

void checkTimes()
{
  const Body body = withResponse(planeBody(5.0, 4), "flat:1");
  vtkNew<vtkToolContactProbe> probe;
  probe->SetInputData(body);
  Messages messages(probe);
  const auto update = [&](vtkPolyData* tips)
  {
    probe->SetTipData(tips);
    probe->Update();
    return messages.takeErrors();
  };
  const Body tips = pressingLine(8);
  vtkDataArray* time = tips->GetPointData()->GetArray("Time");
  PALPATE_CHECK(update(tips).empty());
  // the array is passed on
  PALPATE_CHECK(probe->GetOutput()->GetPointData()->GetArray("Time") == time);
  time->SetTuple1(4, time->GetTuple1(3)); // two tips at the same time
  PALPATE_CHECK(update(tips).empty());
  time->SetTuple1(4, 0.25);
  tips->Modified();
  PALPATE_CHECK_TEXT(update(tips), "'Time'", "0.25 at point 4", "0.3 at point 3", "polyline 0");
  PALPATE_CHECK(probe->GetOutput()->GetNumberOfPoints() == 0);
  for (const double wrong : { NotANumber, Infinity })
  {
    time->SetTuple1(4, 0.4);
    time->SetTuple1(7, wrong);
    tips->Modified();
    PALPATE_CHECK_TEXT(
      update(tips), "'Time'", std::isnan(wrong) ? "nan" : "inf", "at point 7", "polyline 0");
  }
  // Times of points outside polylines have no effect. Two polylines have separate times.
  const Body loose = pressingLine(6);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ vtkIdType(3), vtkIdType(4) });
  lines->InsertNextCell({ vtkIdType(0), vtkIdType(1) });
  loose->SetLines(lines);
  loose->GetPointData()->GetArray("Time")->SetTuple1(5, NotANumber);
  PALPATE_CHECK(update(loose).empty());
  loose->GetPointData()->GetArray("Time")->SetTuple1(0, 0.2);
  loose->Modified();
  PALPATE_CHECK_TEXT(update(loose), "'Time'", "0.1 at point 1", "0.2 at point 0", "polyline 1");

  const Body named = pressingLine(4);
  vtkNew<vtkStringArray> words;
  words->SetName("Time");
  words->SetNumberOfValues(4);
  named->GetPointData()->AddArray(words);
  PALPATE_CHECK_TEXT(update(named), "'Time'", "one number per point");
  const Body vectors = pressingLine(4);
  vtkNew<vtkDoubleArray> triples;
  triples->SetName("Time");
  triples->SetNumberOfComponents(3);
  triples->SetNumberOfTuples(4);
  triples->Fill(0.0);
  vectors->GetPointData()->AddArray(triples);
  PALPATE_CHECK_TEXT(update(vectors), "'Time'", "one number per point");
}
} // namespace

int TestProbeSettings(int, char*[])
{
  checkDefaults();
  checkNames();
  checkWrongSettings();
  checkTimes();
  return palpate::testing::result();
}

// SPDX-License-Identifier: BSD-3-Clause
// Responses are made from body, tools, material and model, immediately or in the background, and
// passed to a running session. The forces are compared with closed forms.
#include "PlacedDevice.h"

#include "vtkContactSetup.h"
#include "vtkContactSettings.h"
#include "vtkHapticSession.h"

#include <chrono>
#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

namespace
{
using namespace palpate::testing;

constexpr double Modulus = 0.3; // MPa
constexpr double Poisson = 0.4;
constexpr double Reduced = Modulus / (1.0 - Poisson * Poisson);
constexpr double Stored = 1e-6; // relative; responses are stored as floats

/// Returns the force of a response at a point, at the end of its range, 2 mm.
double deepest(vtkContactSetup* setup, int tool)
{
  vtkDataArray* force =
    setup->GetOutput()->GetPointData()->GetArray((setup->GetResponseName(tool) + "Force").c_str());
  return force->GetComponent(60, force->GetNumberOfComponents() - 1);
}

vtkSmartPointer<vtkContactSetup> makeSetup(vtkPolyData* body)
{
  auto setup = vtkSmartPointer<vtkContactSetup>::New();
  setup->SetBody(body);
  setup->AddTool(makeTool("sphere:5"));
  setup->AddTool(makeTool("flat:1"));
  setup->SetYoungsModulus(Modulus);
  setup->SetPoissonRatio(Poisson);
  return setup;
}

/// Waits for the request. Returns true if it has succeeded, false after an error.
bool collected(vtkContactSetup* setup)
{
  bool taken = setup->Collect();
  while (!taken && setup->IsBusy())
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    taken = setup->Collect();
  }
  return taken || setup->Collect();
}

void checkNow()
{
  const Body body = planeBody(10.0, 10);
  const auto setup = makeSetup(body);
  PALPATE_CHECK(setup->GetOutput() == nullptr && setup->GetLargestForce() == 0.0);
  PALPATE_CHECK(setup->Update());
  const auto sphere = makeTool("sphere:5");
  PALPATE_CHECK_NEAR(deepest(setup, 0) / sphere->GetForce(2.0, Reduced), 1.0, Stored);
  PALPATE_CHECK_NEAR(deepest(setup, 1) / (2.0 * Reduced * 2.0), 1.0, Stored);
  PALPATE_CHECK_NEAR(setup->GetLargestForce() / sphere->GetForce(2.0, Reduced), 1.0, Stored);
  PALPATE_CHECK(body->GetPointData()->GetNumberOfArrays() == 0); // the body is not modified
  PALPATE_CHECK(setup->GetOutput()->GetPoints() == body->GetPoints());
  PALPATE_CHECK(setup->GetToolInHand()->GetSize() == 5.0);
  setup->SetChosenTool(1);
  setup->GetToolInHand()->SetSize(1.5);
  PALPATE_CHECK(setup->Update());
  PALPATE_CHECK_NEAR(deepest(setup, 1) / (2.0 * 1.5 * Reduced * 2.0), 1.0, Stored);
  setup->SetChosenTool(7);
  PALPATE_CHECK(setup->GetChosenTool() == 1);
  setup->RemoveAllTools();
  PALPATE_CHECK(setup->GetToolInHand() == nullptr);
}

/// Of several requests, only the newest has a result. Each result is collected once.
void checkInTheBackground()
{
  const auto setup = makeSetup(planeBody(20.0, 150));
  PALPATE_CHECK(setup->Update());
  vtkPolyData* before = setup->GetOutput();
  setup->Request();
  PALPATE_CHECK(!setup->IsBusy()); // nothing has changed
  for (const double factor : { 5.0, 4.0, 3.0, 2.0 })
  {
    setup->SetYoungsModulus(factor * Modulus);
    setup->Request();
    PALPATE_CHECK(setup->GetOutput() == before);
  }
  PALPATE_CHECK(collected(setup));
  PALPATE_CHECK(setup->GetOutput() != before);
  PALPATE_CHECK_NEAR(deepest(setup, 1) / (2.0 * 2.0 * Reduced * 2.0), 1.0, Stored);
  PALPATE_CHECK(!setup->Collect() && !setup->IsBusy());
  // A tool that is changed in place is a change. A request during another request is also possible.
  setup->GetTool(1)->SetRadius(3.0);
  setup->Request();
  setup->SetYoungsModulus(Modulus);
  PALPATE_CHECK(setup->Update()); // replaces the request
  PALPATE_CHECK(!collected(setup));
  PALPATE_CHECK_NEAR(deepest(setup, 1) / (2.0 * 3.0 * Reduced * 2.0), 1.0, Stored);
}

/// Progress increases to 1. A cancelled request does not change the output, and restores the
/// settings of the output.
void checkCancel()
{
  const auto setup = makeSetup(planeBody(20.0, 150));
  PALPATE_CHECK(setup->Update() && setup->GetProgress() == 1.0);
  vtkPolyData* before = setup->GetOutput();
  setup->SetPoissonRatio(0.2);
  setup->SetYoungsModulus(2.0 * Modulus);
  setup->AddRelaxation(0.5, 1.0);
  setup->GetTool(0)->SetRadius(4.0);
  setup->Request();
  PALPATE_CHECK(setup->IsBusy() && setup->GetProgress() < 1.0);
  setup->Cancel();
  PALPATE_CHECK(!setup->IsBusy() && setup->GetOutput() == before);
  PALPATE_CHECK(setup->GetPoissonRatio() == Poisson && setup->GetYoungsModulus() == Modulus);
  PALPATE_CHECK(setup->GetNumberOfRelaxations() == 0 && setup->GetTool(0)->GetRadius() == 5.0);
  setup->Request();
  PALPATE_CHECK(!setup->IsBusy() && !setup->Collect()); // the output is up to date
  setup->Cancel();                                      // no effect
  // Other changes are kept and used by the next request.
  setup->SetMaximumDeflection(1.5);
  setup->Request();
  setup->Cancel();
  setup->Request();
  PALPATE_CHECK(collected(setup));
  PALPATE_CHECK_NEAR(deepest(setup, 1) / (2.0 * Reduced * 1.5), 1.0, Stored);
  setup->SetMaximumDeflection(2.0);
  // Before the first output there are no settings to restore.
  const auto fresh = makeSetup(planeBody(20.0, 150));
  fresh->Request();
  fresh->Cancel();
  PALPATE_CHECK(fresh->GetYoungsModulus() == Modulus && fresh->GetPoissonRatio() == Poisson);
  fresh->Request();
  PALPATE_CHECK(collected(fresh));
  setup->SetPoissonRatio(0.2);
  setup->Request();
  PALPATE_CHECK(collected(setup) && setup->GetProgress() == 1.0);
  const double reduced = Modulus / (1.0 - 0.2 * 0.2);
  PALPATE_CHECK_NEAR(deepest(setup, 1) / (2.0 * reduced * 2.0), 1.0, Stored);
}

void checkErrors()
{
  vtkNew<vtkContactSetup> empty;
  Messages missing(empty);
  PALPATE_CHECK(!empty->Update());
  PALPATE_CHECK_TEXT(missing.takeErrors(), "body", "SetBody");

  const auto setup = makeSetup(planeBody(10.0, 10));
  Messages messages(setup);
  PALPATE_CHECK(setup->Update() && messages.none());
  vtkPolyData* before = setup->GetOutput();
  setup->SetYoungsModulus(-1.0);
  PALPATE_CHECK(!setup->Update());
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Young", "-1");
  setup->SetYoungsModulus(-2.0);
  setup->Request();
  PALPATE_CHECK(!collected(setup));
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Young", "-2");
  PALPATE_CHECK_TEXT(setup->GetError(), "Young", "-2");
  PALPATE_CHECK(setup->GetOutput() == before);
  setup->SetYoungsModulus(Modulus);
  setup->SetModel(vtkContactSetup::Series);
  PALPATE_CHECK(!setup->Update());
  PALPATE_CHECK_TEXT(messages.takeErrors(), "model 2");
  setup->SetModel(vtkContactSetup::HalfSpace);
  PALPATE_CHECK(setup->Update() && setup->GetError().empty());
}

void checkModels()
{
  const Body body = planeBody(10.0, 10);
  const auto setup = makeSetup(body);
  PALPATE_CHECK(setup->HasModel(vtkContactSetup::HalfSpace));
  PALPATE_CHECK(!setup->HasModel(vtkContactSetup::Layer));
  PALPATE_CHECK(!setup->HasModel(vtkContactSetup::Series));
  PALPATE_CHECK(!setup->HasModel(vtkContactSetup::Stored));
  const double halfSpace = 2.0 * Reduced * 2.0; // flat tool, 1 mm deep
  // A layer is stiffer than a half-space. For a thick layer the relative difference is a/h times a
  // number of order 1.
  setup->SetLayerThickness(1e4);
  setup->SetModel(vtkContactSetup::Layer);
  PALPATE_CHECK(setup->Update());
  PALPATE_CHECK_NEAR(deepest(setup, 1) / halfSpace, 1.0, 1e-3);
  setup->SetLayerThickness(2.0);
  PALPATE_CHECK(setup->Update());
  PALPATE_CHECK(deepest(setup, 1) > 1.3 * halfSpace);
  // A stack of equal layers has the same force as one layer of their total thickness. On an equal
  // half-space it has the force of the half-space.
  const double layer = deepest(setup, 1);
  setup->SetLayerThickness(0.7);
  setup->AddLayer(1.3, Modulus, Poisson);
  PALPATE_CHECK(setup->GetNumberOfAddedLayers() == 1);
  PALPATE_CHECK(setup->Update());
  PALPATE_CHECK_NEAR(deepest(setup, 1) / layer, 1.0, 1e-6);
  setup->SetLayerBase(2);
  setup->SetBaseYoungsModulus(Modulus);
  setup->SetBasePoissonRatio(Poisson);
  PALPATE_CHECK(setup->Update());
  PALPATE_CHECK_NEAR(deepest(setup, 1) / halfSpace, 1.0, 1e-5);
  setup->SetLayerBase(0);
  // The thicknesses differ from point to point, with a constant sum.
  const Body uneven = planeBody(10.0, 10);
  pointArray(uneven, "LayerThickness0", [](vtkIdType i) { return 0.7 + 0.01 * ((i - 60) % 11); });
  pointArray(uneven, "LayerThickness1", [](vtkIdType i) { return 1.3 - 0.01 * ((i - 60) % 11); });
  setup->SetBody(uneven);
  setup->SetLayerThickness(0.0);
  setup->ClearLayers();
  setup->AddLayer(0.0, Modulus, Poisson);
  PALPATE_CHECK(setup->HasModel(vtkContactSetup::Layer));
  PALPATE_CHECK(setup->Update());
  PALPATE_CHECK_NEAR(deepest(setup, 1) / layer, 1.0, 1e-4); // interpolated over both thicknesses
  setup->ClearLayers();
  setup->SetBody(body);
  // In series: 1/k = 1/(2 a E*) + C. The compliance C is given for the modulus ComplianceModulus.
  constexpr double compliance = 0.8;
  pointArray(body, "GlobalCompliance", [](vtkIdType) { return compliance; });
  setup->SetBody(body);
  setup->SetModel(vtkContactSetup::Series);
  setup->SetComplianceModulus(Modulus);
  PALPATE_CHECK(setup->Update());
  const double series = 2.0 / (1.0 / (2.0 * Reduced) + compliance);
  PALPATE_CHECK_NEAR(deepest(setup, 1) / series, 1.0, Stored);
  setup->SetYoungsModulus(3.0 * Modulus);
  PALPATE_CHECK(setup->Update());
  PALPATE_CHECK_NEAR(deepest(setup, 1) / (3.0 * series), 1.0, Stored);
  setup->SetComplianceModulus(0.0);
  PALPATE_CHECK(setup->Update());
  PALPATE_CHECK_NEAR(deepest(setup, 1) * (1.0 / (6.0 * Reduced) + compliance) / 2.0, 1.0, Stored);
  // Responses stored with the body are used unchanged.
  const auto stored = makeSetup(setup->GetOutput());
  stored->SetModel(vtkContactSetup::Stored);
  PALPATE_CHECK(!stored->HasModel(vtkContactSetup::HalfSpace) && stored->Update());
  PALPATE_CHECK(deepest(stored, 1) == deepest(setup, 1));
}

/// Returns the ideal force of the chosen tool, 1 mm deep in the setup's output.
double feltForce(vtkContactSetup* setup)
{
  vtkNew<vtkHapticSession> session;
  PALPATE_CHECK(setup->ApplyTo(session));
  pressed(session, deviceOf(1e3, 1e6));
  return idealOf(session);
}

/// A session that has the body before its start uses the kernels of the setup. These have the
/// chosen form, whose force differs from the force of the full curves within the tolerance.
void checkKernelsAtStart()
{
  constexpr double tolerance = 0.05;
  const Body body = planeBody(10.0, 10);
  pointArray(body, "LayerThickness", [](vtkIdType i) { return 3.0 + 0.03 * i; });
  const auto setup = makeSetup(body);
  setup->SetModel(vtkContactSetup::Layer);
  setup->SetTolerance(tolerance);
  PALPATE_CHECK(setup->Update());
  const double chosen = feltForce(setup);
  vtkNew<vtkHapticSession> full;
  full->SetBody(setup->GetOutput());
  pressed(full, deviceOf(1e3, 1e6));
  const double exact = idealOf(full);
  PALPATE_CHECK(chosen != exact && std::abs(chosen / exact - 1.0) < tolerance);
  vtkNew<vtkHapticSession> session;
  session->SetBody(setup->GetOutput());
  PALPATE_CHECK(setup->ApplyTo(session));
  pressed(session, deviceOf(1e3, 1e6));
  PALPATE_CHECK(idealOf(session) == chosen);
}

/// Returns whether two outputs have the same arrays, up to the rounding of floats.
bool areEqual(vtkPolyData* one, vtkPolyData* other)
{
  const auto differs = [](vtkFieldData* a, vtkFieldData* b)
  {
    bool isDifferent = a->GetNumberOfArrays() != b->GetNumberOfArrays();
    for (int i = 0; !isDifferent && i < a->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* numbers = a->GetArray(i);
      vtkDataArray* same = numbers ? b->GetArray(numbers->GetName()) : nullptr;
      isDifferent = numbers && !same;
      // A stated error of 1 % is a difference of forces that are rounded to 1e-7.
      const std::string name = numbers ? numbers->GetName() : "";
      const double tolerance =
        name.size() > 5 && name.substr(name.size() - 5) == "Error" ? 1e-4 : Stored;
      for (vtkIdType k = 0; same && k < numbers->GetNumberOfValues(); ++k)
      {
        const vtkIdType tuple = k / numbers->GetNumberOfComponents();
        const int component = static_cast<int>(k % numbers->GetNumberOfComponents());
        const double value = numbers->GetComponent(tuple, component);
        isDifferent = isDifferent ||
          std::abs(same->GetComponent(tuple, component) - value) > tolerance * std::abs(value);
      }
    }
    return isDifferent;
  };
  return !differs(one->GetPointData(), other->GetPointData()) &&
    !differs(one->GetFieldData(), other->GetFieldData());
}

/// For another modulus, forces and compliances are scaled instead of computed again. The result
/// equals that of a new setup. A body with a second modulus is computed again.
void checkModulusChange()
{
  constexpr double factor = 2.7;
  const Body body = planeBody(10.0, 10);
  pointArray(body, "GlobalCompliance", [](vtkIdType i) { return 0.5 + 0.001 * i; });
  pointArray(body, "GlobalComplianceError", [](vtkIdType) { return 0.03; });
  pointArray(body, "LayerThickness", [](vtkIdType i) { return 4.0 + 0.01 * i; });
  struct Case
  {
    const char* name;
    std::function<void(vtkContactSetup*)> set;
    bool isScaled;
  };
  const auto layers = [](vtkContactSetup* setup) { setup->SetModel(vtkContactSetup::Layer); };
  const auto series = [](vtkContactSetup* setup)
  {
    setup->SetModel(vtkContactSetup::Series);
    setup->SetComplianceModulus(Modulus);
  };
  const std::vector<Case> cases = { { "half-space", [](vtkContactSetup*) {}, true },
    { "layer, chosen form",
      [&](vtkContactSetup* setup)
      {
        layers(setup);
        setup->SetTolerance(0.01);
      },
      true },
    { "series that relaxes",
      [&](vtkContactSetup* setup)
      {
        series(setup);
        setup->AddRelaxation(0.5, 0.1);
        setup->ComplianceRelaxesOff();
      },
      true },
    { "tilt, finite strain",
      [](vtkContactSetup* setup)
      {
        setup->SetMaximumTilt(10.0);
        setup->SetStrainModel(1);
      },
      true },
    { "layer on an elastic base",
      [&](vtkContactSetup* setup)
      {
        layers(setup);
        setup->SetLayerBase(2);
      },
      false },
    { "a compliance that stays",
      [&](vtkContactSetup* setup)
      {
        series(setup);
        setup->SetComplianceModulus(0.0);
      },
      false } };
  for (const Case& each : cases)
  {
    const auto make = [&]
    {
      auto setup = makeSetup(body);
      each.set(setup);
      return setup;
    };
    const auto setup = make();
    PALPATE_CHECK(setup->Update());
    const vtkSmartPointer<vtkPolyData> before = setup->GetOutput();
    setup->SetYoungsModulus(factor * Modulus);
    setup->Request();
    PALPATE_CHECK(collected(setup));
    const auto fresh = make();
    fresh->SetYoungsModulus(factor * Modulus);
    PALPATE_CHECK(fresh->Update());
    const bool isRight = areEqual(setup->GetOutput(), fresh->GetOutput()) &&
      std::abs(feltForce(setup) / feltForce(fresh) - 1.0) < Stored &&
      std::abs(setup->GetLargestForce() / fresh->GetLargestForce() - 1.0) < Stored &&
      setup->GetChoice(0) == fresh->GetChoice(0);
    // If the responses were scaled, arrays that do not depend on the modulus are the same objects.
    const auto rangeOf = [](vtkPolyData* output)
    { return output->GetPointData()->GetArray("ResponseRange"); };
    const bool isScaled = rangeOf(before) == rangeOf(setup->GetOutput());
    if (!isRight || isScaled != each.isScaled)
    {
      std::cerr << each.name << ": right " << isRight << ", scaled " << isScaled << "\n";
    }
    PALPATE_CHECK(isRight && isScaled == each.isScaled);
    // Another property changes. Then both properties return to their first values.
    setup->SetPoissonRatio(0.3);
    PALPATE_CHECK(setup->Update());
    PALPATE_CHECK(!areEqual(setup->GetOutput(), fresh->GetOutput()));
    setup->SetPoissonRatio(Poisson);
    setup->SetYoungsModulus(Modulus);
    PALPATE_CHECK(setup->Update() && areEqual(setup->GetOutput(), before));
  }
}

/// For another Poisson's ratio of a half-space, the forces are scaled immediately, and then errors
/// and validities are computed. The results equal those of a new setup. The forces of a layer are
/// not proportional, so they are computed.
void checkPoissonChange()
{
  constexpr double ratio = 0.2;
  struct Case
  {
    const char* name;
    std::function<void(vtkContactSetup*)> set;
    bool isScaled;
  };
  const std::vector<Case> cases = { { "half-space", [](vtkContactSetup*) {}, true },
    { "half-space that relaxes, chosen form",
      [](vtkContactSetup* setup)
      {
        setup->SetTolerance(0.01);
        setup->AddRelaxation(0.5, 0.1);
      },
      true },
    { "chosen terms, of which finite strain is one",
      [](vtkContactSetup* setup) { setup->AutomaticTermsOn(); }, false },
    { "finite strain", [](vtkContactSetup* setup) { setup->SetStrainModel(1); }, false },
    { "layer",
      [](vtkContactSetup* setup)
      {
        setup->SetModel(vtkContactSetup::Layer);
        setup->SetLayerThickness(4.0);
      },
      false } };
  const Body body = planeBody(10.0, 10);
  for (const Case& each : cases)
  {
    const auto make = [&]
    {
      auto setup = makeSetup(body);
      each.set(setup);
      return setup;
    };
    const auto setup = make();
    PALPATE_CHECK(setup->Update());
    setup->SetPoissonRatio(ratio);
    setup->SetYoungsModulus(2.0 * Modulus);
    setup->Request();
    PALPATE_CHECK(collected(setup));
    const double first = deepest(setup, 1);
    const double felt = feltForce(setup);
    const bool isTwice = collected(setup); // collects the errors and validities
    const auto fresh = make();
    fresh->SetPoissonRatio(ratio);
    fresh->SetYoungsModulus(2.0 * Modulus);
    PALPATE_CHECK(fresh->Update());
    const bool isRight = isTwice == each.isScaled &&
      std::abs(first / deepest(fresh, 1) - 1.0) < Stored &&
      std::abs(felt / feltForce(fresh) - 1.0) < Stored &&
      areEqual(setup->GetOutput(), fresh->GetOutput()) && !setup->IsBusy();
    if (!isRight)
    {
      std::cerr << each.name << " is not what it should be\n";
    }
    PALPATE_CHECK(isRight);
  }
  // After a cancelled completion, Poisson's ratio returns to the value whose errors are known.
  const auto setup = makeSetup(planeBody(20.0, 150));
  PALPATE_CHECK(setup->Update());
  setup->SetPoissonRatio(ratio);
  setup->Request();
  PALPATE_CHECK(collected(setup) && setup->IsBusy());
  setup->Cancel();
  PALPATE_CHECK(setup->GetPoissonRatio() == Poisson);
  setup->Request();
  PALPATE_CHECK(collected(setup) && !setup->IsBusy());
  PALPATE_CHECK_NEAR(deepest(setup, 1) / (2.0 * Reduced * 2.0), 1.0, Stored);
}

/// The force of a running session changes when new responses have been collected, and not before.
void checkSession()
{
  const auto setup = makeSetup(planeBody(10.0, 10));
  PALPATE_CHECK(setup->Update());
  vtkNew<vtkHapticSession> session;
  PALPATE_CHECK(setup->ApplyTo(session)); // the session does not run yet
  pressed(session, deviceOf(1e3, 1e6));
  const auto sphere = makeTool("sphere:5");
  const double force = sphere->GetForce(1.0, Reduced);
  // Interpolation of three curves of eight samples, 1 mm deep with a range of 2 mm: storage error
  // 2e-4.
  PALPATE_CHECK_NEAR(idealOf(session) / force, 1.0, 1e-3);
  setup->SetYoungsModulus(2.0 * Modulus);
  setup->Request();
  while (setup->IsBusy())
  {
    session->Step(0.01);
  }
  PALPATE_CHECK_NEAR(idealOf(session) / force, 1.0, 1e-3);
  PALPATE_CHECK(setup->Collect() && setup->ApplyTo(session));
  session->Step(0.1);
  PALPATE_CHECK_NEAR(idealOf(session) / force, 2.0, 2e-3);
  setup->SetChosenTool(1);
  PALPATE_CHECK(setup->ApplyTo(session));
  session->Step(0.1);
  PALPATE_CHECK_NEAR(idealOf(session) / (2.0 * 2.0 * Reduced), 1.0, 1e-5);
}

/// Without settings in the setup, every session keeps its own settings. With settings in the setup,
/// all sessions have these settings. No response is computed again for this.
void checkSettings()
{
  const auto setup = makeSetup(planeBody(10.0, 4));
  PALPATE_CHECK(setup->Update() && !setup->GetSettings());
  vtkNew<vtkHapticSession> one;
  vtkNew<vtkHapticSession> other;
  one->GetSettings()->SetFrictionCoefficient(0.2);
  PALPATE_CHECK(setup->ApplyTo(one) && setup->ApplyTo(other));
  PALPATE_CHECK(one->GetSettings()->GetFrictionCoefficient() == 0.2 &&
    other->GetSettings()->GetFrictionCoefficient() == 0.0);
  PALPATE_CHECK(one->GetSettings()->GetPoissonRatio() == setup->GetPoissonRatio());
  vtkNew<vtkContactSettings> settings;
  setup->SetSettings(settings);
  settings->SetFrictionCoefficient(0.3);
  setup->Request();
  PALPATE_CHECK(!setup->IsBusy());
  PALPATE_CHECK(setup->ApplyTo(one) && setup->ApplyTo(other));
  PALPATE_CHECK(one->GetSettings() == settings && other->GetSettings() == settings);
  PALPATE_CHECK(settings->GetPoissonRatio() == setup->GetPoissonRatio());
}

/// With a tolerance, the force comes from the simplest form within the tolerance, also for
/// responses made later. The output has the full responses.
void checkChoice()
{
  const auto plain = makeSetup(planeBody(10.0, 10));
  PALPATE_CHECK(plain->Update() && plain->GetChoice(0).empty());
  plain->SetTolerance(0.01);
  PALPATE_CHECK(plain->Update());
  PALPATE_CHECK_TEXT(plain->GetChoice(0), "one law suffices", "0 instead of 16");
  PALPATE_CHECK_TEXT(plain->GetChoice(1), "one law suffices");
  PALPATE_CHECK(plain->GetChoice(2).empty() && plain->GetChoice(-1).empty());
  PALPATE_CHECK(plain->GetOutput()->GetPointData()->HasArray("ResponseForce"));
  const auto sphere = makeTool("sphere:5");
  PALPATE_CHECK_NEAR(feltForce(plain) / sphere->GetForce(1.0, Reduced), 1.0, 1e-3);

  // One law for layers of 6 to 10 mm: its error is within the tolerance, but not zero.
  const Body uneven = planeBody(10.0, 10);
  pointArray(uneven, "LayerThickness", [](vtkIdType i) { return 6.0 + 0.5 * ((7 * i) % 9); });
  const auto layer = makeSetup(uneven);
  layer->SetModel(vtkContactSetup::Layer);
  PALPATE_CHECK(layer->Update());
  const double whole = feltForce(layer);
  constexpr double tolerance = 0.15;
  layer->SetTolerance(tolerance);
  layer->Request();
  PALPATE_CHECK(collected(layer));
  PALPATE_CHECK_TEXT(layer->GetChoice(0), "one law suffices");
  const double off = std::abs(feltForce(layer) / whole - 1.0);
  PALPATE_CHECK(off > 1e-3 && off < tolerance);

  // With a large global compliance, a point force suffices.
  const Body soft = planeBody(10.0, 10);
  pointArray(soft, "GlobalCompliance", [](vtkIdType) { return 100.0; });
  const auto series = makeSetup(soft);
  series->SetModel(vtkContactSetup::Series);
  series->SetTolerance(0.05);
  series->SetChoiceDeflection(1.0);
  PALPATE_CHECK(series->Update());
  PALPATE_CHECK_TEXT(series->GetChoice(1), "point force");
  series->SetChosenTool(1);
  PALPATE_CHECK_NEAR(feltForce(series) * (100.0 + 1.0 / (4.0 * Reduced)), 1.0, 0.05);
  series->SetChoiceDeflection(0.0); // the default is half of the range
  PALPATE_CHECK(series->Update());
  PALPATE_CHECK_TEXT(series->GetChoice(1), "point force");

  Messages messages(series);
  series->SetTolerance(std::nan(""));
  PALPATE_CHECK(!series->Update());
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Tolerance", "nan");
  PALPATE_CHECK_TEXT(series->GetChoice(1), "point force"); // the choice of the present output
}

/// The response of every tool has the relaxation. The relaxation does not change any curve.
void checkRelaxation()
{
  const auto setup = makeSetup(planeBody(10.0, 10));
  PALPATE_CHECK(setup->Update());
  const double slow = deepest(setup, 0);
  const auto timeOf = [&setup](int tool)
  {
    const std::string name = setup->GetResponseName(tool) + "RelaxationTime";
    return setup->GetOutput()->GetFieldData()->GetArray(name.c_str());
  };
  PALPATE_CHECK(timeOf(0) == nullptr);
  setup->AddRelaxation(0.5, 0.1);
  setup->AddRelaxation(0.3, 2.0);
  PALPATE_CHECK(setup->Update());
  for (int tool = 0; tool < 2; ++tool)
  {
    PALPATE_CHECK(timeOf(tool) && timeOf(tool)->GetNumberOfTuples() == 2);
    PALPATE_CHECK(timeOf(tool)->GetTuple1(1) == setup->GetRelaxationTime(1));
  }
  PALPATE_CHECK(deepest(setup, 0) == slow);
  // The sentence on the choice contains the number of elements.
  setup->SetTolerance(0.005);
  PALPATE_CHECK(setup->Update());
  PALPATE_CHECK_TEXT(setup->GetChoice(0), "The body relaxes, in 16 elements");
  PALPATE_CHECK_TEXT(setup->GetChoice(1), "quasi-linear suffices");
  setup->ClearRelaxations();
  setup->AddRelaxation(-1.0, 0.1);
  Messages messages(setup.Get());
  PALPATE_CHECK(!setup->Update());
  PALPATE_CHECK_TEXT(messages.takeErrors(), "strength of relaxation 1", "-1");
  PALPATE_CHECK(timeOf(0) != nullptr); // the output is unchanged
  setup->ClearRelaxations();
  PALPATE_CHECK(setup->Update() && timeOf(0) == nullptr);
}
} // namespace

int TestContactSetup(int, char*[])
{
  checkNow();
  checkInTheBackground();
  checkCancel();
  checkErrors();
  checkModels();
  checkModulusChange();
  checkPoissonChange();
  checkKernelsAtStart();
  checkSession();
  checkSettings();
  checkChoice();
  checkRelaxation();
  return palpate::testing::result();
}

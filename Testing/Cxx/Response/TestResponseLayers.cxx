// SPDX-License-Identifier: BSD-3-Clause
// Layers on a rigid base, point by point: against the exact solution of each layer (LayerContact,
// which the kernel tests compare with the reference tables), and against these tables.
#include "ContractOracle.h"
#include "FilterChecks.h"
#include "Mechanics/Layers/LayerContact.h"
#include "ReferenceTable.h"
#include "TestBodies.h"

#include "vtkDataObject.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <limits>

namespace
{
using namespace palpate::testing;
using palpate::LayerContact;
using palpate::LayerKernel;

constexpr double Young = 0.06;
constexpr int YoungIndex = 0;
constexpr int ThicknessIndex = 1;
constexpr int ComplianceIndex = 2;
constexpr int PoissonIndex = 3;
// Half a unit in the last place of a float, plus the 1e-7 that LayerTable guarantees.
constexpr double Stored = 1.7e-7;

using Filter = vtkSmartPointer<vtkToolContactResponse>;

Filter makeFilter(vtkPolyData* body, const std::string& tool, double poisson = 0.45)
{
  auto filter = Filter::New();
  filter->SetInputData(body);
  filter->SetTool(makeTool(tool));
  filter->SetYoungsModulus(Young);
  filter->SetPoissonRatio(poisson);
  makePlain(filter);
  return filter;
}

void useArray(vtkAlgorithm* filter, int index, const char* name)
{
  filter->SetInputArrayToProcess(index, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
}

vtkDataArray* output(vtkToolContactResponse* filter, const char* name)
{
  return filter->GetOutput()->GetPointData()->GetArray(name);
}

double thicknessOf(vtkIdType i)
{
  return i % 4 == 0 ? 0.0 : 1.0 + 0.37 * static_cast<double>(i); // 0: half-space
}

void expectCurve(vtkToolContactResponse* filter, vtkIdType i, const palpate::IndentationLaw& law,
  double reducedModulus)
{
  for (int k = 0; k < 8; ++k)
  {
    const auto exact = law.evaluate(2.0 * (k + 1) * (k + 1) / 64.0, reducedModulus);
    PALPATE_CHECK_NEAR(
      output(filter, "ResponseForce")->GetComponent(i, k), exact.force, Stored * exact.force);
    PALPATE_CHECK_NEAR(output(filter, "ResponseStiffness")->GetComponent(i, k), exact.stiffness,
      Stored * exact.stiffness);
  }
}

void checkVaryingThickness(const std::string& tool, palpate::LayerBase base)
{
  Body body = planeBody(10.0, 5);
  pointArray(body, "Scalp", thicknessOf);
  pointArray(body, "E", [](vtkIdType i) { return 0.01 + 0.002 * static_cast<double>(i); });
  Filter filter = makeFilter(body, tool);
  useArray(filter, ThicknessIndex, "Scalp");
  useArray(filter, YoungIndex, "E");
  filter->SetLayerBase(static_cast<int>(base));
  Messages messages(filter.Get());
  filter->Update();
  PALPATE_CHECK(messages.none());
  const auto kernel = std::make_shared<const LayerKernel>(0.45, base);
  const auto& pressed = *filter->GetTool()->GetKernel();
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    const double modulus = body->GetPointData()->GetArray("E")->GetTuple1(i) / (1.0 - 0.45 * 0.45);
    PALPATE_CHECK(output(filter, "ResponseStatus")->GetTuple1(i) == 0.0);
    PALPATE_CHECK_NEAR(
      output(filter, "ResponseLayerThickness")->GetTuple1(i), thicknessOf(i), 1e-6);
    if (thicknessOf(i) > 0.0)
    {
      expectCurve(filter, i, LayerContact(pressed, kernel, thicknessOf(i)), modulus);
    }
    else
    {
      expectCurve(filter, i, pressed, modulus);
    }
  }
  auto* model = vtkStringArray::SafeDownCast(
    filter->GetOutput()->GetFieldData()->GetAbstractArray("ResponseModel"));
  PALPATE_CHECK_TEXT(
    model->GetValue(0), "layer", "varying", base == palpate::LayerBase::Slip ? "slip" : "bonded");
  PALPATE_CHECK(filter->GetOutput()->GetFieldData()->GetArray("ResponseLayerBase")->GetTuple1(0) ==
    static_cast<double>(base));
}

/// The liver slab of the reference tables: h = 10 mm, with paraboloids for spheres.
void checkLiverSlab()
{
  const ReferenceTable table("liver_slab_h10.csv");
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const double nu = table.number(row, "nu");
    const double depth = table.number(row, "delta_mm");
    Body body = planeBody(10.0, 1);
    Filter filter = makeFilter(body, "paraboloid:" + table.text(row, "R_mm"), nu);
    filter->SetLayerThickness(10.0);
    filter->SetMaximumDeflection(depth);
    filter->Update();
    const double halfSpace = filter->GetTool()->GetForce(depth, Young / (1.0 - nu * nu));
    const double expected = halfSpace * table.number(row, "F/F_Hertz");
    PALPATE_CHECK_NEAR(
      output(filter, "ResponseForce")->GetComponent(3, 7), expected, Stored * expected);
  }
}

/// Poisson's ratio per point affects the law of the layer, not only E*.
void checkVaryingPoisson(bool few)
{
  Body body = planeBody(10.0, 9);
  const auto poisson = [few](vtkIdType i)
  { return few ? 0.1 * static_cast<double>(i % 5) : 0.004 * static_cast<double>(i); };
  pointArray(body, "nu", poisson);
  Filter filter = makeFilter(body, "sphere:6.35");
  useArray(filter, PoissonIndex, "nu");
  filter->SetLayerThickness(5.0);
  filter->Update();
  const auto& pressed = *filter->GetTool()->GetKernel();
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); i += 3)
  {
    const auto kernel = std::make_shared<const LayerKernel>(poisson(i), palpate::LayerBase::Bonded);
    expectCurve(
      filter, i, LayerContact(pressed, kernel, 5.0), Young / (1.0 - poisson(i) * poisson(i)));
  }
}

/// A layer and a compliance cannot be used together, unless the compliance is declared not to
/// contain the base.
void checkSeries()
{
  const double compliances[] = { 0.0, 0.3, 3.0, -0.02 };
  Body body = planeBody(10.0, 4);
  pointArray(body, "Scalp", thicknessOf);
  pointArray(body, "C", [&](vtkIdType i) { return compliances[i % 3 + (i % 7 == 6 ? 1 : 0)]; });
  Filter filter = makeFilter(body, "sphere:6.35");
  useArray(filter, ThicknessIndex, "Scalp");
  useArray(filter, ComplianceIndex, "C");
  Messages messages(filter.Get());
  filter->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "'Scalp'", "'C'", "Compliance Excludes Layer");
  PALPATE_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);

  filter->ComplianceExcludesLayerOn();
  filter->Update();
  PALPATE_CHECK(messages.none());
  const auto kernel = std::make_shared<const LayerKernel>(0.45, palpate::LayerBase::Bonded);
  const auto& pressed = *filter->GetTool()->GetKernel();
  const double modulus = Young / (1.0 - 0.45 * 0.45);
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    const double c = body->GetPointData()->GetArray("C")->GetTuple1(i);
    const LayerContact layer(pressed, kernel, std::max(1.0, thicknessOf(i)));
    const palpate::IndentationLaw& law =
      thicknessOf(i) > 0.0 ? layer : static_cast<const palpate::IndentationLaw&>(pressed);
    for (int k = 0; k < 8; ++k)
    {
      const double depth = 2.0 * (k + 1) * (k + 1) / 64.0;
      double low = 0.0; // bisection for x + C F(x) = δ
      double high = 2.0 * depth;
      for (int step = 0; step < 60; ++step)
      {
        const double middle = 0.5 * (low + high);
        (middle + c * law.evaluate(middle, modulus).force < depth ? low : high) = middle;
      }
      const double force = law.evaluate(low, modulus).force;
      // With 64 samples the local part of the series is accurate to 2e-6.
      PALPATE_CHECK_NEAR(output(filter, "ResponseForce")->GetComponent(i, k), force, 2e-6 * force);
    }
  }
  auto* model = vtkStringArray::SafeDownCast(
    filter->GetOutput()->GetFieldData()->GetAbstractArray("ResponseModel"));
  PALPATE_CHECK_TEXT(model->GetValue(0), "layer", "series", "compliance");
}

/// A point whose layer is too thin for the range has no curve and is counted in one warning.
void checkTooThin()
{
  Body body = planeBody(10.0, 2);
  pointArray(body, "h", [](vtkIdType i) { return i == 4 ? 0.1 : 3.0; });
  Filter filter = makeFilter(body, "flat:2"); // a/h = 20 at point 4
  useArray(filter, ThicknessIndex, "h");
  Messages messages(filter.Get());
  filter->Update();
  PALPATE_CHECK(messages.errors().empty());
  PALPATE_CHECK_TEXT(messages.warnings(), "1 of 9 points", "ResponseStatus");
  for (vtkIdType i = 0; i < 9; ++i)
  {
    PALPATE_CHECK(output(filter, "ResponseStatus")->GetTuple1(i) == (i == 4 ? 4.0 : 0.0));
    PALPATE_CHECK((output(filter, "ResponseForce")->GetComponent(i, 7) > 0.0) == (i != 4));
  }
}

void checkErrors()
{
  Body body = planeBody(10.0, 2);
  for (const double wrong : { -1.0, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    pointArray(body, "h", [wrong](vtkIdType i) { return i == 5 ? wrong : 3.0; });
    Filter filter = makeFilter(body, "sphere:5");
    useArray(filter, ThicknessIndex, "h");
    Messages messages(filter.Get());
    filter->Update();
    PALPATE_CHECK_TEXT(messages.takeErrors(), "'h'", "layer thickness", "point 5");
    PALPATE_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
    useArray(filter, ThicknessIndex, "");
    filter->SetLayerThickness(wrong);
    filter->Update();
    PALPATE_CHECK_TEXT(messages.takeErrors(), "Layer Thickness");
    filter->SetLayerThickness(4.0);
    filter->Update();
    PALPATE_CHECK(messages.none());
  }
}

/// Limit 3: 20 % of the thickness. The strain limit, a contact radius of 0.4 R, is reached at a
/// smaller depth than on a half-space.
void checkValidity()
{
  Body body = planeBody(10.0, 2);
  const auto expect = [&](
                        const char* tool, double thickness, double depth, int limit, double within)
  {
    Filter filter = makeFilter(body, tool);
    filter->SetLayerThickness(thickness);
    filter->Update();
    PALPATE_CHECK_NEAR(output(filter, "ResponseValidity")->GetTuple1(4), depth, within);
    PALPATE_CHECK(output(filter, "ResponseLimit")->GetTuple1(4) == limit);
  };
  expect("flat:6", 3.0, 0.6, 3, 1e-6);
  expect("paraboloid:30", 5.0, 1.0, 3, 1e-6);
  const auto pressed = makeTool("paraboloid:3");
  const LayerContact contact(*pressed->GetKernel(),
    std::make_shared<const LayerKernel>(0.45, palpate::LayerBase::Bonded), 4.0);
  const double strained = contact.depthAtContactRadius(0.4 * 3.0);
  PALPATE_CHECK(strained < 0.48 && strained > 0.35);
  expect("paraboloid:3", 4.0, strained, 1, 0.005 * strained); // interpolated between samples
  expect("cone:60", 50.0, 0.0, 1, 0.0);
  expect("flat:1.6", 50.0, 0.64, 1, 1e-6);
}

/// Storage error of eight samples for a layer. The reference sheet states 5e-4 on 1..100 % of the
/// depth. At depths before the first sample the measured error is larger: 6e-4 while a < h; at a/h
/// = 2.7 it is 1.4 % in the first per cent and 0.4 % up to a seventh of the depth.
void checkStorage()
{
  for (const char* tool : { "flat:2", "paraboloid:6.35", "sphere:6.35", "cone:60" })
  {
    for (const double thickness : { 1.5, 4.0, 20.0 })
    {
      Body body = planeBody(10.0, 1);
      Filter filter = makeFilter(body, tool, 0.49);
      filter->SetLayerThickness(thickness);
      filter->Update();
      const ContractOracle oracle(filter->GetOutput());
      const LayerContact contact(*filter->GetTool()->GetKernel(),
        std::make_shared<const LayerKernel>(0.49, palpate::LayerBase::Bonded), thickness);
      for (int i = 1; i <= 100; ++i)
      {
        const double exact = contact.evaluate(0.02 * i, Young / (1.0 - 0.49 * 0.49)).force;
        const double bound = thickness < 20.0 ? (i == 1       ? 0.014
                                                    : i <= 15 ? 4e-3
                                                              : 5e-4)
                                              : (i == 1 ? 7e-4 : 5e-4);
        PALPATE_CHECK_NEAR(oracle.force(0, 0.02 * i) / exact, 1.0, bound);
      }
    }
  }
}
} // namespace

int TestResponseLayers(int, char*[])
{
  for (const char* tool : { "flat:1.6", "paraboloid:6.35", "sphere:6.35", "cone:75" })
  {
    checkVaryingThickness(tool, palpate::LayerBase::Bonded);
    checkVaryingThickness(tool, palpate::LayerBase::Slip);
  }
  checkLiverSlab();
  checkVaryingPoisson(true);
  checkVaryingPoisson(false);
  checkSeries();
  checkTooThin();
  checkErrors();
  checkValidity();
  checkStorage();
  return palpate::testing::result();
}

// SPDX-License-Identifier: BSD-3-Clause
// The displacement field of a body with layers is that of a layer with the thickness at the
// contact.
#include "FilterChecks.h"
#include "Mechanics/Layers/LayerContact.h"
#include "Mechanics/Layers/LayerSurface.h"
#include "ProbedTips.h"

#include "vtkDataObject.h"
#include "vtkToolContactProbe.h"

namespace
{
using namespace palpate::testing;

constexpr double Depth = 0.8;

struct Touched
{
  vtkNew<vtkToolContactResponse> response;
  vtkNew<vtkToolContactProbe> probe;
  vtkSmartPointer<vtkContactDeflection> field;
};

/// A plane with layers of the given thickness, pressed at (0.13, -0.21).
void touch(Touched& touched, const char* tool, int base, double (*thickness)(double x))
{
  Body body = planeBody(8.0, 32);
  pointArray(body, "h", [&](vtkIdType i) { return thickness(body->GetPoint(i)[0]); });
  touched.response->SetInputData(body);
  touched.response->SetTool(makeTool(tool));
  touched.response->SetPoissonRatio(Poisson);
  touched.response->SetLayerBase(base);
  touched.response->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "h");
  Body tip = Body::New();
  tip->SetPoints(vtkNew<vtkPoints>());
  tip->GetPoints()->SetDataTypeToDouble();
  tip->GetPoints()->InsertNextPoint(0.13, -0.21, -Depth);
  touched.probe->SetInputConnection(touched.response->GetOutputPort());
  touched.probe->SetTipData(tip);
  touched.field = makeFilter(nullptr, nullptr, nullptr);
  touched.field->SetInputConnection(touched.response->GetOutputPort());
  touched.field->SetTipConnection(touched.probe->GetOutputPort());
  touched.field->Update();
}

void expectLayer(
  const Touched& touched, double thickness, palpate::LayerBase base, double tolerance)
{
  const palpate::LayerContact contact(*touched.response->GetTool()->GetKernel(),
    std::make_shared<const palpate::LayerKernel>(Poisson, base), thickness);
  const palpate::LayerSurface surface(contact, Depth);
  vtkPolyData* body = touched.field->GetOutput();
  bool bulges = false;
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    const double x = body->GetPoint(i)[0] - 0.13;
    const double y = body->GetPoint(i)[1] + 0.21;
    const double r = std::hypot(x, y);
    const auto u = surface.at(r);
    const auto found = displacement(touched.field, i);
    PALPATE_CHECK_NEAR(found[0], u.radial * x / r, tolerance);
    PALPATE_CHECK_NEAR(found[1], u.radial * y / r, tolerance);
    PALPATE_CHECK_NEAR(found[2], -u.normal, tolerance);
    bulges = bulges || found[2] > 1e-3;
  }
  PALPATE_CHECK(bulges); // a half-space never bulges
}

void checkThickness()
{
  Touched touched;
  touch(touched, "sphere:5", 0, [](double) { return 3.0; });
  // tolerance: stored as floats
  expectLayer(touched, 3.0, palpate::LayerBase::Bonded, 2e-7 * Depth);
  Touched slipping;
  touch(slipping, "blunted:2,60", 1, [](double) { return 4.0; });
  const auto kernel =
    std::make_shared<const palpate::LayerKernel>(Poisson, palpate::LayerBase::Slip);
  const palpate::LayerContact contact(*slipping.response->GetTool()->GetKernel(), kernel, 4.0);
  const palpate::LayerSurface surface(contact, Depth);
  const double r = std::hypot(slipping.field->GetOutput()->GetPoint(0)[0] - 0.13,
    slipping.field->GetOutput()->GetPoint(0)[1] + 0.21);
  PALPATE_CHECK_NEAR(displacement(slipping.field, 0)[2], -surface.at(r).normal, 2e-7 * Depth);
}

/// 1/h is interpolated linearly over the triangle of the contact, which is exact for h = 1/(0.3 +
/// 0.02 x).
void checkVaryingThickness()
{
  Touched touched;
  touch(touched, "sphere:5", 0, [](double x) { return 1.0 / (0.3 + 0.02 * x); });
  // The thickness is stored as floats, and its inverse is computed from them.
  expectLayer(touched, 1.0 / (0.3 + 0.02 * 0.13), palpate::LayerBase::Bonded, 2e-6 * Depth);
}

void checkHalfSpaceAmongLayers()
{
  Touched touched;
  touch(touched, "sphere:5", 0, [](double x) { return x < 4.0 ? 0.0 : 3.0; });
  const auto tool = makeTool("sphere:5");
  double u[2];
  tool->GetSurfaceDisplacement(std::hypot(-8.0 - 0.13, -8.0 + 0.21), Depth, Poisson, u);
  PALPATE_CHECK_NEAR(displacement(touched.field, 0)[2], -u[1], 1e-7);
}

void checkTooThin()
{
  Touched touched;
  touch(touched, "flat:2", 0, [](double) { return 3.0; });
  vtkNew<vtkPolyData> body;
  body->DeepCopy(touched.response->GetOutput());
  body->GetPointData()->GetArray("ResponseLayerThickness")->Fill(0.1);
  touched.field->SetInputData(body);
  Messages messages(touched.field.Get());
  touched.field->Update();
  PALPATE_CHECK_TEXT(messages.warnings(), "layer of 0.1 mm");
  PALPATE_CHECK(isZero(displacement(touched.field, 0)));
}
} // namespace

int TestDeflectionLayers(int, char*[])
{
  checkThickness();
  checkVaryingThickness();
  checkHalfSpaceAmongLayers();
  checkTooThin();
  return palpate::testing::result();
}

// SPDX-License-Identifier: BSD-3-Clause
// The dent of the vertex shader compared with that of vtkContactDeflection, pixel by pixel:
// position of the surface, colour, light, and picked cells.
#include "TwoPaths.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkSignedCharArray.h"
#include "vtkStringArray.h"
#include "Response/BodyConversion.h"
#include "Response/BodyField.h"
#include "vtkHapticSession.h"
#include "vtkToolContactResponse.h"

#include <string>

namespace
{
using namespace palpate::testing;
using palpate::Vector3;

constexpr double Depth = 1.2;
constexpr double Exaggeration = 2.0;

/// Tolerance of the position, as a fraction of the deflection: the error of the shader's table
/// (DeflectionTable.h), and twice this error for the displacement along the surface on slopes up to
/// 2.
constexpr double Surface = 2e-3;
/// Tolerance of a colour, of 255. 1e-3 of the deflection is a quarter of a step of the legend's 256
/// colours. The next colour differs by up to 3.
constexpr double Color = 4.0;
/// Tolerance of the light, of 255. The filter weights the facets around a point by area; the shader
/// uses the slope over two edges. They agree to second order in the edge length. 0.05 rad is 13.
constexpr double Light = 13.0;

struct Case
{
  std::string tool;
  Body body;
  Vector3 contact;
  double poisson = 0.0; // ν = 0 has the largest radial displacement
  double edge = 0.0; ///< for a tool with a sharp rim: fraction of the pixels whose light may differ
};

vtkSmartPointer<vtkContactScene> makeScene(const Case& tried, vtkPolyData* tip)
{
  auto scene = vtkSmartPointer<vtkContactScene>::New();
  scene->SetBody(tried.body);
  scene->SetTool(makeTool(tried.tool));
  scene->SetPoissonRatio(tried.poisson);
  scene->SetLargestDeflection(Depth);
  scene->SetExaggeration(Exaggeration);
  scene->ShowTip(tip, 0);
  return scene;
}

Body pressed(const Case& tried)
{
  const Vector3 tip = tried.contact - Depth * tried.contact.normalized();
  return probed(tried.body, singleTip(tip.x(), tip.y(), tip.z()));
}

void checkCase(const Case& tried)
{
  const int before = palpate::testing::failures();
  const Body tip = pressed(tried);
  auto scene = makeScene(tried, tip);
  for (const Vector3& aside : { Vector3(0.0, 0.0, 0.0), Vector3(0.8, -0.3, 0.0) })
  {
    TwoPaths paths(scene, tried.contact, tried.contact.normalized() + aside, 9.0);
    const Deviation depth(paths.depths(true), paths.depths(false), Surface * Exaggeration * Depth);
    const Deviation color(paths.colors(true, false), paths.colors(false, false), Color);
    const Deviation light(paths.colors(true, true), paths.colors(false, true), Light);
    const Deviation cells(paths.cells(true), paths.cells(false));
    std::cout << tried.tool << " on " << tried.body->GetNumberOfCells() << " triangles: surface "
              << depth.largest << " mm (" << depth.share << "), colour " << color.largest << " ("
              << color.share << "), light " << light.largest << " (" << light.share << "), cells "
              << cells.share << std::endl;
    // At silhouettes and at the edges of facets, a pixel may show another facet.
    PALPATE_CHECK(depth.share < 0.002);
    PALPATE_CHECK(color.share < 0.002);
    PALPATE_CHECK(light.share <= 0.005 + tried.edge);
    PALPATE_CHECK(cells.share < 0.01);
    // The difference would be much larger without displacement, or without the change of normals.
    auto flat = makeScene(tried, tip);
    flat->SetExaggeration(0.0);
    TwoPaths still(flat, tried.contact, tried.contact.normalized() + aside, 9.0);
    PALPATE_CHECK(
      Deviation(paths.depths(true), still.depths(true)).largest > 0.5 * Exaggeration * Depth);
    PALPATE_CHECK(
      Deviation(paths.colors(true, true), still.colors(true, true), Light).share > 0.05);
  }
  if (palpate::testing::failures() > before)
  {
    std::cerr << "in the case " << tried.tool << std::endl;
  }
}

Body lifted(const Body& body, double height)
{
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    double x[3];
    body->GetPoint(i, x);
    x[2] += height;
    body->GetPoints()->SetPoint(i, x);
  }
  return body;
}

/// A plane above the origin, with points 0.4 mm apart.
Body plane(const std::string& tool)
{
  return withResponse(lifted(planeBody(24.0, 120), 50.0), tool);
}

Body layered(const std::string& tool, double thickness)
{
  const Body body = lifted(planeBody(24.0, 120), 50.0);
  vtkNew<vtkToolContactResponse> response;
  response->SetInputData(body);
  response->SetTool(makeTool(tool));
  makePlain(response);
  response->SetPoissonRatio(0.45);
  response->SetLayerThickness(thickness);
  response->Update();
  return response->GetOutput();
}

/// A response in series with the largest number of modes: the plane tilts and bends under the tool.
Body bending(const std::string& tool)
{
  const Body body = lifted(planeBody(24.0, 120), 50.0);
  vtkNew<vtkSignedCharArray> signs;
  signs->SetName("GlobalModeSign");
  for (int k = 0; k < 6; ++k)
  {
    vtkNew<vtkFloatArray> mode;
    mode->SetName(("GlobalMode" + std::to_string(k)).c_str());
    mode->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
    {
      const double* x = body->GetPoint(i);
      const double height = 0.2 / (k + 1) * std::cos(0.3 * x[0] + 0.2 * k) * std::cos(0.07 * x[1]);
      mode->InsertNextTuple3(0.001 * k * x[1], 0.01, height);
    }
    body->GetPointData()->AddArray(mode);
    signs->InsertNextValue(k == 1 ? -1 : 1);
  }
  pointArray(body, "GlobalCompliance", [](vtkIdType) { return 0.03; });
  vtkNew<vtkToolContactResponse> response;
  response->SetInputData(body);
  response->SetTool(makeTool(tool));
  makePlain(response);
  // MPa; about 8 N: the modes give a deflection of 0.3 mm and turn normals by 0.2 rad
  response->SetYoungsModulus(2.0);
  response->SetInputArrayToProcess(
    2, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "GlobalCompliance");
  response->Update();
  const Body result = response->GetOutput();
  result->GetFieldData()->AddArray(signs);
  return result;
}
/// A body with a response of its true shape, near an edge: the near field tilts and bends the
/// surface.
Body shaped(const std::string& tool)
{
  const Body body = plane(tool);
  palpate::describeModel(body, "Response", { "by hand", palpate::TrueShapePart });
  // About 15 N: the slope is 0.1. With an E* of 5 instead of 3.45 MPa, a fifth of the depth remains
  // for the near field.
  const float numbers[12] = { 0.006F, -0.004F, 0.0F, 0.015F, 0.0008F, -0.0006F, 0.0F, 6.0F, 0.0004F,
    0.0F, 0.0F, 5.0F };
  vtkNew<vtkFloatArray> near;
  near->SetName(palpate::NearFieldArray);
  near->SetNumberOfComponents(12);
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    near->InsertNextTypedTuple(numbers);
  }
  body->GetPointData()->AddArray(near);
  return body;
}

/// Two hands of a session on one body. Their dents add up; one hand is in the dent of the other.
void checkTwoHands()
{
  vtkNew<vtkToolContactResponse> response;
  response->SetInputData(lifted(planeBody(24.0, 120), 50.0));
  response->SetTool(makeTool("sphere:6.35"));
  makePlain(response);
  response->SetCoupling(true);
  response->Update();
  const Body body = response->GetOutput();
  vtkNew<vtkHapticSession> session;
  session->SetBody(body);
  PALPATE_CHECK(session->AddDevice("simulated") == 1);
  for (int hand = 0; hand < 2; ++hand)
  {
    vtkNew<vtkDoubleArray> time;
    time->SetName("Time");
    time->InsertNextValue(0.0);
    const Body path = singleTip(hand == 0 ? -2.0 : 3.5, 0.3, 50.0 - Depth);
    path->GetPointData()->AddArray(time);
    session->GetDevice(hand)->SetPath(path);
  }
  PALPATE_CHECK(session->Start());
  session->Step(0.1);
  vtkNew<vtkContactScene> scene;
  scene->SetBody(body);
  scene->SetTool(makeTool("sphere:6.35"));
  scene->SetLargestDeflection(Depth);
  scene->SetExaggeration(Exaggeration);
  scene->ShowSession(session);
  TwoPaths paths(scene, Vector3(0.0, 0.0, 50.0), Vector3(0.8, -0.3, 1.0), 9.0);
  const Deviation depth(paths.depths(true), paths.depths(false), Surface * Exaggeration * Depth);
  const Deviation color(paths.colors(true, false), paths.colors(false, false), Color);
  const Deviation light(paths.colors(true, true), paths.colors(false, true), Light);
  std::cout << "two hands: surface " << depth.largest << " mm (" << depth.share << "), colour "
            << color.share << ", light " << light.share << std::endl;
  PALPATE_CHECK(depth.share < 0.002 && color.share < 0.002 && light.share <= 0.005);
  const auto both = paths.depths(true);
  session->Stop();
  session->RemoveAddedDevices();
  PALPATE_CHECK(session->Start());
  session->Step(0.1);
  scene->ShowSession(session); // only one hand again
  const Deviation one(paths.depths(true), paths.depths(false), Surface * Exaggeration * Depth);
  PALPATE_CHECK(one.share < 0.002);
  PALPATE_CHECK(Deviation(both, paths.depths(true)).largest > 0.3 * Exaggeration * Depth);
}
} // namespace

int TestDeflectionShader(int, char*[])
{
  checkTwoHands();
  const Vector3 top(0.0, 0.0, 50.0);
  checkCase({ "sphere:6.35", plane("sphere:6.35"), top });
  checkCase({ "paraboloid:3", plane("paraboloid:3"), top, 0.3 });
  checkCase({ "cone:65", plane("cone:65"), top });
  checkCase({ "flat:2", plane("flat:2"), top, 0.0, 0.05 });
  checkCase({ "truncated:1.5,60", plane("truncated:1.5,60"), top, 0.3, 0.05 });
  checkCase({ "sphere:6.35", layered("sphere:6.35", 4.0), top, 0.45 });
  checkCase({ "flat:2", layered("flat:2", 2.0), top, 0.45, 0.05 });
  checkCase({ "sphere:6.35", bending("sphere:6.35"), top, 0.3 });
  checkCase({ "sphere:6.35", shaped("sphere:6.35"), top, 0.3 });
  checkCase({ "flat:2", shaped("flat:2"), top, 0.3, 0.05 });
  checkCase({ "sphere:5", withResponse(sphereBody(20.0, 6), "sphere:5"), Vector3(0.0, 0.0, 20.0) });
  checkCase(
    { "sphere:5", withResponse(tubeBody(15.0, 60.0), "sphere:5"), Vector3(0.0, 0.0, 15.0) });
  return palpate::testing::result();
}

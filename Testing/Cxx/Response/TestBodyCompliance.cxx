// SPDX-License-Identifier: BSD-3-Clause
// vtkBodyCompliance and WholeBody of vtkToolContactResponse: a block on its base against the exact
// layer, the side at which a body is held, the cache, the bending of a rod, surfaces that cross
// themselves, errors.
#include "BoxOnGround.h"
#include "FilterChecks.h"

#include "vtkBodyCompliance.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkContactTool.h"
#include "vtkFieldData.h"
#include "vtkGradedBody.h"
#include "vtkIdList.h"
#include "vtkLinearSubdivisionFilter.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkStringArray.h"
#include "vtkToolContactResponse.h"
#include "vtkTriangleFilter.h"

#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <string>

namespace
{
using namespace palpate::testing;

constexpr double Height = 12.0; // height of the block, mm
constexpr double Modulus = 0.05;
constexpr double Ratio = 0.45;

/// A block on z = 0 with a point in the middle of its top. Its triangles are smaller than contacts,
/// because points with larger triangles have no compliance.
vtkSmartPointer<vtkPolyData> block(double x, double y, double z)
{
  const auto box = boxOnGround(x, y, z);
  // Replaces the diagonal of the top by edges to a point in its middle.
  vtkNew<vtkPolyData> made;
  made->DeepCopy(box);
  const vtkIdType middle = made->GetPoints()->InsertNextPoint(0.0, 0.0, z);
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdList> corners;
  for (vtkIdType t = 0; t < box->GetNumberOfCells(); ++t)
  {
    box->GetCellPoints(t, corners);
    int above = 0;
    for (const vtkIdType corner : *corners)
    {
      above += made->GetPoint(corner)[2] > z - 1e-9 ? 1 : 0;
    }
    if (above < 3)
    {
      cells->InsertNextCell(corners);
      continue;
    }
    // Keeps the two edges of the triangle that are on the border of the top.
    for (int k = 0; k < 3; ++k)
    {
      std::array<double, 3> a{};
      std::array<double, 3> b{};
      const vtkIdType from = corners->GetId(k);
      const vtkIdType to = corners->GetId((k + 1) % 3);
      made->GetPoint(from, a.data());
      made->GetPoint(to, b.data());
      if (a[0] == b[0] || a[1] == b[1])
      {
        const std::array<vtkIdType, 3> fan{ from, to, middle };
        cells->InsertNextCell(3, fan.data());
      }
    }
  }
  made->SetPolys(cells);
  made->GetPointData()->Initialize();
  vtkNew<vtkLinearSubdivisionFilter> finer;
  finer->SetInputData(made);
  finer->SetNumberOfSubdivisions(5);
  finer->Update();
  return finer->GetOutput();
}

vtkIdType middleOf(vtkPolyData* body)
{
  return body->FindPoint(0.0, 0.0, body->GetBounds()[5]);
}

vtkSmartPointer<vtkBodyCompliance> makeFilter(vtkPolyData* body)
{
  auto filter = vtkSmartPointer<vtkBodyCompliance>::New();
  filter->SetInputData(body);
  filter->SetYoungsModulus(Modulus);
  filter->SetPoissonRatio(Ratio);
  filter->SetNumberOfCells(1500);
  return filter;
}

vtkSmartPointer<vtkToolContactResponse> makeResponse(vtkPolyData* body, vtkContactTool* tool)
{
  auto response = vtkSmartPointer<vtkToolContactResponse>::New();
  response->SetInputData(body);
  response->SetTool(tool);
  response->SetYoungsModulus(Modulus);
  response->SetPoissonRatio(Ratio);
  response->SetMaximumDeflection(1.0);
  return response;
}

/// Force at the largest depth at a point, N, and its stated relative error.
std::array<double, 2> pressedAt(vtkToolContactResponse* response, vtkIdType point)
{
  response->Update();
  vtkPointData* data = response->GetOutput()->GetPointData();
  return { data->GetArray("ResponseForce")->GetComponent(point, 7),
    data->GetArray("ResponseError")->GetComponent(point, 7) };
}

/// The block stands on its base. In the middle of its top it acts as a layer bonded to a rigid
/// base, because its sides are four heights away. The force on the layer is exact; the stated error
/// includes the error of the elements.
void checkBlockAgainstLayer()
{
  const auto body = block(100.0, 96.0, Height);
  const vtkIdType middle = middleOf(body);
  vtkNew<vtkContactTool> tool;
  for (const char* shape : { "sphere:6.35", "flat:1.6" })
  {
    tool->SetSpecification(shape);
    const auto layer = makeResponse(body, tool);
    layer->SetLayerThickness(Height);
    layer->SetCurvatureCorrection(false);
    const double exact = pressedAt(layer, middle)[0];
    const auto whole = makeResponse(body, tool);
    whole->SetCurvatureCorrection(false);
    const double halfSpace = pressedAt(whole, middle)[0];
    whole->WholeBodyOn();
    const auto [force, stated] = pressedAt(whole, middle);
    PALPATE_CHECK(exact > 1.1 * halfSpace); // the base has a measurable effect
    PALPATE_CHECK(std::abs(force / exact - 1.0) <= stated);
    PALPATE_CHECK(stated < 0.2);
    PALPATE_CHECK(std::abs(force / exact - 1.0) < 0.05); // cells of a third of the height
    auto* model = vtkStringArray::SafeDownCast(
      whole->GetOutput()->GetFieldData()->GetAbstractArray("ResponseModel"));
    PALPATE_CHECK(model && model->GetValue(0).find("held at z-") != std::string::npos);
  }
}

/// A body is held at its largest side, for any orientation of the body. A flat side is held itself,
/// a convex side is held up to a depth.
void checkStandingSide()
{
  const auto held = [](vtkPolyData* body)
  {
    const auto filter = makeFilter(body);
    filter->SetNumberOfCells(400);
    filter->Update();
    PALPATE_CHECK(filter->GetOutput()->GetPointData()->HasArray("GlobalCompliance"));
    return filter->GetHeldAt();
  };
  PALPATE_CHECK(held(block(40.0, 30.0, 10.0)) == "z-");
  PALPATE_CHECK(held(block(10.0, 40.0, 30.0)) == "x-");
  PALPATE_CHECK(held(block(40.0, 10.0, 30.0)) == "y-");
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(20.0);
  ball->SetThetaResolution(48);
  ball->SetPhiResolution(32);
  ball->Update();
  PALPATE_CHECK(held(ball->GetOutput()).substr(0, 3) == "z-:");
  // The area of a low cap is inversely proportional to the factor. The area of the upper side is
  // 1.25 and 3.3 times that of the lower one.
  const auto flattened = [&ball](double factor)
  {
    vtkNew<vtkPolyData> body;
    body->DeepCopy(ball->GetOutput());
    for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
    {
      std::array<double, 3> place{};
      body->GetPoint(i, place.data());
      place[2] *= place[2] > 0.0 ? 0.6 * factor : 0.6; // flatter than along x and y
      body->GetPoints()->SetPoint(i, place.data());
    }
    return vtkSmartPointer<vtkPolyData>(body);
  };
  PALPATE_CHECK(held(flattened(0.8)).substr(0, 3) == "z-:");
  PALPATE_CHECK(held(flattened(0.3)).substr(0, 3) == "z+:");
}

/// C is proportional to 1/E. The second run reads the file that the first one wrote.
void checkModulusAndCache()
{
  const auto body = block(40.0, 30.0, 10.0);
  const auto filter = makeFilter(body);
  int reports = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&reports);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  filter->AddObserver(vtkCommand::ProgressEvent, count);
  filter->SetNumberOfCells(401); // a number of cells that no other check uses
  filter->Update();
  const int first = reports;
  const auto valueOf = [&filter](const char* name)
  {
    vtkPolyData* made = filter->GetOutput();
    return made->GetPointData()->GetArray(name)->GetComponent(middleOf(made), 0);
  };
  const double compliance = valueOf("GlobalCompliance");
  const double error = valueOf("GlobalComplianceError");
  reports = 0;
  filter->SetYoungsModulus(2.0 * Modulus);
  filter->Update();
  PALPATE_CHECK(reports < first / 2);
  PALPATE_CHECK_NEAR(valueOf("GlobalCompliance") / compliance, 0.5, 1e-12);
  PALPATE_CHECK_NEAR(valueOf("GlobalComplianceError") / error, 0.5, 1e-12);
  // A smaller contact uses the same solution.
  reports = 0;
  filter->SetContactRadius(1.0);
  filter->Update();
  PALPATE_CHECK(reports < first / 2);
}

/// A rod that stands on its end bends under a force on its flank as a Timoshenko beam, which
/// includes shear (Timoshenko 1921; shear coefficient of a rectangle: Cowper 1966). The modes move
/// the whole rod, also far from the force.
void checkModes()
{
  constexpr double width = 8.0;
  constexpr double loaded = 50.0;
  const auto rod = block(width, width, 60.0);
  const auto filter = makeFilter(rod);
  filter->SetFixedFaces("z-");
  filter->Update();
  vtkPolyData* made = filter->GetOutput();
  vtkDataArray* signs = made->GetFieldData()->GetArray("GlobalModeSign");
  PALPATE_CHECK(signs && signs->GetNumberOfTuples() == 6);
  const vtkIdType at = made->FindPoint(0.5 * width, 0.0, loaded); // the outward normal is +x
  // Displacement along x under 1 N against x.
  const auto displacement = [&](vtkIdType point)
  {
    double sum = 0.0;
    for (vtkIdType k = 0; signs && k < signs->GetNumberOfTuples(); ++k)
    {
      vtkDataArray* mode =
        made->GetPointData()->GetArray(("GlobalMode" + std::to_string(k)).c_str());
      sum -= signs->GetComponent(k, 0) * mode->GetComponent(at, 0) * mode->GetComponent(point, 0);
    }
    return sum;
  };
  const double bending = Modulus * std::pow(width, 4) / 12.0;
  const double shear =
    Modulus / (2.0 + 2.0 * Ratio) * width * width * (10.0 + 10.0 * Ratio) / (12.0 + 11.0 * Ratio);
  const auto beam = [&](double height)
  { return height * height * (3.0 * loaded - height) / (6.0 * bending) + height / shear; };
  for (const double height : { 15.0, 25.0, 35.0, loaded })
  {
    // The flank on the other side of the force has no dent. Six modes and cells of half the width
    // have an error of a few per cent of the largest displacement.
    const double moved = displacement(made->FindPoint(-0.5 * width, 0.0, height));
    PALPATE_CHECK_NEAR(moved / beam(loaded), -beam(height) / beam(loaded), 0.03);
  }
  PALPATE_CHECK(displacement(made->FindPoint(0.0, 0.0, 0.0)) == 0.0); // held points do not move
}

/// A surface that crosses itself is replaced by its outer surface, which can be filled.
void checkCrossingSurface()
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(20.0);
  source->SetThetaResolution(48);
  source->SetPhiResolution(32);
  source->Update();
  vtkNew<vtkPolyData> ball;
  ball->DeepCopy(source->GetOutput());
  const auto plain = makeFilter(ball);
  plain->SetNumberOfCells(800);
  plain->SetFixedFaces("z-:4");
  plain->Update();
  vtkNew<vtkPolyData> crossed;
  crossed->DeepCopy(ball);
  // Moves a point on the equator across its neighbours.
  vtkIdType a = 0;
  for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); ++i)
  {
    a = ball->GetPoint(i)[0] > ball->GetPoint(a)[0] ? i : a;
  }
  std::array<double, 3> place{};
  crossed->GetPoint(a, place.data());
  crossed->GetPoints()->SetPoint(a, 15.0, place[1] + 9.0, place[2] + 3.0);
  const auto mended = makeFilter(crossed);
  mended->SetNumberOfCells(800);
  mended->SetFixedFaces("z-:4");
  mended->Update();
  vtkDataArray* before = plain->GetOutput()->GetPointData()->GetArray("GlobalCompliance");
  vtkDataArray* after = mended->GetOutput()->GetPointData()->GetArray("GlobalCompliance");
  PALPATE_CHECK(before && after);
  // Compares at the top pole, far from the fold. The sum of both errors is allowed.
  const double error =
    plain->GetOutput()->GetPointData()->GetArray("GlobalComplianceError")->GetTuple1(0) +
    mended->GetOutput()->GetPointData()->GetArray("GlobalComplianceError")->GetTuple1(0);
  PALPATE_CHECK(std::abs(after->GetTuple1(0) - before->GetTuple1(0)) < error);
}

/// A body without a compliance gets the same response as without WholeBody.
void checkLeftOut()
{
  vtkNew<vtkPlaneSource> sheet;
  sheet->SetXResolution(4);
  sheet->SetYResolution(4);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(sheet->GetOutputPort());
  triangles->Update();
  vtkNew<vtkContactTool> tool;
  tool->SetSpecification("sphere:0.05");
  const auto response = makeResponse(triangles->GetOutput(), tool);
  response->SetMaximumDeflection(0.01);
  const double without = pressedAt(response, 12)[0];
  response->WholeBodyOn();
  PALPATE_CHECK(pressedAt(response, 12)[0] == without);
  PALPATE_CHECK(!response->GetOutput()->GetPointData()->HasArray("GlobalCompliance"));
  const auto layer = makeResponse(block(40.0, 30.0, 10.0), tool);
  layer->SetMaximumDeflection(0.01);
  layer->SetLayerThickness(10.0);
  layer->WholeBodyOn();
  layer->Update();
  PALPATE_CHECK(!layer->GetOutput()->GetPointData()->HasArray("GlobalCompliance"));
}

/// With the compliance of the whole body, the curves include the edges. The law of edges then acts
/// only outside. Without the compliance, here on large triangles, the law of edges acts inside too.
void checkWithEdges()
{
  vtkNew<vtkContactTool> tool;
  tool->SetSpecification("sphere:6.35");
  const auto isInCurves = [&tool](vtkPolyData* body, bool hasCompliance)
  {
    const auto response = makeResponse(body, tool);
    response->WholeBodyOn();
    response->EdgeCorrectionOn();
    response->Update();
    PALPATE_CHECK(
      (response->GetOutput()->GetPointData()->HasArray("GlobalCompliance") != 0) == hasCompliance);
    vtkDataArray* edges = response->GetOutput()->GetFieldData()->GetArray("ResponseEdges");
    PALPATE_CHECK(edges && edges->GetNumberOfComponents() == 5);
    return edges && edges->GetComponent(0, 4) != 0.0;
  };
  PALPATE_CHECK(isInCurves(block(100.0, 96.0, Height), true));
  PALPATE_CHECK(!isInCurves(boxOnGround(100.0, 96.0, 50.0), false));
}

void checkErrors()
{
  const auto body = block(40.0, 30.0, 10.0);
  const auto fails = [&body](auto&& change, std::initializer_list<const char*> words)
  {
    const auto filter = makeFilter(body);
    Messages messages(filter.Get());
    change(filter.Get());
    filter->Update();
    checkText(messages.errors(), words, __FILE__, __LINE__);
    PALPATE_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
  };
  fails([](auto* f) { f->SetYoungsModulus(0.0); }, { "Young's Modulus", "0" });
  fails([](auto* f) { f->SetPoissonRatio(0.5); }, { "Poisson's Ratio", "0.5" });
  fails([](auto* f) { f->SetContactRadius(-1.0); }, { "ContactRadius", "-1" });
  fails([](auto* f) { f->SetNumberOfCells(5); }, { "NumberOfCells", "5" });
  fails([](auto* f) { f->SetFixedFaces("w+"); }, { "Fixed Faces", "w+" });
  vtkNew<vtkPlaneSource> sheet;
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(sheet->GetOutputPort());
  fails([&](auto* f) { f->SetInputConnection(triangles->GetOutputPort()); },
    { "not closed", "filled" });
  const auto stopped = makeFilter(body);
  stopped->SetNumberOfCells(402);
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* filter, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(filter)->SetAbortExecute(1); });
  stopped->AddObserver(vtkCommand::ProgressEvent, stop);
  stopped->Update();
  PALPATE_CHECK(!stopped->GetOutput()->GetPointData()->HasArray("GlobalCompliance"));
}
} // namespace

int TestBodyCompliance(int, char*[])
{
  const auto cache = std::filesystem::temp_directory_path() /
    ("palpate-compliance-" + std::to_string(static_cast<long>(getpid())));
  setenv("PALPATE_CACHE", cache.c_str(), 1);
  if (!vtkGradedBody::IsAvailable())
  {
    return 77;
  }
  checkBlockAgainstLayer();
  checkStandingSide();
  checkModulusAndCache();
  checkModes();
  checkCrossingSurface();
  checkLeftOut();
  checkWithEdges();
  checkErrors();
  std::filesystem::remove_all(cache);
  return result();
}

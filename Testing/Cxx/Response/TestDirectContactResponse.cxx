// SPDX-License-Identifier: BSD-3-Clause
// Direct contact on parts cut out of a body: a bending bar, pressed in the middle and across its
// edge, against the same tool on one fine mesh of the whole bar; a bonded layer against the exact
// law; points that keep their results; threads, abort, errors.
#include "AbortedFilter.h"
#include "FilterChecks.h"
#include "Mechanics/FiniteStrain/StrainCorrection.h"
#include "Mechanics/Layers/LayerContact.h"
#include "Mechanics/ReducedModulus.h"
#include "Solids/TrueShape/DirectContact.h"

#include "vtkContactTool.h"
#include "vtkCell.h"
#include "vtkCubeSource.h"
#include "vtkDataArray.h"
#include "vtkDirectContactResponse.h"
#include "vtkFloatArray.h"
#include "vtkGradedBody.h"
#include "vtkLinearSubdivisionFilter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkToolContactResponse.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace
{
using namespace palpate::testing;
using Filter = vtkSmartPointer<vtkDirectContactResponse>;
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;
using Surface = vtkSmartPointer<vtkPolyData>;
using Place = std::array<double, 3>;

constexpr double Young = 0.1;
constexpr double Poisson = 0.4;
constexpr double Depth = 0.5;
constexpr auto ToolText = "sphere:3";

/// A box of x × y × z mm around the origin, with 2 · 4^n triangles per side.
Surface box(double x, double y, double z, int subdivisions)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(x);
  cube->SetYLength(y);
  cube->SetZLength(z);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(cube->GetOutputPort());
  vtkNew<vtkLinearSubdivisionFilter> finer;
  finer->SetInputConnection(triangles->GetOutputPort());
  finer->SetNumberOfSubdivisions(subdivisions);
  finer->Update();
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(finer->GetOutput()->GetPoints());
  bare->SetPolys(finer->GetOutput()->GetPolys());
  return bare.Get();
}

Grid filled(vtkPolyData* surface, double spacing, const char* held, const Place* fine = nullptr)
{
  vtkNew<vtkGradedBody> body;
  body->SetInputData(surface);
  body->SetSurfaceSpacing(spacing);
  body->SetFixedFaces(held);
  if (fine)
  {
    body->AddFineBall((*fine)[0], (*fine)[1], (*fine)[2], 1.8, 0.35);
  }
  body->Update();
  return body->GetOutput();
}

vtkSmartPointer<vtkContactTool> tool()
{
  auto made = vtkSmartPointer<vtkContactTool>::New();
  made->SetSpecification(ToolText);
  return made;
}

/// The surface with the law of a half-space and a stated error of one half. Only the points at the
/// given places are chosen.
Surface felt(vtkPolyData* surface, const std::vector<Place>& places)
{
  vtkNew<vtkToolContactResponse> law;
  law->SetInputData(surface);
  law->SetTool(tool());
  law->SetYoungsModulus(Young);
  law->SetPoissonRatio(Poisson);
  law->SetMaximumDeflection(Depth);
  law->Update();
  Surface made = law->GetOutput();
  made->GetPointData()->GetArray("ResponseError")->Fill(0.5);
  vtkNew<vtkUnsignedCharArray> pressed;
  pressed->SetName("Pressed");
  pressed->SetNumberOfValues(made->GetNumberOfPoints());
  pressed->Fill(0);
  for (Place place : places)
  {
    pressed->SetValue(made->FindPoint(place.data()), 1);
  }
  made->GetPointData()->AddArray(pressed);
  return made;
}

Filter press(
  vtkPolyData* surface, vtkUnstructuredGrid* body, vtkUnstructuredGrid* coarser, const char* held)
{
  auto filter = Filter::New();
  filter->SetInputData(surface);
  filter->SetBodyData(body);
  filter->SetCoarserData(coarser);
  filter->SetTool(tool());
  filter->SetYoungsModulus(Young);
  filter->SetPoissonRatio(Poisson);
  filter->SetMaximumDeflection(Depth);
  filter->SetFixedFaces(held);
  return filter;
}

double value(vtkPolyData* surface, const char* name, Place at, int component)
{
  vtkDataArray* array = surface->GetPointData()->GetArray(name);
  return array->GetComponent(
    surface->FindPoint(at.data()), component < 0 ? array->GetNumberOfComponents() - 1 : component);
}

/// The force from one fine mesh of the whole body.
double whole(vtkPolyData* surface, const char* held, const Place& place, const Place& inward)
{
  const Grid grid = filled(surface, 2.0, held, &place);
  palpate::ElasticBodyInput input;
  input.materials = { { Young, Poisson } };
  input.mesh.nodes.resize(3, grid->GetNumberOfPoints());
  vtkDataArray* fixed = grid->GetPointData()->GetArray("Fixed");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    grid->GetPoint(i, input.mesh.nodes.col(i).data());
    input.fixed.push_back(static_cast<unsigned char>(fixed->GetTuple1(i)));
  }
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    palpate::VolumeElement element;
    element.kind = palpate::ElementKind::QuadraticTetrahedron;
    for (int i = 0; i < 10; ++i)
    {
      element.nodes[static_cast<std::size_t>(i)] =
        static_cast<std::int32_t>(grid->GetCell(c)->GetPointId(i));
    }
    input.mesh.elements.push_back(element);
  }
  palpate::ElasticBody body;
  PALPATE_CHECK(body.assemble(std::move(input)) == "");
  PALPATE_CHECK(body.analyse(palpate::StiffnessFactor::Kind::Automatic) == "");
  PALPATE_CHECK(body.factorise() == "");
  const palpate::DirectPlace at{ Eigen::Vector3d(place.data()), Eigen::Vector3d(inward.data()) };
  const vtkSmartPointer<vtkContactTool> pressed = tool();
  const palpate::DirectContact contact(body, *pressed->GetKernel(), at, Depth);
  return 0.5 *
    (contact.at(Depth, palpate::Pushed::TogetherAlongTheMean).force +
      contact.at(Depth, palpate::Pushed::EachAlongItsOwn).force);
}

/// A bar held at one end. In the middle of its top its bending is larger than the dent. At 0.75 mm
/// from the edge the contact of 1.2 mm extends beyond the edge, where the law of a half-space has
/// an error of one half.
void checkBar()
{
  const Surface surface = box(48.0, 12.0, 12.0, 4); // 1 mm of the bar is held
  const char* held = "x-:1";
  const Place middle{ 6.0, 0.0, 6.0 };
  const Place edge{ 6.0, 5.25, 6.0 };
  const Place down{ 0.0, 0.0, -1.0 };
  const Place other{ 0.0, 0.0, 6.0 };
  const Surface before = felt(surface, { middle, edge });
  const Grid body = filled(surface, 3.0, held);
  const Grid coarser = filled(surface, 5.0, held);
  const Filter filter = press(before, body, coarser, held);
  Messages messages(filter);
  withThreads(2, [&] { filter->Update(); });
  PALPATE_CHECK(messages.none());
  PALPATE_CHECK(filter->GetNumberOfPresses() == 2 && filter->GetNumberOfReplaced() == 2);
  vtkPolyData* after = filter->GetOutput();
  for (const Place& place : { middle, edge })
  {
    const double force = value(after, "ResponseForce", place, -1);
    const double brute = whole(surface, held, place, down);
    PALPATE_CHECK(std::abs(value(before, "ResponseForce", place, -1) / brute - 1.0) > 0.3);
    // Two meshes with four facets over the contact radius have an error of 1 % each. The bending of
    // coarse cells adds to it.
    PALPATE_CHECK_NEAR(force / brute, 1.0, 0.03);
    const double stated = value(after, "ResponseError", place, -1);
    PALPATE_CHECK(stated >= 0.01 && stated < 0.08);
    PALPATE_CHECK(value(after, "ResponseDirect", place, 0) == 1.0);
    PALPATE_CHECK_NEAR(value(after, "ResponseRange", place, 0), Depth, 1e-6);
    // The stiffness is the slope of the force, checked between the last two of eight samples.
    const double rise = force - value(after, "ResponseForce", place, 6);
    const double mean = 0.5 *
      (value(after, "ResponseStiffness", place, 6) + value(after, "ResponseStiffness", place, 7));
    PALPATE_CHECK_NEAR(rise / (mean * Depth * (1.0 - 49.0 / 64.0)), 1.0, 0.03);
  }
  for (const char* name : { "ResponseForce", "ResponseStiffness", "ResponseError" })
  {
    PALPATE_CHECK(value(after, name, other, -1) == value(before, name, other, -1));
  }
  PALPATE_CHECK(value(after, "ResponseDirect", other, 0) == 0.0);
  // The input is unchanged, and one thread gives the same bits.
  PALPATE_CHECK(
    value(before, "ResponseForce", middle, -1) != value(after, "ResponseForce", middle, -1));
  const Filter alone = press(felt(surface, { edge }), body, coarser, held);
  withThreads(1, [&] { alone->Update(); });
  for (int k = 0; k < 8; ++k)
  {
    PALPATE_CHECK(value(after, "ResponseForce", edge, k) ==
      value(alone->GetOutput(), "ResponseForce", edge, k));
  }
  checkAborted(press(felt(surface, { edge }), body, coarser, held).Get(), 0.03);
}

/// A bonded layer, from which the part is cut out on four sides. Reference: the exact law, and the
/// factor of finite strain from the axisymmetric solver's tables.
void checkLayer()
{
  constexpr double thickness = 3.0;
  const Surface surface = box(30.0, 30.0, thickness + 1.0, 4);
  const Place middle{ 0.0, 0.0, 0.5 * (thickness + 1.0) };
  const char* held = "z-:1";
  const Grid body = filled(surface, 1.5, held);
  const Grid coarser = filled(surface, 2.8, held);
  const Filter filter = press(felt(surface, { middle }), body, coarser, held);
  filter->Update();
  const Filter deep = press(felt(surface, { middle }), body, coarser, held);
  deep->SetStrainModel(vtkDirectContactResponse::NeoHooke);
  deep->Update();
  const vtkSmartPointer<vtkContactTool> pressed = tool();
  const palpate::LayerContact exact(*pressed->GetKernel(),
    std::make_shared<const palpate::LayerKernel>(Poisson, palpate::LayerBase::Bonded), thickness);
  const double modulus = palpate::reducedModulus(Young, Poisson);
  palpate::StrainBodies bodies;
  bodies.hasHalfSpace = false;
  bodies.leastRatio = bodies.mostRatio = Poisson;
  bodies.thinnest = bodies.thickest = thickness;
  std::unique_ptr<palpate::StrainCorrection> strain;
  PALPATE_CHECK(palpate::makeStrainCorrection(
                  *pressed->GetKernel(), { palpate::StrainModel::NeoHooke, 0.0 }, bodies, Depth,
                  [](double) { return true; }, strain) == "");
  for (int k = 5; k < 8; ++k)
  {
    const double depth = Depth * (k + 1) * (k + 1) / 64.0;
    const double force = value(filter->GetOutput(), "ResponseForce", middle, k);
    // The error of the contact is 1 %, more for a smaller contact with fewer facets.
    const double expected = exact.evaluate(depth, modulus).force;
    PALPATE_CHECK_NEAR(force / expected, 1.0, 0.025);
    const double factor = strain->at(depth, Poisson, thickness).factor;
    const double deepForce = value(deep->GetOutput(), "ResponseForce", middle, k);
    PALPATE_CHECK_NEAR(deepForce / (factor * expected), 1.0, 0.025);
    PALPATE_CHECK(value(deep->GetOutput(), "ResponseError", middle, k) < 0.04);
  }
}

/// A ball whose lowest millimetre is held. A tool that presses obliquely near the held part reaches
/// it before the full depth. The point keeps its response, and the filter reports the reason.
void checkHeld()
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(5.0);
  ball->SetThetaResolution(24);
  ball->SetPhiResolution(25);
  ball->Update();
  const Place below{ 5.0 * std::sin(2.42), 0.0, 5.0 * std::cos(2.42) }; // 3.75 mm below the centre
  const char* held = "z-:1";
  const Surface before = felt(ball->GetOutput(), { below });
  const Filter filter =
    press(before, filled(ball->GetOutput(), 2.0, held), filled(ball->GetOutput(), 3.5, held), held);
  Messages messages(filter);
  filter->Update();
  PALPATE_CHECK_TEXT(messages.warnings(), "reaches held points");
  vtkPolyData* after = filter->GetOutput();
  PALPATE_CHECK(value(after, "ResponseDirect", below, 0) == 3.0);
  PALPATE_CHECK(
    value(after, "ResponseForce", below, -1) == value(before, "ResponseForce", below, -1));
}

void checkErrors()
{
  const Surface surface = box(8.0, 8.0, 8.0, 3);
  const Surface before = felt(surface, { { 0.0, 0.0, 4.0 } });
  const Grid body = filled(surface, 1.5, "z-");
  const Grid coarser = filled(surface, 3.0, "z-");
  const auto wrong = [](const Filter& filter, std::initializer_list<const char*> words)
  {
    Messages messages(filter);
    filter->Update();
    const std::string text = messages.takeErrors();
    for (const char* word : words)
    {
      PALPATE_CHECK_TEXT(text, word);
    }
    PALPATE_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
  };
  Filter filter = press(before, body, coarser, "z-");
  filter->SetTool(nullptr);
  wrong(filter, { "Tool" });
  filter = press(before, body, coarser, "z-");
  filter->SetErrorTolerance(0.0);
  wrong(filter, { "Error Tolerance", "0" });
  filter = press(before, body, coarser, "w-");
  wrong(filter, { "w-" });
  filter = press(before, body, body, "z-");
  wrong(filter, { "Coarser", "1 times" });
  filter = press(before, body, Grid::New(), "z-");
  wrong(filter, { "Coarser", "no cells" });
  filter = press(surface, body, coarser, "z-");
  wrong(filter, { "no response 'Response'" });
  const Surface without = Surface::New();
  without->ShallowCopy(before);
  without->GetPointData()->RemoveArray("ResponseError");
  filter = press(without, body, coarser, "z-");
  wrong(filter, { "ResponseError", "Store Error" });
  filter = press(before, body, coarser, "z-");
  filter->SetYoungsModulus(-1.0);
  wrong(filter, { "Young's Modulus", "-1" });
  // If every error is within the tolerance, no point is pressed, and the solids are not used.
  filter = press(before, body, coarser, "z-");
  filter->SetErrorTolerance(1.0);
  filter->Update();
  PALPATE_CHECK(filter->GetNumberOfPresses() == 0);
  PALPATE_CHECK(filter->GetOutput()->GetNumberOfPoints() == before->GetNumberOfPoints());
  // An error at a depth larger than the requested depth has no effect.
  vtkDataArray* error = before->GetPointData()->GetArray("ResponseError");
  error->FillComponent(error->GetNumberOfComponents() - 1, 1.0);
  error->Modified();
  filter = press(before, body, coarser, "z-");
  filter->SetErrorTolerance(0.5);
  filter->SetMaximumDeflection(0.5 * Depth);
  filter->Update();
  PALPATE_CHECK(filter->GetNumberOfPresses() == 0);
}
} // namespace

int TestDirectContactResponse(int, char*[])
{
  if (!vtkGradedBody::IsAvailable())
  {
    const Surface surface = box(8.0, 8.0, 8.0, 2);
    vtkNew<vtkUnstructuredGrid> none;
    const Filter filter = press(felt(surface, {}), none, none, "z-");
    Messages messages(filter);
    filter->Update();
    PALPATE_CHECK_TEXT(messages.errors(), "CGAL");
    return result();
  }
  checkBar();
  checkLayer();
  checkHeld();
  checkErrors();
  return result();
}

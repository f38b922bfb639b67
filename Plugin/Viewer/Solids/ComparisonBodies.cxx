// SPDX-License-Identifier: BSD-3-Clause
#include "ComparisonBodies.h"

#include "vtkAppendFilter.h"
#include "vtkAppendPolyData.h"
#include "vtkCubeSource.h"
#include "vtkCylinderSource.h"
#include "vtkElasticCompliance.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkLinearSubdivisionFilter.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <cstring>

namespace palpate
{
namespace
{
// The rubber of Mahvash and Hayward 2002, section 4.2. Poisson's ratio is not given in the paper.
constexpr double ReducedModulus = 3.45; // MPa
constexpr double PoissonRatio = 0.45;

// Sizes in mm. They are assumptions, because the paper states no sizes.
constexpr double Length = 72.0; // along x
constexpr double Width = 20.0;
constexpr double StripThickness = 3.0;
constexpr double BlockThickness = 20.0;
constexpr double RollerPosition = 28.0; // distance of the rollers from the middle, mm
constexpr double RollerRadius = 2.0;
constexpr double PlateThickness = 3.0;
constexpr double PlateMargin = 4.0;
constexpr double SlideLength = 14.0;

constexpr double Spacing = 2.0; // size of the finite elements along the surface, mm
constexpr int StripLayers = 6;
constexpr int BlockLayers = 10;
constexpr int Subdivisions = 2; // subdivisions of the contact surface
constexpr int Modes = 6;        // number of bending modes, used for display

/// Bits of the array Fixed of vtkElasticCompliance.
enum Hold : unsigned char
{
  AlongX = 1,
  AlongY = 2,
  AlongZ = 4
};

using Place = std::array<double, 3>;

/// Returns the held directions of a point of the strip, which lies on two rollers along y near its
/// ends. The rollers also hold the strip down, so that it can slide over them but cannot lift off.
unsigned char holdStrip(const Place& place)
{
  const bool below = place[2] == -StripThickness;
  const bool middle = place[1] == 0.0;
  unsigned char held = 0;
  held |= below && std::abs(place[0]) == RollerPosition ? AlongZ : 0;
  held |= below && middle && place[0] == 0.0 ? AlongX | AlongY : 0;
  held |= below && middle && place[0] == 0.5 * Length ? AlongY : 0;
  return held;
}

unsigned char holdBlock(const Place& place)
{
  return place[2] == -BlockThickness ? AlongX | AlongY | AlongZ : 0;
}

/// Makes a cuboid of hexahedra whose top face is z = 0.
vtkSmartPointer<vtkUnstructuredGrid> makeCuboid(
  double thickness, int layers, unsigned char (*hold)(const Place&))
{
  vtkNew<vtkImageData> grid;
  grid->SetDimensions(
    static_cast<int>(Length / Spacing) + 1, static_cast<int>(Width / Spacing) + 1, layers + 1);
  grid->SetSpacing(Spacing, Spacing, thickness / layers);
  grid->SetOrigin(-0.5 * Length, -0.5 * Width, -thickness);
  vtkNew<vtkUnsignedCharArray> fixed;
  fixed->SetName("Fixed");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    Place place{};
    grid->GetPoint(i, place.data());
    fixed->InsertNextValue(hold(place));
  }
  grid->GetPointData()->AddArray(fixed);
  vtkNew<vtkAppendFilter> cells;
  cells->SetInputData(grid);
  cells->Update();
  return cells->GetOutput();
}

/// Makes the surface of the solid, with compliance and modes. The surface is fine enough to show a
/// dent.
std::string makeSurface(vtkUnstructuredGrid* solid, ViewerScene& scene)
{
  vtkNew<vtkElasticCompliance> elastic;
  elastic->SetInputData(solid);
  elastic->SetYoungsModulus(scene.youngsModulus);
  elastic->SetPoissonRatio(scene.poissonRatio);
  elastic->SetNumberOfModes(Modes);
  std::string error = updateQuietly(elastic);
  if (!error.empty())
  {
    return error;
  }
  vtkPolyData* found = elastic->GetOutput();
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(found->GetPoints());
  surface->SetPolys(found->GetPolys());
  for (int i = 0; i < found->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = found->GetPointData()->GetArray(i);
    if (array && std::strncmp(array->GetName(), "Global", 6) == 0)
    {
      surface->GetPointData()->AddArray(array);
    }
  }
  vtkNew<vtkLinearSubdivisionFilter> finer;
  finer->SetInputData(surface);
  finer->SetNumberOfSubdivisions(Subdivisions);
  error = updateQuietly(finer);
  scene.body = finer->GetOutput();
  scene.body->GetFieldData()->ShallowCopy(found->GetFieldData());
  return error;
}

void addCuboid(vtkAppendPolyData* all, const std::array<double, 6>& bounds)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(bounds.data());
  all->AddInputConnection(cube->GetOutputPort());
}

/// Makes the rigid plate under both bodies, and the rollers on their posts.
vtkSmartPointer<vtkPolyData> makeSupport(bool rollers)
{
  constexpr double halfLength = 0.5 * Length + PlateMargin;
  constexpr double halfWidth = 0.5 * Width + PlateMargin;
  vtkNew<vtkAppendPolyData> all;
  addCuboid(all,
    { -halfLength, halfLength, -halfWidth, halfWidth, -BlockThickness - PlateThickness,
      -BlockThickness });
  if (rollers)
  {
    for (const double x : { -RollerPosition, RollerPosition })
    {
      const double middle = -StripThickness - RollerRadius;
      vtkNew<vtkCylinderSource> roller; // the roller is along y
      roller->SetRadius(RollerRadius);
      roller->SetHeight(Width + 2.0);
      roller->SetResolution(48);
      roller->SetCenter(x, 0.0, middle);
      all->AddInputConnection(roller->GetOutputPort());
      addCuboid(all,
        { x - RollerRadius, x + RollerRadius, -0.5 * Width, 0.5 * Width, -BlockThickness, middle });
    }
  }
  all->Update();
  return all->GetOutput();
}

/// Sets the properties that are common to both bodies.
void describe(const ViewerOptions& options, ViewerScene& scene)
{
  const bool given = options.youngsModulus || options.poissonRatio;
  scene.poissonRatio = options.poissonRatio.value_or(PoissonRatio);
  scene.terms = options.terms;
  scene.relaxation = options.relaxation;
  scene.youngsModulus =
    options.youngsModulus.value_or(ReducedModulus * (1.0 - PoissonRatio * PoissonRatio));
  scene.materialSource = given
    ? "given on the command line"
    : "rubber, E* = 3.45 MPa (Mahvash and Hayward 2002, section 4.2), Poisson's ratio assumed";
  scene.solid = true;
  scene.modelReason = "in series with the compliance of the solid, by finite elements";
  scene.tools = options.tools.empty()
    ? std::vector<std::string>{ "sphere:6.35", "flat:1.6", "sphere:1.6" }
    : options.tools;
  scene.depth = options.depth.value_or(1.0);
  scene.center = { 0.0, 0.0, -1.5 };
  scene.directions = { { 0.0, 0.0, 1.5 }, { SlideLength, 0.0, 1.5 } };
  scene.pictureAt = 0.0; // the pictures are taken in the middle of the strip
  scene.viewFrom = { 0.25, -0.9, 0.42 };
}
} // namespace

std::string makeComparedBodies(const ViewerOptions& options, std::array<ComparedBody, 2>& bodies)
{
  bodies[0].scene.title = "Strip 72 \u00D7 20 \u00D7 3 mm on two rollers";
  bodies[1].scene.title = "Block 72 \u00D7 20 \u00D7 20 mm bonded to a plate";
  bodies[0].support = makeSupport(true);
  bodies[1].support = makeSupport(false);
  for (ComparedBody& body : bodies)
  {
    const bool isStrip = &body == &bodies[0];
    describe(options, body.scene);
    std::string error = makeSurface(isStrip ? makeCuboid(StripThickness, StripLayers, holdStrip)
                                            : makeCuboid(BlockThickness, BlockLayers, holdBlock),
      body.scene);
    if (error.empty())
    {
      error = prepareResponses(options, body.scene, body.responses);
    }
    if (!error.empty())
    {
      return error;
    }
  }
  return {};
}
} // namespace palpate

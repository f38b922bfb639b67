// SPDX-License-Identifier: BSD-3-Clause
#include "SolidBody.h"

#include "Response/Files/CollectingWindow.h"
#include "Mechanics/JoinedText.h"
#include "ProgressLine.h"
#include "SolidResponse/Bodies/ChosenSpacing.h"
#include "SolidTools.h"
#include "SolvedCache.h"

#include "vtkElasticContactResponse.h"
#include "vtkGradedBody.h"
#include "vtkMassProperties.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace palpate
{
namespace
{
/// Number of source points that two cores solve in about a minute.
constexpr double UsualSources = 10000.0;
/// Smallest spacing as a fraction of the contact radius. The spacing may be smaller if the shape of
/// the body requires it.
constexpr double LeastOfContact = 0.5;
/// Smallest distance of the source points as a fraction of the spacing. Sources are nodes,
/// including the nodes at the midpoints of edges.
constexpr double LeastOfSpacing = 0.5;
/// Ratio of the spacing of the second mesh to that of the first. The second mesh is used to
/// estimate the error of the first, at a sixth of the cost.
constexpr double CoarserRatio = 2.0;

double secondsSince(std::chrono::steady_clock::time_point begin)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The size of cells at the surface, and the distance between source points.
struct SolidSizes
{
  double spacing = 0.0; ///< mm
  double sources = 0.0; ///< mm
};

SolidSizes chooseSizes(vtkPolyData* body, double given, double contactRadius)
{
  vtkNew<vtkMassProperties> shape;
  shape->SetInputData(body);
  shape->Update();
  const double area = shape->GetSurfaceArea();
  SolidSizes sizes;
  sizes.spacing = given;
  if (given == 0.0)
  {
    const double volume = shape->GetVolume();
    sizes.spacing = std::min(std::max(chosenSpacing(area, volume), LeastOfContact * contactRadius),
      LargestOfBody * std::cbrt(volume));
  }
  sizes.sources = std::max(LeastOfSpacing * sizes.spacing, std::sqrt(area / UsualSources));
  return sizes;
}

/// Returns the cache key, which contains all input of the responses. The revision must be increased
/// when the same input gives other results.
std::string solidKey(const ViewerOptions& options, const ViewerScene& scene)
{
  constexpr int Revision = 10;
  return joined(Revision, solidTermsKey(options, scene), contentOf(scene.body));
}

/// Fills the body with tetrahedra. Returns "" or an error.
std::string fill(vtkPolyData* body, double spacing, const std::string& fixed, vtkGradedBody* filled)
{
  filled->SetInputData(body);
  filled->SetSurfaceSpacing(spacing);
  filled->SetFixedFaces(fixed);
  return updateWithProgress(filled, "the body is filled with tetrahedra");
}

/// Fills the body with larger cells. Warnings are suppressed, because defects of the surface have
/// already been reported for the first mesh.
std::string fillAgain(vtkGradedBody* first, vtkGradedBody* coarser)
{
  coarser->SetInputData(first->GetInput());
  coarser->SetSurfaceSpacing(CoarserRatio * first->GetSurfaceSpacing());
  coarser->SetFixedFaces(first->GetFixedFaces());
  const QuietScope quiet;
  coarser->Update();
  return quiet.window->hasFailed() ? quiet.window->reason() : std::string();
}

/// Fills the body of the scene with cells and presses its tools on it. Sets body and notes of the
/// scene.
std::string solveSolid(const ViewerOptions& options, ViewerScene& scene)
{
  SolidTools made;
  std::string error = makeSolidTools(options, scene, made);
  if (!error.empty())
  {
    return error;
  }
  const SolidSizes sizes = chooseSizes(scene.body, options.solidSpacing, made.widest);
  auto begin = std::chrono::steady_clock::now();
  vtkNew<vtkGradedBody> filled;
  error = fill(scene.body, sizes.spacing, options.fixedFaces, filled);
  if (!error.empty())
  {
    return error;
  }
  vtkNew<vtkGradedBody> coarser;
  const std::string lost = fillAgain(filled, coarser);
  const double filledIn = secondsSince(begin);
  begin = std::chrono::steady_clock::now();
  vtkNew<vtkElasticContactResponse> pressed;
  pressed->SetInputConnection(filled->GetOutputPort());
  if (lost.empty())
  {
    pressed->SetCoarserConnection(coarser->GetOutputPort());
  }
  else
  {
    scene.notes.push_back("no second mesh to estimate the error of the first: " + lost);
  }
  pressed->SetYoungsModulus(scene.youngsModulus);
  pressed->SetPoissonRatio(scene.poissonRatio);
  setSolidTerms(options, scene, pressed);
  pressed->SetSourceSpacing(sizes.sources);
  vtkSmartPointer<vtkPolyData> body = scene.body;
  vtkIdType solutions = 0;
  for (const std::size_t t : made.order)
  {
    setSolidTool(options, scene, made, t, pressed);
    pressed->SetSurfaceData(body);
    error = updateWithProgress(pressed, "the body is solved under " + scene.tools[t]);
    if (!error.empty())
    {
      return error;
    }
    solutions += pressed->GetNumberOfSolutions();
    const auto felt = vtkSmartPointer<vtkPolyData>::New();
    felt->ShallowCopy(pressed->GetOutput());
    body = felt;
  }
  scene.notes.push_back(joined("filled with ", filled->GetOutput()->GetNumberOfCells(),
    " tetrahedra of ", filled->GetOutput()->GetNumberOfPoints(), " nodes, ", shortly(sizes.spacing),
    " mm at the surface",
    options.solidSpacing == 0.0 ? " (chosen from its size and the tools)" : "", ", held at ",
    options.fixedFaces, ", in ", shortly(filledIn), " s; ", solutions, " points of it solved for, ",
    shortly(sizes.sources), " mm apart, and ", made.tools.size(),
    made.tools.size() == 1 ? " tool in " : " tools in ", shortly(secondsSince(begin)), " s"));
  scene.body = body;
  return {};
}
} // namespace

std::string attachSolidResponses(const ViewerOptions& options, ViewerScene& scene)
{
  return solveOrRead("solid", solidKey(options, scene), scene,
    [&options, &scene]() { return solveSolid(options, scene); });
}
} // namespace palpate

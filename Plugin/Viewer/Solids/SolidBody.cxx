// SPDX-License-Identifier: BSD-3-Clause
#include "SolidBody.h"

#include "BodyCache.h"
#include "Response/Files/CollectingWindow.h"
#include "Mechanics/Files/NumberText.h"
#include "Mechanics/FiniteStrain/StrainCorrection.h"
#include "Mechanics/JoinedText.h"
#include "Response/BodyConversion.h"
#include "ResponseSet.h"
#include "SolidResponse/Bodies/ChosenSpacing.h"
#include "SolvedCache.h"

#include "vtkElasticContactResponse.h"
#include "vtkGradedBody.h"
#include "vtkMassProperties.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace palpate
{
namespace
{
constexpr double UsualSources = 10000.0; ///< about a minute on two cores
/// The spacing is at least this fraction of the contact radius, if the shape of the body allows it.
constexpr double LeastOfContact = 0.5;
/// Sources are nodes, including the nodes in the middle of each edge.
constexpr double LeastOfSpacing = 0.5;
/// Ratio of the spacings of the second and the first mesh. The second mesh serves to estimate the
/// error of the first, at a sixth of its cost.
constexpr double CoarserRatio = 2.0;

double secondsSince(std::chrono::steady_clock::time_point begin)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The size of cells at the surface, and the distance of the source points.
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

/// The law of finite strain for a tool: the given one, or Neo-Hooke if it is tabulated for the
/// tool.
StrainLaw strainUnder(vtkContactTool* tool, const ViewerOptions& options, const ViewerScene& scene)
{
  if (options.strainGiven && !scene.terms.automatic)
  {
    return scene.terms.strain;
  }
  const StrainBodies bodies{ scene.poissonsRatio, scene.poissonsRatio };
  const bool isKnown = isStrainTabulated(*tool->GetKernel(), bodies, options.maximumDeflection);
  return { isKnown ? StrainModel::NeoHooke : StrainModel::Linear, 0.0 };
}

/// Cache key: everything that the responses depend on. The revision changes when the same input
/// gives other results.
std::string solidKey(const ViewerOptions& options, const ViewerScene& scene)
{
  constexpr int Revision = 10;
  return joined(Revision, solvedKey(options, scene), '|', shortestDecimals(options.solidSpacing),
    '|', options.fixedFaces, '|', options.strainGiven && !scene.terms.automatic, '|',
    static_cast<int>(scene.terms.strain.model), ':', scene.terms.strain.parameter,
    contentOf(scene.body));
}

/// Fills the body with tetrahedra. Returns "" or an error.
std::string fill(vtkPolyData* body, double spacing, const std::string& fixed, vtkGradedBody* filled)
{
  filled->SetInputData(body);
  filled->SetSurfaceSpacing(spacing);
  filled->SetFixedFaces(fixed);
  return updateQuietly(filled);
}

/// Fills the body with longer cells. Defects of the surface have already been reported for the
/// first mesh, so warnings are not repeated.
std::string fillAgain(vtkGradedBody* first, vtkGradedBody* coarser)
{
  coarser->SetInputData(first->GetInput());
  coarser->SetSurfaceSpacing(CoarserRatio * first->GetSurfaceSpacing());
  coarser->SetFixedFaces(first->GetFixedFaces());
  const QuietScope quiet;
  coarser->Update();
  return quiet.window->hasFailed() ? quiet.window->reason() : std::string();
}

/// Fills the body of the scene and presses its tools. Sets body and notes.
std::string solveSolid(const ViewerOptions& options, ViewerScene& scene)
{
  std::vector<vtkSmartPointer<vtkContactTool>> tools;
  std::vector<double> radii;
  for (const std::string& text : scene.tools)
  {
    tools.push_back(vtkSmartPointer<vtkContactTool>::New());
    if (!tools.back()->SetSpecification(text))
    {
      return "tool '" + text + "' is not known";
    }
    radii.push_back(tools.back()->GetKernel()->contactRadius(options.maximumDeflection));
  }
  // The tool with the widest contact is first, as the others use its solutions.
  std::vector<std::size_t> order(tools.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(),
    [&radii](std::size_t a, std::size_t b) { return radii[a] > radii[b]; });
  const SolidSizes sizes = chooseSizes(scene.body, options.solidSpacing, radii[order.front()]);
  auto begin = std::chrono::steady_clock::now();
  vtkNew<vtkGradedBody> filled;
  std::string error = fill(scene.body, sizes.spacing, options.fixedFaces, filled);
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
  pressed->SetPoissonRatio(scene.poissonsRatio);
  pressed->SetMaximumDeflection(options.maximumDeflection);
  pressed->SetErrorTolerance(scene.terms.errorTolerance);
  pressed->SetEdgeCorrection(scene.terms.edges);
  pressed->SetMaximumTilt(scene.terms.tilt);
  for (std::size_t i = 0; i < scene.relaxation.count; ++i)
  {
    pressed->AddRelaxation(scene.relaxation.strength[i], scene.relaxation.time[i]);
  }
  pressed->SetSourceSpacing(sizes.sources);
  vtkSmartPointer<vtkPolyData> body = scene.body;
  vtkIdType solutions = 0;
  for (const std::size_t t : order)
  {
    const StrainLaw law = strainUnder(tools[t], options, scene);
    pressed->SetStrainModel(static_cast<int>(law.model));
    pressed->SetOgdenExponent(law.parameter);
    pressed->SetDemirayExponent(law.parameter);
    pressed->SetTool(tools[t]);
    pressed->SetResponseName(responseName(t));
    pressed->SetSurfaceData(body);
    error = updateQuietly(pressed);
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
    shortly(sizes.sources), " mm apart, and ", tools.size(),
    tools.size() == 1 ? " tool in " : " tools in ", shortly(secondsSince(begin)), " s"));
  scene.body = body;
  return {};
}
} // namespace

std::string attachSolidResponses(const ViewerOptions& options, ViewerScene& scene)
{
  std::vector<std::string> arrays;
  for (std::size_t i = 0; i < scene.tools.size(); ++i)
  {
    arrays.push_back(responseName(i) + "Force");
  }
  const std::string file = cachePlace("solid", solidKey(options, scene), ".vtp");
  if (const vtkSmartPointer<vtkPolyData> solved = readSolved(file, arrays))
  {
    scene.body = solved;
    scene.notes.push_back("its solid's responses taken from the cache " + file);
  }
  else
  {
    const std::string error = solveSolid(options, scene);
    if (!error.empty())
    {
      return error;
    }
    const std::string fault = keepSolved(scene.body, file);
    if (!fault.empty())
    {
      scene.notes.push_back("cache not used: " + fault);
    }
  }
  scene.stored = true;
  scene.modelReason = responseText(scene.body, "Response", ResponseArray::Model);
  return {};
}
} // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/YieldSolution.h"

#include "Response/BodyField.h"
#include "Mechanics/Files/NumberText.h"
#include "Mechanics/Files/SolutionCache.h"
#include "Mechanics/JoinedText.h"
#include "Response/Curves/PointNormals.h"
#include "Response/FilterStage.h"
#include "SolidResponse/Bodies/ChosenSpacing.h"
#include "SolidResponse/Bodies/CoarseSurface.h"
#include "SolidResponse/Bodies/CoarserBody.h"
#include "SolidResponse/Bodies/SolvedBody.h"
#include "SolidResponse/Bodies/StandingSide.h"
#include "SolidResponse/Bodies/SurfaceYield.h"
#include "SolidResponse/Mesher/GradedFilling.h"
#include "SolidResponse/Mesher/PreparedSurface.h"

#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace palpate
{
namespace
{
constexpr int LeastCells = 100; ///< smallest number of cells of a request
// Smallest spacing of the cells, relative to the contact radius.
constexpr double LeastOfContact = 0.25;
// Distance of the solved points, in spacings of the cells. The solved points include mid-edge
// nodes.
constexpr double LeastOfSpacing = 0.5;
constexpr double PointsPerCell = 0.15; // number of solved points per cell
// Ratio of the cell length of the second mesh to the cell length of the first mesh.
constexpr double CoarserRatio = 2.0;
/// A surface that has more triangles than this, or that cannot be filled, is replaced by a coarse
/// surface. The voxels of the coarse surface have this fraction of the cells' spacing.
constexpr vtkIdType MostTriangles = 300000;
constexpr double VoxelRatio = 0.25;
/// Number of contact radii of a solution. Each radius is half of the previous one. Therefore a
/// solution is valid from its largest radius down to an eighth of this radius. The cache is
/// searched for solutions whose largest radius is up to three powers of two above the needed
/// radius.
constexpr std::size_t RadiusCount = 4;
// Progress at the end of each step, as fractions of the work.
constexpr double Filled = 0.25;
constexpr double Solved = 0.85;
constexpr double Compared = 0.9;
constexpr double Fitted = 0.92;

/// Modes are used only for display. They are rounded to multiples of this fraction of the largest
/// value, which keeps the files of the cache small.
constexpr double ModeStep = 1e-5;

/// Revision of the cached solutions. It must be increased if a change of the code gives other
/// values for the same input.
constexpr int Revision = 3;

std::string bytesOf(vtkPolyData* body)
{
  std::vector<double> places;
  std::vector<vtkIdType> corners;
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    const double* place = body->GetPoint(i);
    places.insert(places.end(), place, place + 3);
  }
  vtkNew<vtkIdList> triangle;
  for (vtkIdType t = 0; t < body->GetNumberOfCells(); ++t)
  {
    body->GetCellPoints(t, triangle);
    corners.insert(corners.end(), triangle->begin(), triangle->end());
  }
  return std::string(reinterpret_cast<const char*>(places.data()), places.size() * sizeof(double)) +
    std::string(reinterpret_cast<const char*>(corners.data()), corners.size() * sizeof(vtkIdType));
}

/// Returns the contact radii of a solution in descending order. The first radius is a power of two.
std::vector<double> radiiFrom(double largest)
{
  std::vector<double> radii;
  for (std::size_t k = 0; k < RadiusCount; ++k)
  {
    radii.push_back(std::ldexp(largest, -static_cast<int>(k)));
  }
  return radii;
}

double powerOfTwoFrom(double radius)
{
  return std::exp2(std::ceil(std::log2(radius)));
}

std::string keyOf(
  const std::string& body, const YieldRequest& request, const std::string& fixed, double largest)
{
  return joined(Revision, ' ', body, ' ', shortestDecimals(request.poissonRatio), ' ', fixed, ' ',
    request.cells, ' ', shortestDecimals(largest));
}

/// Returns the compliances for E = 1 MPa, the errors and the status as one array. The modes are
/// appended later.
std::vector<double> packed(const SurfaceYield& yield)
{
  std::vector<double> values(yield.compliance);
  values.insert(values.end(), yield.error.begin(), yield.error.end());
  values.insert(values.end(), yield.status.begin(), yield.status.end());
  return values;
}

/// Appends the modes of a body with E = 1 MPa at the points of `body`, and the signs of the modes.
/// The values are zero if the body has no modes. Nothing is appended after an abort.
void appendModes(SolvedBody& solved, vtkUnstructuredGrid* grid, vtkPolyData* body,
  vtkFloatArray* normals, const FilterStage& stage, std::vector<double>& values)
{
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(body->GetPoints());
  bare->SetPolys(body->GetPolys());
  solved.attachModesTo(bare, normals, grid, stage);
  if (isAborted(stage.filter))
  {
    return;
  }
  vtkDataArray* signs = bare->GetFieldData()->GetArray(GlobalModeSignArray);
  for (std::size_t k = 0; k < MostGlobalModes; ++k)
  {
    vtkDataArray* mode = bare->GetPointData()->GetArray(globalModeName(k).c_str());
    const double largest = mode ? mode->GetMaxNorm() : 0.0;
    // The scale is a power of ten, because this gives short decimal numbers.
    const double scale =
      largest > 0.0 ? std::pow(10.0, std::ceil(-std::log10(ModeStep * largest))) : 1.0;
    for (vtkIdType i = 0; i < 3 * body->GetNumberOfPoints(); ++i)
    {
      const double value = mode ? mode->GetComponent(i / 3, static_cast<int>(i % 3)) : 0.0;
      values.push_back(std::round(scale * value) / scale);
    }
  }
  for (std::size_t k = 0; k < MostGlobalModes; ++k)
  {
    values.push_back(signs ? signs->GetComponent(static_cast<vtkIdType>(k), 0) : 1.0);
  }
}

/// A body filled with tetrahedra, and the same body filled with longer tetrahedra. The second
/// filling gives the error of the elements.
struct FilledBody
{
  double area = 0.0;    ///< area of the surface, mm²
  double spacing = 0.0; ///< spacing of the cells at the surface, mm
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkUnstructuredGrid> coarser; ///< without cells if the body is too thin for longer cells
};

double spacingOf(const ClosedSurface& closed, int cells, double radius)
{
  const double wanted =
    std::max(std::sqrt(CellsPerSquare * closed.area / cells), LeastOfContact * radius);
  return std::min(wanted, LargestOfBody * std::cbrt(closed.volume));
}

/// Fills the body. If the body has too much detail or cannot be filled, a coarse surface of the
/// body is filled instead.
std::string fill(vtkPolyData* body, int cells, double radius, const FilterStage& stage,
  BodyYield& made, FilledBody& filled)
{
  PreparedSurface prepared;
  const std::string open = takeSurface(body, prepared);
  if (!open.empty())
  {
    return open;
  }
  filled.area = prepared.closed.area;
  filled.spacing = spacingOf(prepared.closed, cells, radius);
  GradedCells graded;
  graded.spacing = filled.spacing;
  graded.fixedFaces = made.heldAt;
  GradedReport report;
  vtkSmartPointer<vtkPolyData> surface = body;
  std::string fault = "it has too many triangles";
  if (body->GetNumberOfCells() <= MostTriangles)
  {
    fault = fillGraded(body, graded, stage, filled.grid, report);
    made.warnings = report.warnings;
  }
  if (!fault.empty() && !isAborted(stage.filter))
  {
    surface = coarseSurface(body, VoxelRatio * filled.spacing);
    fault = fillGraded(surface, graded, stage, filled.grid, report);
    made.warnings.clear();
  }
  if (fault.empty() && !isAborted(stage.filter))
  {
    graded.spacing *= CoarserRatio;
    GradedReport ignored;
    const std::string lost = fillGraded(surface, graded, {}, filled.coarser, ignored);
    if (!lost.empty() || !checkCoarser(filled.grid, filled.coarser).empty())
    {
      filled.coarser->Initialize();
    }
  }
  return fault;
}

/// Solves a body with E = 1 MPa for contact radii up to `largest` (mm). Returns "" or an error
/// message. `values` stays empty after an abort.
std::string solve(vtkPolyData* body, const YieldRequest& request, double largest,
  vtkAlgorithm* filter, BodyYield& made, std::vector<double>& values)
{
  FilledBody filled;
  std::string fault =
    fill(body, request.cells, largest, FilterStage{ filter, 0.0, Filled }, made, filled);
  if (!fault.empty() || isAborted(filter))
  {
    return fault;
  }
  SolveRequest solution;
  solution.factor.material = { 1.0, request.poissonRatio };
  solution.radius = largest;
  solution.spacing = std::max(
    LeastOfSpacing * filled.spacing, std::sqrt(filled.area / (PointsPerCell * request.cells)));
  solution.isEven = true;
  SolveCost cost;
  SolvedBody solved;
  fault = solved.solve(filled.grid, solution, FilterStage{ filter, Filled, Solved }, cost);
  CoarserBody coarser;
  if (fault.empty() && !cost.ended && filled.coarser->GetNumberOfCells() > 0)
  {
    fault = coarser.compare(
      filled.coarser, solution, solved, FilterStage{ filter, Solved, Compared }, cost);
  }
  if (!fault.empty() || cost.ended)
  {
    return fault;
  }
  vtkNew<vtkFloatArray> normals;
  vtkNew<vtkUnsignedCharArray> status;
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(body->GetNumberOfPoints());
  status->SetNumberOfValues(body->GetNumberOfPoints());
  fault = fillPointNormals(body, normals, status);
  const LandmarkKernels* landmarks = nullptr;
  if (fault.empty())
  {
    landmarks = solved.landmarks(FilterStage{ filter, Compared, Fitted });
  }
  if (landmarks)
  {
    const YieldField field(solved.surface(filled.grid), *landmarks, coarser.difference());
    std::vector<double> found =
      packed(yieldOf(body, normals->GetPointer(0), field, radiiFrom(largest)));
    appendModes(solved, filled.grid, body, normals, FilterStage{ filter, Fitted, 1.0 }, found);
    if (!isAborted(filter))
    {
      values = std::move(found);
    }
  }
  return fault;
}

/// Interpolates the values for the contact radius of the request. The interpolation is linear in
/// the square of the radius, between the radii of the solution.
void takeRadius(const std::vector<double>& values, std::size_t count, const YieldRequest& request,
  double largest, BodyYield& made)
{
  const std::vector<double> radii = radiiFrom(largest);
  std::size_t k = 0; // the requested radius is between the radii k and k + 1
  while (k + 2 < radii.size() && request.radius < radii[k + 1])
  {
    ++k;
  }
  const double low = radii[k + 1] * radii[k + 1];
  const double high = radii[k] * radii[k];
  const double part = std::clamp((request.radius * request.radius - low) / (high - low), 0.0, 1.0);
  const double* compliance = values.data();
  const double* error = compliance + count * radii.size();
  const double* status = error + count * radii.size();
  const auto between = [&](const double* of, std::size_t i)
  {
    return (part * of[k * count + i] + (1.0 - part) * of[(k + 1) * count + i]) /
      request.youngsModulus;
  };
  for (std::size_t i = 0; i < count; ++i)
  {
    made.compliance.push_back(between(compliance, i));
    made.error.push_back(between(error, i));
    made.status.push_back(static_cast<unsigned char>(status[i]));
  }
  const double* modes = status + count;
  const double* signs = modes + 3 * MostGlobalModes * count;
  const double scale = 1.0 / std::sqrt(request.youngsModulus);
  std::transform(modes, signs, std::back_inserter(made.modes),
    [scale](double value) { return static_cast<float>(scale * value); });
  made.signs.assign(signs, signs + MostGlobalModes);
}

/// Returns the number of values of a solution for a body with `count` points.
std::size_t numbersFor(std::size_t count)
{
  return (2 * RadiusCount + 1 + 3 * MostGlobalModes) * count + MostGlobalModes;
}
} // namespace

std::string checkYieldRequest(const YieldRequest& request)
{
  FactorRequest factor;
  factor.material = { request.youngsModulus, request.poissonRatio };
  const std::string fault = checkFactorRequest(factor);
  if (!fault.empty())
  {
    return fault;
  }
  if (!(request.radius > 0.0 && std::isfinite(request.radius)))
  {
    return joined("ContactRadius must be positive and finite (mm), but is ", request.radius);
  }
  return request.cells >= LeastCells
    ? std::string()
    : joined("NumberOfCells must be at least ", LeastCells, ", but is ", request.cells);
}

std::string solveYield(
  vtkPolyData* body, const YieldRequest& request, vtkAlgorithm* filter, BodyYield& made)
{
  made = {};
  made.heldAt = request.fixed.empty() ? standingSide(body) : request.fixed;
  const std::string content = joined(body->GetNumberOfPoints(), ' ', digest(bytesOf(body)));
  const auto count = static_cast<std::size_t>(body->GetNumberOfPoints());
  const double least = powerOfTwoFrom(request.radius);
  // A stored solution for wider contacts may also be valid.
  double largest = least;
  std::vector<double> values;
  for (std::size_t k = 0; values.empty() && k < RadiusCount; ++k)
  {
    largest = std::ldexp(least, static_cast<int>(k));
    values =
      readSolution("compliance", keyOf(content, request, made.heldAt, largest), numbersFor(count));
  }
  if (values.empty())
  {
    largest = least;
    const std::string fault = solve(body, request, largest, filter, made, values);
    if (!fault.empty() || values.empty())
    {
      return fault;
    }
    writeSolution("compliance", keyOf(content, request, made.heldAt, largest), values);
  }
  takeRadius(values, count, request, largest, made);
  return {};
}
} // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/SolvedBody.h"

#include "Contact/ResponseContract.h"
#include "Mechanics/Checked.h"
#include "Solids/Curves/ShapedResponse.h"
#include "Mechanics/FiniteStrain/StrainCorrection.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Numerics/AvailableMemory.h"
#include "Mechanics/Tools/AxisymmetricTool.h"
#include "SolidResponse/Bodies/FinerSurface.h"
#include "SolidResponse/Bodies/MotionArrays.h"
#include "SolidResponse/Bodies/VolumeConversion.h"
#include "Response/Curves/PointNormals.h"
#include "vtkContactTool.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace palpate
{
namespace
{
constexpr double FactorisedShare = 0.17; // fraction of the progress that the factorisation takes
// Fraction of the progress for the kernel fits, on a finer surface.
constexpr double FittedShare = 0.5;
// Ratio of contact radii; it is √2 on a thin layer that can expand sideways.
constexpr double WiderThanHalfSpace = 1.42;

/// Finds the pressed points of the surface. These are all points, or the points at which the grid's
/// point array `Pressed` is not 0. Returns "" or an error message about this array.
std::string findPressed(
  vtkUnstructuredGrid* grid, const BodySurface& surface, std::vector<std::int32_t>& points)
{
  points.clear();
  vtkDataArray* pressed = grid->GetPointData()->GetArray("Pressed");
  if (pressed &&
    (pressed->GetNumberOfComponents() != 1 ||
      pressed->GetNumberOfTuples() != grid->GetNumberOfPoints()))
  {
    return joined("Wrong input: point array 'Pressed' must have 1 component and ",
      grid->GetNumberOfPoints(), " tuples, but has ", pressed->GetNumberOfComponents(), " and ",
      pressed->GetNumberOfTuples());
  }
  for (std::int32_t i = 0; i < surface.pointTotal(); ++i)
  {
    if (!pressed || pressed->GetComponent(surface.node(i), 0) != 0.0)
    {
      points.push_back(i);
    }
  }
  return points.empty() ? "Wrong input: point array 'Pressed' is 0 on the whole surface"
                        : std::string();
}
} // namespace

/// A body and the regular part H of its Green function, and the input from which they were
/// computed.
struct SolvedBody::Kept
{
  ElasticBody Body;
  RegularGreen Green{ Body };
  std::unique_ptr<LandmarkKernels> Landmarks; ///< null if the kernels were not requested
  SurfaceMotion Motion;                       ///< without points if the motion was not requested
  double Spacing = 0.0;                       ///< distance of the sources, mm
  bool IsEven = false;
  /// Contact radius for which the body is solved, mm; 0 if nothing is solved yet.
  double Radius = 0.0;
  double FactorMemory = 0.0; ///< memory of the factor, MiB
  double GreenMemory = 0.0;  ///< memory of H, MiB
  /// Copy of the grid. It keeps the arrays alive, so that no new array can have the address of a
  /// freed array.
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  vtkMTimeType GridTime = 0;
  FactorRequest Factor;

  bool isOf(vtkUnstructuredGrid* grid, const FactorRequest& other) const
  {
    return this->GridTime == grid->GetMTime() && this->Factor.young == other.young &&
      this->Factor.poisson == other.poisson && this->Factor.solver == other.solver &&
      this->Factor.material.youngsModulus == other.material.youngsModulus &&
      this->Factor.material.poissonRatio == other.material.poissonRatio;
  }
};

SolvedBody::SolvedBody() = default;
SolvedBody::~SolvedBody() = default;

double neededRadius(vtkContactTool* tool, double deflection)
{
  return WiderThanHalfSpace * tool->GetKernel()->contactRadius(deflection);
}

std::string checkShapedRequest(const LawRequest& request)
{
  return firstFault([&] { return checkRequest(request); },
    [&] { return checkToolDepth(*request.tool->GetKernel(), request.deflection); });
}

std::string checkLength(const char* property, double length)
{
  return length >= 0.0 && std::isfinite(length)
    ? std::string()
    : joined(property, " must be 0 or positive (mm), but is ", length);
}

std::string SolvedBody::solve(
  vtkUnstructuredGrid* grid, const SolveRequest& request, const FilterStage& stage, SolveCost& cost)
{
  const bool isSame = this->Current && this->Current->isOf(grid, request.factor);
  if (isSame && this->Current->Radius >= request.radius &&
    this->Current->Spacing == request.spacing && this->Current->IsEven == request.isEven)
  {
    return {};
  }
  const double middle = stage.from + FactorisedShare * (stage.to - stage.from);
  std::string fault;
  if (!isSame)
  {
    // This frees the former factor before the new one is computed.
    this->Current = std::make_unique<Kept>();
    fault = factoriseBody(grid, request.factor, FilterStage{ stage.filter, stage.from, middle },
      this->Current->Body, cost.memory, cost.ended);
    if (!fault.empty() || cost.ended)
    {
      this->Current.reset();
      return fault;
    }
    this->Current->Grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    this->Current->Grid->ShallowCopy(grid);
    this->Current->GridTime = grid->GetMTime();
    this->Current->Factor = request.factor;
    this->Current->FactorMemory = cost.memory;
  }
  Kept& kept = *this->Current;
  std::vector<std::int32_t> points;
  fault = findPressed(grid, kept.Body.surface(), points);
  if (!fault.empty())
  {
    return fault;
  }
  const double bytes = kept.Green.memoryForecast(points, request.radius, request.spacing);
  cost.memory += bytes / Mebibyte;
  kept.GreenMemory = bytes / Mebibyte;
  const double allowed = allowedMemory(request.factor.memoryLimit);
  if (bytes > allowed)
  {
    return joined("The solutions at ", points.size(), " points for contacts of ", request.radius,
      " mm need about ", bytes / Mebibyte, " MiB, more than ", allowed / Mebibyte,
      " MiB: give a smaller Maximum Deflection, a smaller tool or a coarser mesh");
  }
  kept.Radius = 0.0;
  kept.Landmarks.reset();
  kept.Motion = {};
  fault = kept.Green.solve(points, request.radius, FilterStage{ stage.filter, middle, stage.to },
    request.spacing, request.isEven);
  cost.ended = isAborted(stage.filter);
  if (cost.ended)
  {
    return {};
  }
  if (fault.empty())
  {
    kept.Radius = request.radius;
    kept.Spacing = request.spacing;
    kept.IsEven = request.isEven;
    cost.solutions = static_cast<vtkIdType>(kept.Green.sources());
  }
  return prefixed("Wrong input: ", fault);
}

const RegularGreen& SolvedBody::green() const
{
  return this->Current->Green;
}

double SolvedBody::memory() const
{
  return this->Current->FactorMemory + this->Current->GreenMemory;
}

const LandmarkKernels* SolvedBody::landmarks(const FilterStage& stage)
{
  std::unique_ptr<LandmarkKernels>& kept = this->Current->Landmarks;
  if (!kept)
  {
    kept = std::make_unique<LandmarkKernels>(this->Current->Green, stage);
    if (!kept->isComplete())
    {
      kept.reset();
    }
  }
  return kept.get();
}

vtkSmartPointer<vtkPolyData> SolvedBody::surface(vtkUnstructuredGrid* grid) const
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  convertSurface(this->Current->Body.surface(), grid, surface);
  return surface;
}

std::string SolvedBody::respond(vtkPolyData* surface, vtkContactTool* tool,
  const ShapedTerms& terms, const FilterStage& stage, ResponseStorage& storage,
  MadeResponse& made) const
{
  const std::string fault = fillPointNormals(surface, storage.Normal, storage.Status);
  if (!fault.empty())
  {
    return "Wrong input: " + fault;
  }
  for (vtkIdType i = 0; i < storage.Status->GetNumberOfValues(); ++i)
  {
    if (!this->Current->Green.disc(static_cast<std::int32_t>(i)))
    {
      storage.Status->SetValue(i, static_cast<unsigned char>(ResponseStatus::OutOfReach));
    }
  }
  made = shapedResponse(*tool->GetKernel(), this->Current->Green, terms, storage.spans(), stage);
  return {};
}

std::string SolvedBody::respondOn(vtkPolyData* finer, vtkUnstructuredGrid* grid,
  vtkContactTool* tool, const ShapedTerms& terms, const FilterStage& stage,
  ResponseStorage& storage, MadeResponse& made)
{
  const std::string fault = fillPointNormals(finer, storage.Normal, storage.Status);
  if (!fault.empty())
  {
    return "Wrong input: Surface: " + fault;
  }
  const double fitted =
    this->Current->Landmarks ? stage.from : stage.from + FittedShare * (stage.to - stage.from);
  const LandmarkKernels* known = this->landmarks(FilterStage{ stage.filter, stage.from, fitted });
  if (!known)
  {
    return {};
  }
  const vtkSmartPointer<vtkPolyData> solid = this->surface(grid);
  const FinerSurface surface(
    finer, storage.Normal->GetPointer(0), solid, *known, neededRadius(tool, terms.range));
  made = shapedResponse(*tool->GetKernel(), *known, surface.view(), terms, storage.spans(),
    FilterStage{ stage.filter, fitted, stage.to });
  return {};
}

std::string SolvedBody::findStrain(vtkContactTool* tool, const StrainLaw& law, double deflection,
  const FilterStage& stage, std::unique_ptr<StrainCorrection>& strain) const
{
  const std::string fault = checkStrainEnergy(law.model, law.parameter);
  if (!fault.empty())
  {
    return fault;
  }
  const ElasticBody& body = this->Current->Body;
  StrainBodies bodies{ body.material(0).poissonRatio, body.material(0).poissonRatio };
  for (std::int32_t e = 1; e < body.mesh().elementTotal(); ++e)
  {
    bodies.leastRatio = std::min(bodies.leastRatio, body.material(e).poissonRatio);
    bodies.mostRatio = std::max(bodies.mostRatio, body.material(e).poissonRatio);
  }
  return makeStrainCorrection(*tool->GetKernel(), law, bodies, deflection, stage, strain);
}

const SurfaceMotion& SolvedBody::motion(const FilterStage& stage)
{
  if (this->Current->Motion.points.empty())
  {
    this->Current->Motion = surfaceMotion(this->Current->Green, MostGlobalModes, stage);
  }
  return this->Current->Motion;
}

void SolvedBody::attachMotionTo(vtkPolyData* surface, const FilterStage& stage)
{
  const SurfaceMotion& motion = this->motion(stage);
  if (!motion.points.empty())
  {
    attachMotion(motion, surface);
  }
}

void SolvedBody::attachMotionTo(
  vtkPolyData* finer, vtkFloatArray* normals, vtkUnstructuredGrid* grid, const FilterStage& stage)
{
  const SurfaceMotion& motion = this->motion(stage);
  if (!motion.points.empty())
  {
    attachMotion(motion, this->surface(grid), normals, finer);
  }
}

void SolvedBody::attachModesTo(
  vtkPolyData* finer, vtkFloatArray* normals, vtkUnstructuredGrid* grid, const FilterStage& stage)
{
  const SurfaceMotion& motion = this->motion(stage);
  if (!motion.points.empty())
  {
    attachModes(motion.modes, this->surface(grid), normals, finer);
  }
}
} // namespace palpate

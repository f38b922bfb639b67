// SPDX-License-Identifier: BSD-3-Clause
#ifndef SolvedBody_h
#define SolvedBody_h

#include "Laws/ResponseFiller.h"
#include "Solids/TrueShape/SurfaceMotion.h"
#include "SolidResponse/Bodies/FactorisedBody.h"
#include "Response/BodyLaws.h"
#include "Response/Curves/ResponseStorage.h"
#include "Response/FilterStage.h"

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <memory>
#include <string>

class vtkContactTool;
class vtkFloatArray;
class vtkPolyData;

namespace palpate
{
class LandmarkKernels;
class StrainCorrection;
struct ShapedTerms;
struct StrainLaw;
/// The points and contacts of a body to solve for.
struct SolveRequest
{
  FactorRequest factor;
  double radius = 0.0;  ///< of the widest contact, mm
  double spacing = 0.0; ///< of the points that are solved for, mm; 0: all
};

/// The cost of a solution.
struct SolveCost
{
  double memory = 0.0;     ///< MiB, known also where that was refused
  vtkIdType solutions = 0; ///< 0: nothing had to be solved
  bool ended = false;      ///< by an abort
};

/// The contact radius to solve for, for a tool at a depth (mm) on any body.
double neededRadius(vtkContactTool* tool, double deflection);

/// What is wrong with the settings of a response of true shape, tool and depth among them, or "".
std::string checkShapedRequest(const LawRequest& request);

/// What is wrong with a length (mm) that may be 0, by the name of its property, or "".
std::string checkLength(const char* property, double length);

/**
 * A body and its H (RegularGreen), which filters keep from one tool to the next: factorised and
 * solved again only when the grid, its material or the solver changes, or a contact gets wider. If
 * the grid has a point array `Pressed`, only for contacts where that is not 0.
 */
class SolvedBody
{
public:
  SolvedBody();
  ~SolvedBody();

  /// Factorises and solves what the request needs and is not there yet. Returns what is wrong, or
  /// "".
  std::string solve(vtkUnstructuredGrid* grid, const SolveRequest& request,
    const FilterStage& stage, SolveCost& cost);

  const RegularGreen& green() const;
  double memory() const; ///< estimate of what is kept, MiB

  /// Its kernels at the sources, fitted once for all tools; null after an abort.
  const LandmarkKernels* landmarks(const FilterStage& stage);

  /// The surface, with the grid's point arrays and `OriginalPointIds`.
  vtkSmartPointer<vtkPolyData> surface(vtkUnstructuredGrid* grid) const;

  /// Fills `storage`, of as many points as `surface` has, with the tool's response. Returns what is
  /// wrong, or ""; incomplete after an abort.
  std::string respond(vtkPolyData* surface, vtkContactTool* tool, const ShapedTerms& terms,
    const FilterStage& stage, ResponseStorage& storage, MadeResponse& made) const;

  /// The same at the points of another surface of the body, which has passed checkTriangles and may
  /// be finer (FinerSurface).
  std::string respondOn(vtkPolyData* finer, vtkUnstructuredGrid* grid, vtkContactTool* tool,
    const ShapedTerms& terms, const FilterStage& stage, ResponseStorage& storage,
    MadeResponse& made);

  /// Finds the correction by finite strain for a contact of the tool on the body's materials.
  /// Returns what is wrong, or ""; null after an abort.
  std::string findStrain(vtkContactTool* tool, const StrainLaw& law, double deflection,
    const FilterStage& stage, std::unique_ptr<StrainCorrection>& strain) const;

  /// Attaches how the body moves (MotionArrays.h) to its `surface`, or to a finer one with these
  /// normals. Found once for all tools; nothing after an abort.
  void attachMotionTo(vtkPolyData* surface, const FilterStage& stage);
  void attachMotionTo(vtkPolyData* finer, vtkFloatArray* normals, vtkUnstructuredGrid* grid,
    const FilterStage& stage);

private:
  struct Kept;
  const SurfaceMotion& motion(const FilterStage& stage);
  std::unique_ptr<Kept> Now;
};
} // namespace palpate

#endif

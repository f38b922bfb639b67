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
/// The points and contact radii for which a body is solved.
struct SolveRequest
{
  FactorRequest factor;
  double radius = 0.0;  ///< radius of the widest contact, mm
  double spacing = 0.0; ///< distance of the solved points, mm; 0 selects all points
  /// Whether the solved points are not denser near edges (RegularGreen::solve).
  bool isEven = false;
};

/// The cost of a solution.
struct SolveCost
{
  double memory = 0.0;     ///< memory, MiB, also set if the solution was refused
  vtkIdType solutions = 0; ///< number of solutions; 0 if nothing had to be solved
  bool ended = false;      ///< whether an abort ended the work
};

/// Returns the contact radius (mm) for which a body must be solved, if the tool is pressed to a
/// depth of `deflection` (mm).
double neededRadius(vtkContactTool* tool, double deflection);

/// Checks the settings of a response of the true shape, including tool and depth. Returns "" or an
/// error message.
std::string checkShapedRequest(const LawRequest& request);

/// Checks a length (mm). Returns "", or an error message with the name `property` if the length is
/// negative or not finite.
std::string checkLength(const char* property, double length);

/**
 * A body and the regular part H of its Green function (RegularGreen). Filters keep the object from
 * one tool to the next. The body is factorised and solved again only if the grid, its material or
 * the solver changes, or if a contact is wider than all previous contacts. If the grid has a point
 * array `Pressed`, the body is solved only for the points where it is not 0.
 */
class SolvedBody
{
public:
  SolvedBody();
  ~SolvedBody();

  /// Factorises and solves the parts of the request that are missing. Returns "" or an error
  /// message.
  std::string solve(vtkUnstructuredGrid* grid, const SolveRequest& request,
    const FilterStage& stage, SolveCost& cost);

  const RegularGreen& green() const;
  double memory() const; ///< Estimated memory of the stored data, MiB.

  /// Returns the kernels at the solved points. They are fitted once for all tools. Returns null
  /// after an abort.
  const LandmarkKernels* landmarks(const FilterStage& stage);

  /// Returns the surface with the point arrays of the grid and `OriginalPointIds`.
  vtkSmartPointer<vtkPolyData> surface(vtkUnstructuredGrid* grid) const;

  /// Fills `storage` with the response of the tool. `storage` has as many points as `surface`.
  /// Returns "" or an error message. After an abort, `storage` is incomplete.
  std::string respond(vtkPolyData* surface, vtkContactTool* tool, const ShapedTerms& terms,
    const FilterStage& stage, ResponseStorage& storage, MadeResponse& made) const;

  /// Same as respond(), but at the points of another surface of the body. This surface must have
  /// passed checkTriangles and may be finer (FinerSurface).
  std::string respondOn(vtkPolyData* finer, vtkUnstructuredGrid* grid, vtkContactTool* tool,
    const ShapedTerms& terms, const FilterStage& stage, ResponseStorage& storage,
    MadeResponse& made);

  /// Finds the correction for finite strain for a contact of the tool with the body's materials.
  /// Returns "" or an error message. `strain` is null after an abort.
  std::string findStrain(vtkContactTool* tool, const StrainLaw& law, double deflection,
    const FilterStage& stage, std::unique_ptr<StrainCorrection>& strain) const;

  /// Attaches the motion of the body (MotionArrays.h) to its surface, or to a finer surface with
  /// the point normals `normals`. The motion is computed once for all tools. Nothing is attached
  /// after an abort.
  void attachMotionTo(vtkPolyData* surface, const FilterStage& stage);
  void attachMotionTo(vtkPolyData* finer, vtkFloatArray* normals, vtkUnstructuredGrid* grid,
    const FilterStage& stage);

  /// Attaches only the modes of the motion to a finer surface.
  void attachModesTo(vtkPolyData* finer, vtkFloatArray* normals, vtkUnstructuredGrid* grid,
    const FilterStage& stage);

private:
  struct Kept;
  const SurfaceMotion& motion(const FilterStage& stage);
  std::unique_ptr<Kept> Current;
};
} // namespace palpate

#endif

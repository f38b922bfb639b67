// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_StrainCorrection_h
#define palpate_StrainCorrection_h

#include "Mechanics/FiniteStrain/StrainLaw.h"
#include "Mechanics/FiniteStrain/StrainTable.h"
#include "Mechanics/Layers/LayerStack.h"
#include "Mechanics/Layers/StackKernels.h"
#include "Mechanics/PalpateExport.h"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace palpate
{
class AxisymmetricTool;

/// The range of bodies for which a correction is created.
struct StrainBodies
{
  double leastRatio = 0.45; ///< Poisson's ratio
  double mostRatio = 0.45;
  bool hasHalfSpace = true;
  double thinnest = 0.0; ///< layer thickness, mm; 0 if there are no layers
  double thickest = 0.0;
  LayerBase base = LayerBase::Bonded;
  /// The stack, if the layer is the top layer of a stack; `second` is the thickness of its second
  /// layer.
  LayerStack stack = {};
  ThicknessSpan second = { 0.0, 0.0 };
};

/**
 * The effect of finite strain on the force of one tool at a given depth. The exact force at small
 * strain is multiplied by c = F_finite/F_small. The stiffness becomes c k_small + F_small dc/dδ.
 *
 * Stored results of the solver are available for a Neo-Hooke body
 * - on a half-space under a sphere (to δ = R), a flat end (with its rim rounded by a tenth of the
 *   radius, to δ = 1.3 R) and a cone (45° to 75°);
 * - on a bonded layer of half to four radii under a sphere (to δ = h/2);
 * - on bonded layers of two radii or more under a sphere and a flat end (to 0.7 to 1.2 radii).
 *
 * At larger depths the error increases (NeoHookeTables.h).
 *
 * All other cases are solved numerically, at eight depths, at four Poisson's ratios (or at the
 * single one that occurs), and at thicknesses (in a stack, of its first two layers) whose
 * successive ratio is at most 2. On a rigid base the depths end at 0.7 of the total thickness,
 * beyond which the error increases. A curve takes 3 s to a minute on all threads; it is bit for bit
 * the same for any number of threads. Results are cached in $PALPATE_CACHE, else
 * $XDG_CACHE_HOME/palpate, else
 * ~/.cache/palpate. If PALPATE_CACHE is set to an empty text, the cache is off.
 *
 * All layers of a stack have the same strain law, each layer with its own modulus and Poisson's
 * ratio. They are bonded to each other; the rigid base may slip. Layers that slide on each other
 * are rejected, because the two sides of the interface move apart, which the solver's mesh cannot
 * represent.
 *
 * For Poisson's ratios above 0.495, c is the value at 0.495, with an additional error. A tool with
 * a corner is solved with a fillet of a tenth of the contact radius, and of a larger fraction at
 * larger depths (FiniteOverSmall.h). An error of 1 % is added for the fillet, because a fillet of
 * half the size changes c by up to 0.5 %. Can be used from any number of threads.
 */
class PALPATE_EXPORT StrainCorrection
{
public:
  using Value = StrainFactor;

  /// Returns c at `depth`, the depth of the tool at small strain, mm. `thickness` (mm) is 0 for a
  /// half-space; `second` (mm) is the thickness of a stack's second layer. Takes less than 1 µs.
  Value at(double depth, double poissonRatio, double thickness, double second = 0.0) const
  {
    return this->course(poissonRatio, thickness, second).at(depth);
  }

  /// The correction on one body. It is faster than StrainCorrection::at() if many depths are
  /// evaluated.
  class Course
  {
  public:
    Value at(double depth) const;

  private:
    friend class StrainCorrection;
    StrainTable::Course Table;
    bool HasTable = false;
    double More = 0.0; ///< additional error if Poisson's ratio is larger than those of the table
  };
  Course course(double poissonRatio, double thickness, double second = 0.0) const;

  void setHalfSpace(std::unique_ptr<StrainTable> table) { this->HalfSpace = std::move(table); }
  void setLayers(std::unique_ptr<StrainTable> table) { this->Layers = std::move(table); }

private:
  std::unique_ptr<StrainTable> HalfSpace;
  std::unique_ptr<StrainTable> Layers;
};

/// Creates a correction for depths up to `deepest` (mm). Returns "" or a fault that names the wrong
/// value. `made` is null after a fault, for the linear model, and if `goOn(fraction)` returned
/// false.
PALPATE_EXPORT std::string makeStrainCorrection(const AxisymmetricTool& tool, const StrainLaw& law,
  const StrainBodies& bodies, double deepest, const std::function<bool(double)>& goOn,
  std::unique_ptr<StrainCorrection>& made);

/// Returns whether makeStrainCorrection() can correct a Neo-Hooke body without the solver.
PALPATE_EXPORT bool isStrainTabulated(
  const AxisymmetricTool& tool, const StrainBodies& bodies, double deepest);
} // namespace palpate

#endif

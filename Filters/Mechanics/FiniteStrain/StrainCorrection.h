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

/// The range of bodies for a correction.
struct StrainBodies
{
  double leastRatio = 0.45; ///< Poisson's ratio
  double mostRatio = 0.45;
  bool hasHalfSpace = true;
  double thinnest = 0.0; ///< layer thickness, mm; 0: no layers
  double thickest = 0.0;
  LayerBase base = LayerBase::Bonded;
  /// The stack, if the layer is the top layer of a stack; `second` is the thickness of its second
  /// layer.
  LayerStack stack = {};
  ThicknessSpan second = { 0.0, 0.0 };
};

/**
 * The effect of finite strain on the force of one tool at a given depth. The exact force at small
 * strain is multiplied by c = F_finite/F_small. The stiffness is c k_small + F_small dc/dδ.
 *
 * Stored results of the solver cover a Neo-Hooke body
 * - on a half-space: below a sphere (to δ = R), a flat end (its rim rounded by a tenth of the
 *   radius, to δ = 1.3 R) and a cone (45° to 75°);
 * - on a bonded layer of half to four radii: below a sphere (to δ = h/2);
 * - on bonded layers of two radii or more: below a sphere and a flat end (to 0.7 to 1.2 radii).
 *
 * At larger depths the error grows (NeoHookeTables.h).
 *
 * All other cases are solved at four Poisson's ratios (or the single one), at thicknesses with
 * ratios of at most 2 between them (in a stack, for its first two layers), and at eight depths. On
 * a rigid base the depths end at 0.7 of the total thickness, beyond which the error grows. A curve
 * takes 3 s to a minute on all threads; it is bit for bit the same for any number of threads.
 * Results are cached by content in $PALPATE_CACHE, else $XDG_CACHE_HOME/palpate, else
 * ~/.cache/palpate. If PALPATE_CACHE is set to an empty text, nothing is cached.
 *
 * All layers of a stack have the same strain law, each with its own modulus and Poisson's ratio.
 * They are bonded to each other; the rigid base may slip. Layers that slide on each other are
 * rejected: the two sides of the interface move apart, which the solver's mesh cannot represent.
 *
 * For Poisson's ratios above 0.495, c is the value at 0.495, with an additional error. A tool with
 * a corner is solved with a fillet of a tenth of the contact radius, and of a larger fraction at
 * larger depths (FiniteOverSmall.h). An error of 1 % is added for the fillet, because half the
 * fillet changes c by up to 0.5 %. Safe to use from any number of threads.
 */
class PALPATE_EXPORT StrainCorrection
{
public:
  using Value = StrainFactor;

  /// `depth` (mm) is the depth of the tool at small strain. `thickness` (mm) is 0 for a half-space;
  /// `second` (mm) is the thickness of a stack's second layer. Takes less than 1 µs.
  Value at(double depth, double poissonRatio, double thickness, double second = 0.0) const
  {
    return this->course(poissonRatio, thickness, second).at(depth);
  }

  /// The correction on one body. It is faster than at() if many depths are evaluated.
  class Course
  {
  public:
    Value at(double depth) const;

  private:
    friend class StrainCorrection;
    StrainTable::Course Table;
    bool HasTable = false;
    double More = 0.0; ///< error for a Poisson's ratio larger than those of the table
  };
  Course course(double poissonRatio, double thickness, double second = 0.0) const;

  void setHalfSpace(std::unique_ptr<StrainTable> table) { this->HalfSpace = std::move(table); }
  void setLayers(std::unique_ptr<StrainTable> table) { this->Layers = std::move(table); }

private:
  std::unique_ptr<StrainTable> HalfSpace;
  std::unique_ptr<StrainTable> Layers;
};

/// Makes a correction for depths up to `deepest` (mm). Returns a fault that names the wrong value,
/// or "". `made` remains null after a fault, for the linear model, and if `goOn(fraction)` returned
/// false.
PALPATE_EXPORT std::string makeStrainCorrection(const AxisymmetricTool& tool, const StrainLaw& law,
  const StrainBodies& bodies, double deepest, const std::function<bool(double)>& goOn,
  std::unique_ptr<StrainCorrection>& made);

/// Whether makeStrainCorrection can correct a Neo-Hooke body without the solver.
PALPATE_EXPORT bool isStrainTabulated(
  const AxisymmetricTool& tool, const StrainBodies& bodies, double deepest);
} // namespace palpate

#endif

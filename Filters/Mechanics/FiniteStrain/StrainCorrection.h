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

/// The bodies for a correction.
struct StrainBodies
{
  double leastRatio = 0.45; ///< Poisson's
  double mostRatio = 0.45;
  bool hasHalfSpace = true;
  double thinnest = 0.0; ///< of layers, mm; 0: none
  double thickest = 0.0;
  LayerBase base = LayerBase::Bonded;
  /// The stack, if the layer is the first of one; its second layer is as thick as `second`.
  LayerStack stack = {};
  ThicknessSpan second = { 0.0, 0.0 };
};

/**
 * The effect of finite strain on the force of one tool at the same depth: c = F_finite/F_small, by
 * which the exact law of small strain is multiplied. Its stiffness is c k_small + F_small dc/dδ.
 *
 * Neo-Hooke below a sphere (to δ = R), a flat end (its rim rounded by a tenth of the radius,
 * δ = 1.3 R) and a cone (45° to 75°) on a half-space, below a sphere on a bonded layer (half to
 * four radii thick, δ = h/2), and below a sphere and a flat on bonded layers from two radii on (to
 * 0.7 to 1.2 radii), are tables made by the solver; deeper than that the error grows
 * (NeoHookeTables.h). Everything else is solved for at four Poisson's ratios (or the single one),
 * at thicknesses in a ratio of 2 or less (of a stack, of its first two layers), and at eight
 * depths: to 0.7 of all layers on a rigid base, beyond which the error grows. 3 s to a minute a
 * curve, on all threads, the same bits for any number of them; cached by content in $PALPATE_CACHE,
 * or $XDG_CACHE_HOME/palpate, or ~/.cache/palpate; with PALPATE_CACHE empty it is not cached.
 *
 * In a stack all layers have the same law, each with its own modulus and Poisson's ratio, and
 * bonded to each other; the rigid base may slip. Layers that slide on each other are refused: the
 * two sides of the interface move apart, which the solver's mesh cannot.
 *
 * Poisson's ratios above 0.495 get c of 0.495, and an error for it. A tool with a corner, solved
 * for with a fillet of a tenth of the contact radius and deeper with a rounder one
 * (FiniteOverSmall.h), gets an error of 1 % (half the fillet changes c by up to 0.5 %). Safe to use
 * from any number of threads.
 */
class PALPATE_EXPORT StrainCorrection
{
public:
  using Value = StrainFactor;

  /// `depth` (mm) of the tool at small strain; `thickness` (mm) 0 for a half-space, `second` (mm)
  /// that of a stack's second layer. Below 1 µs.
  Value at(double depth, double poissonsRatio, double thickness, double second = 0.0) const
  {
    return this->course(poissonsRatio, thickness, second).at(depth);
  }

  /// The same on one body at many depths, which is cheaper.
  class Course
  {
  public:
    Value at(double depth) const;

  private:
    friend class StrainCorrection;
    StrainTable::Course Table;
    bool HasTable = false;
    double More = 0.0; ///< error by a Poisson's ratio beyond the tables
  };
  Course course(double poissonsRatio, double thickness, double second = 0.0) const;

  void setHalfSpace(std::unique_ptr<StrainTable> table) { this->HalfSpace = std::move(table); }
  void setLayers(std::unique_ptr<StrainTable> table) { this->Layers = std::move(table); }

private:
  std::unique_ptr<StrainTable> HalfSpace;
  std::unique_ptr<StrainTable> Layers;
};

/// Makes a correction for depths to `deepest` (mm). Returns what is wrong, naming it, or "";
/// `made` stays null after a fault, for the linear model, and where `goOn(fraction)` ended it.
PALPATE_EXPORT std::string makeStrainCorrection(const AxisymmetricTool& tool, const StrainLaw& law,
  const StrainBodies& bodies, double deepest, const std::function<bool(double)>& goOn,
  std::unique_ptr<StrainCorrection>& made);

/// Whether makeStrainCorrection of Neo-Hooke needs no solver.
PALPATE_EXPORT bool isStrainTabulated(
  const AxisymmetricTool& tool, const StrainBodies& bodies, double deepest);
} // namespace palpate

#endif

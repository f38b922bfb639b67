// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_StrainCorrection_h
#define palpate_StrainCorrection_h

#include "Mechanics/FiniteStrain/StrainEnergy.h"
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

/// The bodies a correction is to serve.
struct StrainBodies
{
  double leastRatio = 0.45; ///< Poisson's
  double mostRatio = 0.45;
  bool hasHalfSpace = true;
  double thinnest = 0.0; ///< of layers, mm; 0: none
  double thickest = 0.0;
  LayerBase base = LayerBase::Bonded;
  /// Where the layer is the first of a stack, that; its second is as thick as `second` says.
  LayerStack stack = {};
  ThicknessSpan second = { 0.0, 0.0 };
};

/**
 * What finite strain does to the force of one tool at the same depth: c = F_finite/F_small, to be
 * multiplied by the exact law of small strain. Its stiffness is c k_small + F_small dc/dδ.
 *
 * Neo-Hooke below a sphere (to δ = R), a flat end (its rim rounded by a tenth of the radius, δ =
 * 1.3 R) and a cone (45° to 75°) on a half-space, below a sphere on a bonded layer (half to four
 * radii thick, δ = h/2), and below a sphere and a flat on bonded layers from two radii on (to 0.7
 * to 1.2 radii), is a table made once by the solver; deeper than that the error grows
 * (NeoHookeTables.h). All else is solved for at four Poisson's ratios (or the one there is), at
 * thicknesses of a ratio of 2 or less (of a stack, of its first two layers), and at eight depths:
 * to 0.7 of all layers on a rigid base, beyond which the error grows. 3 s to a minute a curve, on
 * all threads, the same bits for any number of them; kept by content in $PALPATE_CACHE, or
 * $XDG_CACHE_HOME/palpate, or ~/.cache/palpate; with PALPATE_CACHE empty it is not kept.
 *
 * In a stack all layers are of the one law, each with its own modulus and Poisson's ratio, and
 * bonded to each other; the rigid base may slip. Layers that slip on each other are refused: the
 * two sides of the gap move apart, which the solver's mesh does not.
 *
 * Poisson's ratios above 0.495 get c of 0.495, and an error for it; a tool with a corner, solved
 * for with a fillet of a tenth of the contact radius and deeper with a rounder one
 * (FiniteOverSmall.h), an error of 1 % (half the fillet changes c by up to 0.5 %). Safe to use from
 * any number of threads.
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

  /// The same on one body, of any depth: asked for many, cheaper.
  class Course
  {
  public:
    Value at(double depth) const;

  private:
    friend class StrainCorrection;
    StrainTable::Course Table;
    bool HasTable = false;
    double More = 0.0; ///< error, of a Poisson's ratio beyond the tables
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

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactCurve_h
#define palpate_ContactCurve_h

#include "Mechanics/IndentationLaw.h"
#include "Mechanics/PalpateExport.h"

#include <vector>

namespace palpate
{
/// One contact of a curve, and how well it is known.
struct PALPATE_EXPORT ContactSample
{
  double radius = 0.0;     ///< a, mm
  double deflection = 0.0; ///< δ, mm
  double force = 0.0;      ///< N
  double truncation = 0.0; ///< the force with one order less over this one, less 1
  double harmonics = 0.0;  ///< the tilt's part of δ, a fraction
  double gap = 0.0; ///< of the force, a fraction: what its treatment of the surface's shape leaves
  double direction = 0.0; ///< of the force, a fraction: what that it leans may do
  double surface = 0.0;   ///< of the force, a fraction: what lies between the surface's own points
  double strain = 0.0;    ///< of the force, a fraction: what small strain, or its correction, lacks
  double mesh = 0.0;      ///< of the force, a fraction: what the elements' size lets expect

  double beside = 0.0; ///< the elements' size over the distance of what limits contacts, up to 1

  /// Of the force, a fraction: what the elements and the kernels made of them lack. The one comes
  /// of cells, the other of the places that are solved for: apart from each other but beside an
  /// edge, where both come of too few elements up to it.
  double elements() const;
};

/// What ends a curve.
enum class CurveEnd : unsigned char
{
  Patch,    ///< the contact reaches the radius that was solved for
  Edge,     ///< it reaches an edge or another material
  Held,     ///< it reaches points that are held
  Unstable, ///< the kernel lets it grow no further: δ does not rise
  None      ///< the tool's wall: force rises along a straight line for ever
};

/**
 * Force over deflection of one tool at one point of a body: a stored curve, its stiffness the
 * derivative of that same curve.
 *
 * Between its samples a cubic in ln F over ln δ, as powers are straight there; of a tool with a
 * flat end, in F over δ. Monotone (Fritsch and Carlson 1980). Below the first sample a power of δ.
 */
class PALPATE_EXPORT ContactCurve
{
public:
  ContactCurve() = default;
  /// Samples of rising δ and F. `exponent`: of F ∝ δ^m at first touch. `flatEnd`: the tool begins
  /// with a flat; then the first sample is δ = F = 0 and `stiffness` dF/dδ there. A single sample
  /// with it is a straight line.
  ContactCurve(std::vector<ContactSample> samples, double exponent, bool flatEnd, double stiffness,
    CurveEnd end, double tail);

  bool isEmpty() const { return this->Samples.empty(); }
  const std::vector<ContactSample>& samples() const { return this->Samples; }
  CurveEnd end() const { return this->End; }
  /// The deepest δ it answers, mm; +inf behind a wall.
  double deepest() const;

  /// Force, stiffness, contact radius, N and mm, at the moduli of the body. δ <= 0 gives zeros, a δ
  /// beyond deepest() NaN.
  IndentationPoint evaluate(double deflection) const;

  /// The errors at δ, between those of the samples.
  ContactSample errorsAt(double deflection) const;

private:
  std::size_t intervalOf(double deflection) const;

  std::vector<ContactSample> Samples;
  std::vector<double> Abscissae; ///< ln δ, or δ
  std::vector<double> Ordinates; ///< ln F, or F
  std::vector<double> Slopes;
  double Exponent = 1.0;
  bool FlatEnd = false;
  CurveEnd End = CurveEnd::Patch;
  double Tail = 0.0; ///< dF/dδ behind the wall
};
} // namespace palpate

#endif

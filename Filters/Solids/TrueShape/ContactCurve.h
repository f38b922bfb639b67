// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactCurve_h
#define palpate_ContactCurve_h

#include "Mechanics/IndentationLaw.h"
#include "Mechanics/PalpateExport.h"

#include <vector>

namespace palpate
{
/// One contact of a curve and its errors. All errors except `harmonics` are fractions of the force.
struct PALPATE_EXPORT ContactSample
{
  double radius = 0.0;     ///< contact radius a, mm
  double deflection = 0.0; ///< deflection δ, mm
  double force = 0.0;      ///< N
  /// Relative change of the force if the order of the kernel is reduced by one.
  double truncation = 0.0;
  double harmonics = 0.0; ///< correction of δ for the tilt of the surface, as a fraction of δ
  double gap = 0.0;       ///< error of the approximation of the surface shape by a gap
  double direction = 0.0; ///< error due to a force that is not normal to the surface
  double surface = 0.0;   ///< error due to the shape of the surface between its points
  double strain = 0.0;    ///< error of small strain, or of its correction
  double mesh = 0.0;      ///< error that is expected from the element size

  /// Element size divided by the distance to the limit of contacts (KernelSite::limit). It is at
  /// most 1.
  double beside = 0.0;

  /// Error of the elements and of the kernels that are computed from them, as a fraction of the
  /// force. The first part (`mesh`) is due to the size of the elements, the second part
  /// (`truncation`) to the finite number of solved points. The two parts are independent except
  /// near an edge, where both are due to too few elements between the contact and the edge.
  double elements() const;
};

/// Reason why a curve ends.
enum class CurveEnd : unsigned char
{
  Patch,    ///< the contact reaches the largest radius for which the body was solved
  Edge,     ///< the contact reaches an edge or another material
  Held,     ///< the contact reaches held points
  Unstable, ///< With this kernel, the contact cannot grow further, because δ does not increase.
  /// The contact is at the tool's wall. The force increases along a straight line without end.
  None
};

/**
 * Force over deflection of one tool at one point of a body. The curve is stored; the stiffness is
 * its derivative.
 *
 * Between the samples, the curve is a cubic in ln F over ln δ, where powers are straight lines. For
 * a tool with a flat end, it is a cubic in F over δ. The curve is monotone (Fritsch and Carlson
 * 1980). Below the first sample, it is a power of δ.
 */
class PALPATE_EXPORT ContactCurve
{
public:
  ContactCurve() = default;
  /// `samples` have increasing δ and F. `exponent` is m in F ∝ δ^m at first touch. `flatEnd` states
  /// whether the tool begins with a flat end. In this case the first sample is δ = F = 0, and
  /// `stiffness` is dF/dδ at this sample. A single sample with `flatEnd` gives a straight line.
  /// `tail` is the slope dF/dδ beyond the last sample, where the contact is at the tool's wall,
  /// N/mm.
  ContactCurve(std::vector<ContactSample> samples, double exponent, bool flatEnd, double stiffness,
    CurveEnd end, double tail);

  bool isEmpty() const { return this->Samples.empty(); }
  const std::vector<ContactSample>& samples() const { return this->Samples; }
  CurveEnd end() const { return this->End; }
  /// Returns the largest δ that evaluate() accepts, mm. It is +inf if the curve ends at the tool's
  /// wall.
  double deepest() const;

  /// Returns force (N), stiffness (N/mm) and contact radius (mm) for the moduli of the body. All
  /// are zero for δ <= 0, and NaN for δ beyond deepest().
  IndentationPoint evaluate(double deflection) const;

  /// Returns the errors at δ, interpolated between the samples.
  ContactSample errorsAt(double deflection) const;

private:
  std::size_t intervalOf(double deflection) const;

  std::vector<ContactSample> Samples;
  std::vector<double> Abscissae; ///< ln δ, or δ for a flat end
  std::vector<double> Ordinates; ///< ln F, or F for a flat end
  std::vector<double> Slopes;
  double Exponent = 1.0;
  bool FlatEnd = false;
  CurveEnd End = CurveEnd::Patch;
  double Tail = 0.0; ///< slope dF/dδ beyond the last sample, at the wall
};
} // namespace palpate

#endif

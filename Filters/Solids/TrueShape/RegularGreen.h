// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * The regular part H of a body's Green function at points of its surface,
 *   G_nn(x, X) = 1/(πE*|x-X|) + H(x, X),
 * the normal displacement at x into the body by 1 N pressed into it at X, less Boussinesq's; mm/N.
 *
 * The singular field is subtracted before the elements are asked (SubtractedLoad), so that they
 * solve for what is smooth: elements of half the distance to what makes H (a base, an edge, the top
 * of an inclusion) give it within 1 %, however small the contact. On a curved surface H has no
 * limit at X but for ν = 0.5; (1-2ν)/(2(1-ν)) κ/(πE*), κ the mean curvature, is what the chord
 * leaves.
 *
 * Sources are solved in blocks of 32 with the one factor of the body, the blocks shared among
 * threadCount() threads; the same bits for any number.
 */
#ifndef palpate_RegularGreen_h
#define palpate_RegularGreen_h

#include "Solids/FiniteElements/ElasticBody.h"
#include "Solids/FiniteElements/PatchCompliance.h"
#include "Mechanics/PalpateExport.h"
#include "Solids/TrueShape/HeldRim.h"
#include "Solids/TrueShape/SourceErrors.h"

namespace palpate
{
/// H between surface points that share a contact, and the surface around each.
class PALPATE_EXPORT RegularGreen
{
public:
  /// The body, factorised, must stay.
  explicit RegularGreen(const ElasticBody& body)
    : Body(body)
  {
  }

  /// Bytes that solve() takes at its peak besides the body, to be asked beforehand.
  double memoryForecast(
    const std::vector<std::int32_t>& points, double radius, double spacing = 0.0) const;

  /**
   * Solves for all sources that contacts at `points` of up to `radius` (mm) need. Returns what is
   * wrong (no point that can be pressed, a radius that is none), "stopped" when the observer said
   * so, or "".
   *
   * `spacing` (mm) > 0: not every surface point is a source, but some that are so far apart, or
   * half as far as from the next edge where that is less, down to two thirds of `radius`. Contacts
   * at the others take H from those around: kernels are fits, whose middle need not be a source.
   * Half the distance to what makes H (a base, an inclusion) is enough.
   */
  std::string solve(const std::vector<std::int32_t>& points, double radius,
    const WorkObserver& observer, double spacing = 0.0);

  /// What the fit takes the kernel from: this times the contact radius.
  static constexpr double DiscRatio = 1.3;

  const ElasticBody& body() const { return this->Body; }
  double radius() const { return this->Radius; }
  double spacing() const { return this->Spacing; }
  bool isSource(std::int32_t point) const;
  /// The sources among `points` that can be pressed, ascending.
  std::vector<std::int32_t> pressedSources() const;
  /// The surface around one of `points`; null for any other.
  const SurfaceDisc* disc(std::int32_t point) const;
  /// Where what is held of the body begins.
  const HeldRim& held() const { return this->Held; }
  /// H(x, X), the mean of both orders where both were solved; NaN if neither was.
  double at(std::int32_t x, std::int32_t source) const;
  /// |H(x, X) - H(X, x)|; 0 where not both were solved.
  double asymmetry(std::int32_t x, std::int32_t source) const;
  /// How the body moves at a source under its own newton, less Boussinesq's field, reversed so that
  /// into the body is along the outward normal; mm/N, along the axes of the body.
  const Eigen::Vector3d& motion(std::int32_t source) const;
  /// What the elements let expect of the error of H at one of the points asked for (ElementError;
  /// at those that are no source as at the nearest ones), mm/N; NaN for any other.
  ExpectedError elementError(std::int32_t point) const;
  /// How many sources were solved.
  std::size_t sources() const { return this->Sources.size(); }

private:
  /// Surface points, ascending, and H there; and how the source itself moves.
  struct Row
  {
    std::vector<std::int32_t> points;
    std::vector<double> values;
    Eigen::Vector3d motion = Eigen::Vector3d::Zero();
  };

  std::size_t placeOf(std::int32_t point) const;
  const Row* row(std::int32_t source) const;
  const double* find(std::int32_t x, std::int32_t source) const;
  double discRadius(std::int32_t point) const;
  void chooseSources();
  void layOut();
  void solveBlock(const class SubtractedLoad& loads, std::size_t block);
  void expectBending();

  const ElasticBody& Body;
  HeldRim Held;
  double Radius = 0.0;
  double Spacing = 0.0;
  std::vector<std::int32_t> Points;                       ///< asked for, ascending
  std::vector<SurfaceDisc> Discs;                         ///< beside Points
  SourceErrors Errors;                                    ///< beside Points
  std::vector<std::int32_t> Sources;                      ///< ascending
  std::vector<Row> Rows;                                  ///< beside Sources
  std::vector<std::vector<BendingError::Sample>> Bending; ///< by blocks of them
};
} // namespace palpate

#endif

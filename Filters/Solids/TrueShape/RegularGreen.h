// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * The regular part H of a body's Green function at points of its surface,
 *   G_nn(x, X) = 1/(πE*|x-X|) + H(x, X).
 * G_nn is the inward normal displacement at x under an inward normal force of 1 N at X, mm/N. The
 * first term is Boussinesq's solution.
 *
 * The singular field is subtracted before the elements are used (SubtractedLoad), so that they
 * solve for a smooth field. If the elements are no larger than half the distance to the cause of H
 * (a base, an edge, the top of an inclusion), H is exact within 1 %, for a contact of any size. On
 * a curved surface, H has a limit at X only for ν = 0.5. For other ν, the term (1-2ν)/(2(1-ν))
 * κ/(πE*) with the mean curvature κ remains, because 1/|x-X| uses the length of the chord.
 *
 * Sources are solved in blocks of 32 with the single factor of the body. The blocks are distributed
 * among threadCount() threads. The result is bit-identical for any number of threads.
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
/// H between surface points that can be under one contact, and the shape of the surface around each
/// point.
class PALPATE_EXPORT RegularGreen
{
public:
  /// The body must be factorised and must outlive this object.
  explicit RegularGreen(const ElasticBody& body)
    : Body(body)
  {
  }

  /// Returns the peak memory of solve() in addition to the memory of the body, in bytes. Call it
  /// before solve().
  double memoryForecast(
    const std::vector<std::int32_t>& points, double radius, double spacing = 0.0) const;

  /**
   * Solves for all sources that are needed by contacts at `points` with radii up to `radius` (mm).
   * Returns "" on success, an error message if no point can be pressed or the radius is not valid,
   * or "stopped" if the observer stopped the work.
   *
   * If `spacing` (mm) is > 0, only some surface points are sources, at least `spacing` apart. Near
   * an edge, the distance of the sources is reduced to half the distance to the edge, but not below
   * two thirds of `radius`. For contacts at the other points, H follows from the surrounding
   * sources, because kernels are fits whose middle need not be a source. A spacing of half the
   * distance to the cause of H (a base, an inclusion) is sufficient. If `isEven` is set, the
   * sources are not denser near edges, and the error of bending is sampled at a quarter of the
   * sources. This is faster but less accurate.
   */
  std::string solve(const std::vector<std::int32_t>& points, double radius,
    const WorkObserver& observer, double spacing = 0.0, bool isEven = false);

  /// Radius of the disc to which a kernel is fitted, in contact radii.
  static constexpr double DiscRatio = 1.3;

  const ElasticBody& body() const { return this->Body; }
  double radius() const { return this->Radius; }
  double spacing() const { return this->Spacing; }
  bool isSource(std::int32_t point) const;
  /// Returns the sources among `points` that can be pressed, in ascending order.
  std::vector<std::int32_t> pressedSources() const;
  /// Returns the surface around one of `points`. Returns null for any other point.
  const SurfaceDisc* disc(std::int32_t point) const;
  /// Returns the edge of the held part of the body.
  const HeldRim& held() const { return this->Held; }
  /// Returns H(x, X). It is the mean of H(x, X) and H(X, x) if both were solved, and NaN if neither
  /// was solved.
  double at(std::int32_t x, std::int32_t source) const;
  /// Returns |H(x, X) - H(X, x)|; 0 unless both were solved.
  double asymmetry(std::int32_t x, std::int32_t source) const;
  /// Returns the motion of the body at a source under 1 N at the source, without Boussinesq's
  /// field, mm/N, along the axes of the body. The sign is reversed: motion into the body is along
  /// the outward normal.
  const Eigen::Vector3d& motion(std::int32_t source) const;
  /// Returns the expected error of H due to the elements at one of the points given to solve()
  /// (ElementError), mm/N. The error of a point that is not a source is that of the nearest
  /// sources. Returns NaN for points that were not given to solve().
  ExpectedError elementError(std::int32_t point) const;
  /// Returns the number of solved sources.
  std::size_t sources() const { return this->Sources.size(); }

private:
  /// One source, with surface points in ascending order, H at these points, and the motion of the
  /// source itself.
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
  bool IsEven = false;
  /// Points given to solve(), in ascending order.
  std::vector<std::int32_t> Points;
  std::vector<SurfaceDisc> Discs;    ///< discs, one per point of Points
  SourceErrors Errors;               ///< expected errors, one per point of Points
  std::vector<std::int32_t> Sources; ///< solved surface points, in ascending order
  std::vector<Row> Rows;             ///< solutions, one per source of Sources
  /// Samples of the bending error, one entry per block of sources.
  std::vector<std::vector<BendingError::Sample>> Bending;
};
} // namespace palpate

#endif

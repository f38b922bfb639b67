// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ResponseFiller_h
#define palpate_ResponseFiller_h

#include "Laws/ContactSpot.h"
#include "Mechanics/PalpateExport.h"
#include "Laws/ErrorRule.h"
#include "Laws/LocalContact.h"
#include "Laws/ValidityRule.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace palpate
{
class AxisymmetricTool;
class BodyMaterial;
class ResponseLaw;
class StrainCorrection;

/// The output arrays of a response: one value per point, of force (N) and stiffness (N/mm)
/// `samples`.
struct ResponseSpans
{
  int samples;
  float* force;
  float* stiffness;
  float* range;    ///< mm
  float* validity; ///< mm
  unsigned char* status;
  unsigned char* limit;
  float* error = nullptr; ///< relative, of each sample; null: not kept
};

/// The errors of a measured body, point by point; thread-safe. Used if the error is estimated.
struct MeasuredBodyError
{
  /// Relative error of the force at a sample (0 … n-1) by noise and distance of the measurement.
  std::function<double(std::size_t point, std::size_t sample)> data;
  /// The contact it was measured with, for E* = 1; its radius is 0 where there is none.
  std::function<LocalState(std::size_t point)> contact;
};

/// The terms of a response beyond its tool's law on a flat body at small strain, and how its
/// validity is found.
struct ResponseTerms
{
  bool curvature = false;                   ///< the body's curvature
  const StrainCorrection* strain = nullptr; ///< finite strain
  /// Validity is the largest depth at which the estimated error is within this; 0: by ValidityRule.
  double errorTolerance = 0.0;
  const MeasuredBodyError* measured = nullptr; ///< the material was measured
  bool edges = false; ///< the servo tick takes sharp edges into account (BodyEdges)
};

/// The shape of a body's surface, point by point; thread-safe.
struct SurfaceShape
{
  double width = 0.0; ///< mm, of the whole body
  /// Largest normal curvature (1/mm) as in ValidityRule; negative where no triangle with an area
  /// meets, which is Degenerate.
  std::function<double(std::size_t)> bound;
  /// The curvatures; called only with terms that need them.
  std::function<SpotCurvature(std::size_t)> curvature;
  /// The nearest edge; called only where the error is estimated. Empty: there is none.
  std::function<NearEdge(std::size_t)> edge = {};
};

/**
 * Fills the arrays of a response point by point: the curve of a law, its validity (ValidityRule.h
 * or ErrorRule.h), and the error at each sample if it is kept. The status must be set: where it is
 * not Valid the curve is zero.
 */
class PALPATE_EXPORT ResponseFiller
{
public:
  /// Tool, law and arrays must outlive this. `range` (mm) is the law's, `bodyWidth` (mm) that of
  /// the whole body.
  ResponseFiller(const AxisymmetricTool& tool, const ResponseLaw& law, double range,
    double bodyWidth, const ResponseSpans& spans);

  /// Estimates the error from now on: validity ends where it exceeds `tolerance` (> 0). `contact`
  /// is the law's. `contact` and `measured` (null: the material is given) must outlive this.
  void estimate(const LocalContact& contact, const LawScope& scope, double tolerance,
    const MeasuredBodyError* measured = nullptr);

  /// Point `i`; different points may be filled at the same time. `curvature` (1/mm) as in
  /// ValidityRule; negative where no triangle with an area meets, which is Degenerate.
  void fill(std::size_t i, const ContactSpot& spot, double curvature) const;
  /// The same with the surface, which the error needs.
  void fill(std::size_t i, const ContactSpot& spot, double bound, const SpotSurface& surface) const;

private:
  /// Returns the status of the point.
  unsigned char fillCurve(std::size_t i, const ContactSpot& spot, double bound) const;
  /// The curve, and the validity by its error.
  ValidityRule::Answer fillEstimated(
    std::size_t i, const ContactSpot& spot, double bound, const SpotSurface& surface) const;
  template <class StateAt>
  ValidityRule::Answer estimated(std::size_t i, const StateAt& stateAt, bool fits,
    const ContactSpot& spot, const SpotSurface& surface) const;

  const AxisymmetricTool& Tool;
  const ResponseLaw& Law;
  ResponseSpans Spans;
  float Range;
  ValidityRule Rule;
  const LocalContact* Contact = nullptr;
  const MeasuredBodyError* Measured = nullptr;
  std::unique_ptr<ErrorRule> Errors;  ///< null: not estimated
  std::vector<double> ErrorDepths;    ///< mm: at first contact, then of the samples
  std::vector<LocalState> FlatStates; ///< there, on a flat half-space; empty with finite strain
  double Tolerance = 0.0;
};

/// The results of a response besides its arrays.
struct MadeResponse
{
  bool complete = false;   ///< not stopped before the end
  double exponent = 0.0;   ///< with the least storage error
  std::size_t without = 0; ///< points whose status is not Valid
};

/// A tool pressed at each of `points` points of a body: fills the spans, whose status must be set.
/// `range` (mm): one that the tool's checkDepth allows. `goOn(fraction)` gets the fraction done;
/// returning false stops it. The same bits for any number of threads.
PALPATE_EXPORT MadeResponse response(const AxisymmetricTool& tool, const BodyMaterial& material,
  double range, std::size_t points, const SurfaceShape& shape, const ResponseTerms& terms,
  const ResponseSpans& spans, const std::function<bool(double)>& goOn = {});
} // namespace palpate

#endif

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

/// The output arrays of a response. Most arrays have one value per point. `force` (N) and
/// `stiffness` (N/mm) have `samples` values per point.
struct ResponseSpans
{
  int samples;
  float* force;
  float* stiffness;
  float* range;    ///< mm
  float* validity; ///< mm
  unsigned char* status;
  unsigned char* limit;
  float* error = nullptr; ///< relative error at each sample; null if it is not stored
};

/// The errors of a measured body at each point. The functions must be thread-safe. Used only if the
/// error is estimated.
struct MeasuredBodyError
{
  /// Returns the relative error of the force at a sample (0 … n-1) due to the noise of the
  /// measurement and the distance from the measured site.
  std::function<double(std::size_t point, std::size_t sample)> data;
  /// Returns the contact with which the point was measured, for E* = 1. Its radius is 0 if the
  /// point was not measured.
  std::function<LocalState(std::size_t point)> contact;
};

/// Terms of a response in addition to the tool's law for a flat body at small strain, and the rule
/// for its validity.
struct ResponseTerms
{
  bool curvature = false;                   ///< include the body's curvature
  const StrainCorrection* strain = nullptr; ///< include finite strain; null for small strain
  /// Validity ends at the depth at which the estimated error exceeds this value. With 0, validity
  /// is determined by ValidityRule.
  double errorTolerance = 0.0;
  /// Data of a measured material; null if the material was not measured.
  const MeasuredBodyError* measured = nullptr;
  bool edges = false; ///< the servo tick corrects the effect of sharp edges (BodyEdges)
};

/// The shape of a body's surface at each point. The functions must be thread-safe.
struct SurfaceShape
{
  double width = 0.0; ///< mm, width of the whole body
  /// Returns the largest normal curvature (1/mm), as defined in ValidityRule. Negative if the point
  /// has no triangle with an area; the status of the point is then Degenerate.
  std::function<double(std::size_t)> bound;
  /// Returns the curvatures. Called only if a term requires them.
  std::function<SpotCurvature(std::size_t)> curvature;
  /// Returns the nearest edge. Called only if the error is estimated. Empty if the body has no
  /// edges.
  std::function<NearEdge(std::size_t)> edge = {};
};

/**
 * Fills the arrays of a response point by point with the curve of a law, its validity
 * (ValidityRule.h or ErrorRule.h), and the error at each sample if it is to be stored. The caller
 * must set the status first. The curve is zero if the status is not Valid.
 */
class PALPATE_EXPORT ResponseFiller
{
public:
  /// `range` (mm) is the range of the law, `bodyWidth` (mm) the width of the whole body. Tool, law
  /// and arrays must outlive this object.
  ResponseFiller(const AxisymmetricTool& tool, const ResponseLaw& law, double range,
    double bodyWidth, const ResponseSpans& spans);

  /// Enables the estimate of the error. Validity then ends at the depth at which the error exceeds
  /// `tolerance` (> 0). `contact` is the local contact of the law. `measured` is null if the
  /// material was not measured. `contact` and `measured` must outlive this object.
  void estimate(const LocalContact& contact, const LawScope& scope, double tolerance,
    const MeasuredBodyError* measured = nullptr);

  /// Fills point `i`. Different points may be filled at the same time. `curvature` (1/mm) is
  /// defined as in ValidityRule. It is negative if the point has no triangle with an area; the
  /// status of the point is then Degenerate.
  void fill(std::size_t i, const ContactSpot& spot, double curvature) const;
  /// As above, with the surface at the point, which the estimate of the error requires.
  void fill(std::size_t i, const ContactSpot& spot, double bound, const SpotSurface& surface) const;

private:
  /// Fills the curve. Returns the status of the point.
  unsigned char fillCurve(std::size_t i, const ContactSpot& spot, double bound) const;
  /// Fills the curve and computes its validity from its error.
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
  std::unique_ptr<ErrorRule> Errors; ///< null if the error is not estimated
  std::vector<double> ErrorDepths;   ///< mm; depth of first contact, then the depths of the samples
  /// The contact at ErrorDepths on a flat half-space; empty if the strain is finite.
  std::vector<LocalState> FlatStates;
  double Tolerance = 0.0;
};

/// The results of a response in addition to its arrays.
struct MadeResponse
{
  bool complete = false;   ///< false if the computation was stopped before the end
  double exponent = 0.0;   ///< exponent with the least storage error
  std::size_t without = 0; ///< number of points that have no response: their status is not Valid
};

/// Computes the response of a tool at each of `points` points of a body. Fills `spans`, whose
/// status must be set before. `range` (mm) must pass the tool's checkDepth. `goOn(fraction)` is
/// called with the completed fraction; the computation stops if it returns false. The result is bit
/// for bit the same for any number of threads.
PALPATE_EXPORT MadeResponse response(const AxisymmetricTool& tool, const BodyMaterial& material,
  double range, std::size_t points, const SurfaceShape& shape, const ResponseTerms& terms,
  const ResponseSpans& spans, const std::function<bool(double)>& goOn = {});
} // namespace palpate

#endif

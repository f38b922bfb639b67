// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ResponseLaw_h
#define palpate_ResponseLaw_h

#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Laws/ContactSpot.h"
#include "Laws/LocalContact.h"
#include "Mechanics/Layers/LayerTable.h"
#include "Mechanics/PalpateExport.h"
#include "Contact/ResponseField.h"

#include <memory>
#include <utility>
#include <vector>

namespace palpate
{
class MaterialRange;
class StrainCorrection;

/**
 * The law of one tool, sampled for the storage of curves.
 *
 * On a half-space the law is evaluated once for E* = 1, and then scaled. On a layer it is
 * interpolated over the thickness (LayerTable.h), and then scaled. At points with a global
 * compliance the series is solved separately for each point (SeriesCompliance.h). With correct()
 * the law includes the spot's curvature (CurvedContact.h) and finite strain, which multiplies the
 * local force. Can be used from any number of threads.
 */
class PALPATE_EXPORT ResponseLaw
{
public:
  /// `range` (mm) is the depth of the last sample. `tool` must outlive the law.
  ResponseLaw(const AxisymmetricTool& tool, double range, int samples);

  /// Prepares the law for spots with a layer. `stiffening` means that some of these spots also have
  /// a negative compliance, so that the deflection of the layer exceeds the range.
  void prepareLayers(const LayerTable::Layers& layers, bool stiffening);

  /// Prepares thicknessEffect() for spots whose thinnest possible layers are within `layers`.
  void prepareUncertain(const LayerTable::Layers& layers);

  /// Adds the curvature and finite strain of `contact` to the law. `contact` must have been created
  /// for this tool and prepared for the layers.
  void correct(std::shared_ptr<const LocalContact> contact) { this->Contact = std::move(contact); }

  /// Writes n forces (N) and n stiffnesses (N/mm). If the spot has no curve, writes zeros and
  /// returns the reason: Folded by the compliance, OutOfReach for a layer too thin for the range,
  /// NotFinite if a number is outside the normal range of a float (1.2e-38 to 3.4e38).
  ResponseStatus sample(const ContactSpot& spot, float* force, float* stiffness) const;

  /// As above, with the given local contact.
  ResponseStatus sample(
    const NodeLaw& local, const ContactSpot& spot, float* force, float* stiffness) const;

  /// As above, with the given local contact at each of depths().
  ResponseStatus sample(
    const LocalState* states, const ContactSpot& spot, float* force, float* stiffness) const;

  /// Writes the n relative changes of the force (>= 0) at the samples that occur if the layers have
  /// the smallest thickness within their errors, for a flat body at small strain. The force is a
  /// convex function of 1/thickness, so that a thickness larger by the same error changes the force
  /// less. Writes 1 if the thinnest possible layer is too thin for the range. Requires
  /// prepareUncertain().
  void thicknessEffect(const ContactSpot& spot, double* change) const;

  /// Depths of the samples, mm.
  const std::vector<double>& depths() const { return this->Depths; }

  /// Returns F (N) and dF/dδ (N/mm) without storage errors, for 0 < deflection <= range. The
  /// relative error on a layer is 1e-6. NaN if the contact is not stable.
  IndentationPoint evaluate(const ContactSpot& spot, double deflection) const;

  /// Returns the deflection (mm) at which the contact radius is a (mm); +inf if there is no such
  /// deflection, or none within the range on a layer.
  double deflectionAtContactRadius(const ContactSpot& spot, double a) const;
  /// Returns the deflection of the whole series, mm, if the local deflection is `localDepth`, mm.
  double totalDeflection(const ContactSpot& spot, double localDepth) const;

  /// Returns the largest relative error of the force between 1 and 100 % of the range: the float
  /// samples, evaluated as in the servo tick, are compared with the law without storage. +inf if
  /// the spot cannot be sampled.
  double storageError(double exponent, const ContactSpot& spot) const;

private:
  /// F and dF/dδ for E* = 1 at the depths of a sampling.
  struct UnitCurve
  {
    std::vector<double> forces;
    std::vector<double> stiffnesses;
    double least = 0.0; ///< smallest magnitude of all nonzero values
    double most = 0.0;
    void findExtremes();
    double force(int i) const { return this->forces[static_cast<std::size_t>(i)]; }
    double stiffness(int i) const { return this->stiffnesses[static_cast<std::size_t>(i)]; }
  };
  class SampledLaw;

  /// Returns whether the law of a spot is corrected. The body's curvature is ignored if the layer
  /// is too thin for its correction. Finite strain is never ignored.
  bool isCorrected(const ContactSpot& spot) const
  {
    return this->Contact && this->Contact->corrects(spot) &&
      (this->Contact->corrects({}) || this->Contact->answers(spot));
  }

  static UnitCurve layerCurve(const LayerCurves& table, const ContactSpot& spot);
  ResponseStatus withZeros(ResponseStatus status, float* force, float* stiffness) const;
  ResponseStatus scale(
    const UnitCurve& curve, double reducedModulus, float* force, float* stiffness) const;
  ResponseStatus solve(
    const IndentationLaw& local, const ContactSpot& spot, float* force, float* stiffness) const;

  const AxisymmetricTool& Tool;
  double Range;
  int Samples;
  std::vector<double> Depths;
  UnitCurve HalfSpace;
  std::shared_ptr<const LayerCurves> Stored;    ///< layers, at the depths of the samples
  std::shared_ptr<const LayerCurves> Uncertain; ///< the thinnest possible layers
  std::shared_ptr<const LayerCurves> Local; ///< layers, with more samples, used to solve the series
  ResponseSampling LocalSampling;
  double LocalRange;
  std::shared_ptr<const LocalContact> Contact; ///< corrections; null if there are none
};

/// A tool's law, and its local contact with the corrections. If the contact is null, the law is
/// that of a flat body at small strain.
struct PreparedLaw
{
  ResponseLaw law;
  std::shared_ptr<const LocalContact> contact;
};

/// Creates the law of `tool` to a depth of `range` (mm) with `samples` samples, for all bodies
/// within `bounds`. If `hasContact` is true, also creates the local contact. `strain` is null for
/// small strain. `tool` and `strain` must outlive the result. Cost: 10 ms to 1 s for the tables of
/// layers, if the body has layers.
PALPATE_EXPORT PreparedLaw prepareLaw(const AxisymmetricTool& tool, double range, int samples,
  const MaterialRange& bounds, bool hasContact, const StrainCorrection* strain);
} // namespace palpate

#endif

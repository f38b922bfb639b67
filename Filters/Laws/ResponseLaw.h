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
 * The law of one tool, sampled for storage.
 *
 * Half-space: evaluated once for E* = 1 and scaled. Layer: interpolated over the thickness
 * (LayerTable.h) and scaled. Points of finite global compliance are solved one by one
 * (SeriesCompliance.h). On request (LocalContact.h) the law includes the spot's curvature
 * (CurvedContact.h), and finite strain multiplies the local force. Safe to use from any number of
 * threads.
 */
class PALPATE_EXPORT ResponseLaw
{
public:
  /// `tool` must outlive the law. Range (mm) is the depth of the last sample.
  ResponseLaw(const AxisymmetricTool& tool, double range, int samples);

  /// Prepares for spots with a layer. `stiffening`: some also have a negative compliance, with
  /// which the layer's deflection exceeds the range.
  void prepareLayers(const LayerTable::Layers& layers, bool stiffening);

  /// Includes curvature and finite strain from now on, as `contact` has them; it must be made for
  /// this tool and prepared for the layers.
  void correct(std::shared_ptr<const LocalContact> contact) { this->Contact = std::move(contact); }

  /// Writes n forces (N) and n stiffnesses (N/mm). Zeros, and why, where there is no curve: Folded
  /// by the compliance, OutOfReach for a layer too thin for the range, NotFinite where a number is
  /// outside the normal range of a float (1.2e-38 to 3.4e38).
  ResponseStatus sample(const ContactSpot& spot, float* force, float* stiffness) const;

  /// The same with a local contact that has been made already.
  ResponseStatus sample(
    const NodeLaw& local, const ContactSpot& spot, float* force, float* stiffness) const;

  /// The same with the local contact at each of depths().
  ResponseStatus sample(
    const LocalState* states, const ContactSpot& spot, float* force, float* stiffness) const;

  /// Depths of the samples, mm.
  const std::vector<double>& depths() const { return this->Depths; }

  /// The law itself at 0 < deflection <= range: F (N) and dF/dδ (N/mm), to 1e-6 on a layer; NaN
  /// where there is no stable contact.
  IndentationPoint evaluate(const ContactSpot& spot, double deflection) const;

  /// The deflection (mm) at which the contact radius reaches a; +inf if it never does, or, on a
  /// layer, not within the range.
  double deflectionAtContactRadius(const ContactSpot& spot, double a) const;
  /// The deflection of the whole series at a depth of its local part, mm.
  double totalDeflection(const ContactSpot& spot, double localDepth) const;

  /// Largest relative error of force between 1 and 100 % of the range, of float samples evaluated
  /// as the kernel does, against the law itself; +inf if it cannot be sampled.
  double storageError(double exponent, const ContactSpot& spot) const;

private:
  /// F and dF/dδ for E* = 1 at the depths of a sampling.
  struct UnitCurve
  {
    std::vector<double> forces;
    std::vector<double> stiffnesses;
    double least = 0.0; ///< of all nonzero values, by magnitude
    double most = 0.0;
    void findExtremes();
    double force(int i) const { return this->forces[static_cast<std::size_t>(i)]; }
    double stiffness(int i) const { return this->stiffnesses[static_cast<std::size_t>(i)]; }
  };
  class SampledLaw;

  /// The body's curvature is left out where the layer is too thin for it, finite strain never.
  bool isCorrected(const ContactSpot& spot) const
  {
    return this->Contact && this->Contact->corrects(spot) &&
      (this->Contact->corrects({}) || this->Contact->answers(spot));
  }

  static UnitCurve layerCurve(const LayerCurves& table, const ContactSpot& spot);
  ResponseStatus orNothing(ResponseStatus status, float* force, float* stiffness) const;
  ResponseStatus scale(
    const UnitCurve& curve, double reducedModulus, float* force, float* stiffness) const;
  ResponseStatus solve(
    const IndentationLaw& local, const ContactSpot& spot, float* force, float* stiffness) const;

  const AxisymmetricTool& Tool;
  double Range;
  int Samples;
  std::vector<double> Depths;
  UnitCurve HalfSpace;
  std::shared_ptr<const LayerCurves> Stored; ///< layers at the depths of the samples
  std::shared_ptr<const LayerCurves> Local;  ///< layers in more samples, for solving in series
  ResponseSampling LocalSampling;
  double LocalRange;
  std::shared_ptr<const LocalContact> Contact; ///< with corrections; null: none
};

/// A tool's law, and its local contact with what is to be counted beyond the textbook; null: the
/// law is the textbook's.
struct PreparedLaw
{
  ResponseLaw law;
  std::shared_ptr<const LocalContact> contact;
};

/// The law of `tool` to a depth of `range` (mm) in `samples` samples, ready for all bodies within
/// `bounds`, with a local contact or without. `tool` and `strain` (null: small strain) must outlive
/// it. Cost: tables of layers, if there are any, 10 ms to a second.
PALPATE_EXPORT PreparedLaw prepareLaw(const AxisymmetricTool& tool, double range, int samples,
  const MaterialRange& bounds, bool hasContact, const StrainCorrection* strain);
} // namespace palpate

#endif

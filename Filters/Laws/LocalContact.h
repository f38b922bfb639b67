// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LocalContact_h
#define palpate_LocalContact_h

#include "Laws/ContactSpot.h"
#include "Laws/CurvedContact.h"
#include "Mechanics/Layers/LayerTable.h"
#include "Mechanics/PalpateExport.h"

#include <memory>
#include <vector>

namespace palpate
{
class AxisymmetricTool;
class StrainCorrection;

/**
 * The local contact of one tool with what makes a real one differ from the law of the textbook: the
 * curvature of the body (CurvedContact.h) and finite strain (StrainCorrection.h), which multiplies
 * the force at the depth the tool has at the same contact radius on the flat body.
 *
 * In nodes; see NodeLaw for their error. Cost: 1 to 2 µs for a law on a half-space, 3 on a layer.
 * Safe to use from any number of threads once it is prepared.
 */
class PALPATE_EXPORT LocalContact
{
public:
  /// Answers at least to `range` (mm); with `deeper` to three times that, as a negative compliance
  /// asks. `tool` and `strain` (null: small strain) must outlive this.
  LocalContact(
    const AxisymmetricTool& tool, double range, bool deeper, const StrainCorrection* strain);
  ~LocalContact();

  void prepareLayers(const LayerTable::Layers& layers);

  /// Whether there is anything to correct at a spot.
  bool corrects(const ContactSpot& spot) const
  {
    return this->Strain != nullptr || !spot.curvature.isFlat();
  }
  /// Whether the spot's layer is not too thin.
  bool answers(const ContactSpot& spot) const;
  /// For a spot that is answered: the contact for E* = 1. `fits` tells whether the tool fits into
  /// the body down to the range; where it does not, the law is that of the flat body.
  NodeLaw law(const ContactSpot& spot, bool& fits) const;
  NodeLaw law(const ContactSpot& spot) const
  {
    bool fits = true;
    return this->law(spot, fits);
  }

private:
  ContactNodes flatNodes(const ContactSpot& spot) const;
  ContactNodes curvedNodes(const ContactSpot& spot, const ContactNodes& flat) const;
  void strain(const ContactSpot& spot, ContactNodes& nodes) const;

  const AxisymmetricTool& Tool;
  double Range;
  const StrainCorrection* Strain;
  ContactNodes HalfSpace;
  std::unique_ptr<AxisymmetricTool> Sag; ///< the paraboloid that stands for the body's sag
  double SagCurvature;                   ///< 1/mm
  std::unique_ptr<LayerCurves> Layers;
  std::unique_ptr<LayerCurves> SagLayers;
};
} // namespace palpate

#endif

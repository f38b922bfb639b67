// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LocalContact_h
#define palpate_LocalContact_h

#include "Laws/ContactSpot.h"
#include "Laws/CurvedContact.h"
#include "Laws/CurvedHalfSpace.h"
#include "Mechanics/Layers/LayerTable.h"
#include "Mechanics/PalpateExport.h"

#include <memory>
#include <vector>

namespace palpate
{
class AxisymmetricTool;
class StrainCorrection;

/**
 * The local contact of one tool beyond the textbook's law: with the curvature of the body
 * (CurvedContact.h) and finite strain (StrainCorrection.h), whose factor is that at the tool's
 * depth with the same contact radius on the flat body.
 *
 * Solved depth by depth on a half-space (CurvedHalfSpace.h), otherwise interpolated between nodes;
 * see NodeLaw for their error. Cost: 40 ns a depth on a half-space, with finite strain 0.3 µs; 3 µs
 * a law on a layer. Safe to use from any number of threads once it is prepared.
 */
class PALPATE_EXPORT LocalContact
{
public:
  /// Valid at least to `range` (mm); with `deeper` to three times that, as needed for a negative
  /// compliance. `tool` and `strain` (null: small strain) must outlive this.
  LocalContact(
    const AxisymmetricTool& tool, double range, bool deeper, const StrainCorrection* strain);
  ~LocalContact();

  void prepareLayers(const LayerTable::Layers& layers);

  /// Whether there is anything to correct at a spot.
  bool corrects(const ContactSpot& spot) const
  {
    return this->Strain != nullptr || !spot.curvature.isFlat();
  }
  /// Whether the spot's layer is thick enough for a law.
  bool answers(const ContactSpot& spot) const;
  /// For a spot that answers() accepts: the contact for E* = 1. `fits` tells whether the tool fits
  /// into the body down to the range; where it does not, the law is that of the flat body.
  NodeLaw law(const ContactSpot& spot, bool& fits) const;
  NodeLaw law(const ContactSpot& spot) const
  {
    bool fits = true;
    return this->law(spot, fits);
  }

  /// Whether states() can be used: on a half-space whose compliance is not negative.
  bool isDirect(const ContactSpot& spot) const
  {
    return !(spot.thickness > 0.0) &&
      (spot.compliance == 0.0 || (spot.compliance > 0.0 && !this->Strain));
  }
  /// The contact for E* = 1 at ascending deflections (mm) of the whole series, up to the range;
  /// returns `fits` as law().
  bool states(
    const ContactSpot& spot, const std::vector<double>& deflections, LocalState* states) const;

private:
  ContactNodes flatNodes(const ContactSpot& spot) const;
  ContactNodes curvedNodes(const ContactSpot& spot, const ContactNodes& flat) const;
  void strain(const ContactSpot& spot, ContactNodes& nodes) const;

  const AxisymmetricTool& Tool;
  double Range;
  const StrainCorrection* Strain;
  ContactNodes HalfSpace;
  CurvedHalfSpace Direct;
  std::unique_ptr<AxisymmetricTool> Sag; ///< the paraboloid of the body's curvature
  double SagCurvature;                   ///< 1/mm
  std::shared_ptr<const LayerCurves> Layers;
  std::shared_ptr<const LayerCurves> SagLayers;
};
} // namespace palpate

#endif

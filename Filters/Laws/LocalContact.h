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
 * The local contact of one tool, with corrections to the law for a flat body at small strain. The
 * corrections are the curvature of the body (CurvedContact.h) and finite strain
 * (StrainCorrection.h). The factor for finite strain is evaluated at the depth at which the tool
 * has the same contact radius on the flat body.
 *
 * On a half-space the contact is solved at each depth (CurvedHalfSpace.h). On a layer it is
 * interpolated between nodes; see NodeLaw for the error. Cost: 40 ns per depth on a half-space, 0.3
 * µs with finite strain; 3 µs per law on a layer. Once it is prepared, it can be used from any
 * number of threads.
 */
class PALPATE_EXPORT LocalContact
{
public:
  /// The contact is valid at least to `range` (mm). With `deeper`, it is valid to three times the
  /// range, as needed for a negative compliance. `strain` is null for small strain. `tool` and
  /// `strain` must outlive this object.
  LocalContact(
    const AxisymmetricTool& tool, double range, bool deeper, const StrainCorrection* strain);
  ~LocalContact();

  void prepareLayers(const LayerTable::Layers& layers);

  /// Returns whether a correction applies at a spot.
  bool corrects(const ContactSpot& spot) const
  {
    return this->Strain != nullptr || !spot.curvature.isFlat();
  }
  /// Returns whether the law is valid at the spot. The layer must be thick enough.
  bool answers(const ContactSpot& spot) const;
  /// Returns the contact for E* = 1 at a spot for which answers() is true. Sets `fits` to whether
  /// the tool fits into the body down to the range. If it does not fit, the law is that of the flat
  /// body.
  NodeLaw law(const ContactSpot& spot, bool& fits) const;
  NodeLaw law(const ContactSpot& spot) const
  {
    bool fits = true;
    return this->law(spot, fits);
  }

  /// Returns whether states() can be used. The spot must be a half-space. Its compliance must be 0;
  /// with small strain it may also be positive.
  bool isDirect(const ContactSpot& spot) const
  {
    return !(spot.thickness > 0.0) &&
      (spot.compliance == 0.0 || (spot.compliance > 0.0 && !this->Strain));
  }
  /// Computes the contact for E* = 1 at ascending deflections (mm) of the whole series, up to the
  /// range. Returns whether the tool fits, as in law().
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
  std::unique_ptr<AxisymmetricTool> Sag; ///< paraboloid that represents the body's curvature
  double SagCurvature;                   ///< 1/mm
  std::shared_ptr<const LayerCurves> Layers;
  std::shared_ptr<const LayerCurves> SagLayers;
};
} // namespace palpate

#endif

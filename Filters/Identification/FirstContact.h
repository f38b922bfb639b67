// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FirstContact_h
#define palpate_FirstContact_h

namespace palpate
{
/// The force that an instrument shows without contact, a straight line over the depth.
struct ForceBaseline
{
  double offset = 0.0;    ///< N, at the reference
  double drift = 0.0;     ///< N/mm
  double reference = 0.0; ///< mm

  double at(double deflection) const
  {
    return this->offset + this->drift * (deflection - this->reference);
  }
};

/// What the readings before contact tell of it; the rest counts as 0.
enum class BaselineTerms
{
  None,
  Offset,
  OffsetAndDrift
};

/// Where contact begins, on what force, and how hard the body is: an estimate to start from.
struct FirstContact
{
  double depth = 0.0;   ///< mm
  double modulus = 0.0; ///< E* of a half-space, MPa; 0: no force rises with the depth
  ForceBaseline baseline;
  BaselineTerms terms = BaselineTerms::None;
};
} // namespace palpate

#endif

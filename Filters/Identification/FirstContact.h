// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FirstContact_h
#define palpate_FirstContact_h

namespace palpate
{
/// The force that an instrument reads without contact, as a straight line over the depth.
struct ForceBaseline
{
  double offset = 0.0;    ///< N, at the reference depth
  double drift = 0.0;     ///< N/mm
  double reference = 0.0; ///< reference depth, mm

  double at(double deflection) const
  {
    return this->offset + this->drift * (deflection - this->reference);
  }
};

/// The terms of a baseline that the readings before contact determine. The other terms are 0.
enum class BaselineTerms
{
  None,
  Offset,
  OffsetAndDrift
};

/// Depth of first contact, baseline of the force, and modulus of the body, used as initial values
/// of fits.
struct FirstContact
{
  double depth = 0.0; ///< mm
  /// E* of a half-space, MPa; 0 if the force does not increase with the depth.
  double modulus = 0.0;
  ForceBaseline baseline;
  BaselineTerms terms = BaselineTerms::None;
};
} // namespace palpate

#endif

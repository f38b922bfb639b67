// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LayerChoice_h
#define palpate_LayerChoice_h

namespace palpate
{
/// What lies under the surface: a layer on a rigid base, as thick as the scan shows or everywhere
/// alike; thickness 0 is a half-space.
struct LayerChoice
{
  bool scanned = false;
  double thickness = 0.0; ///< mm, unless scanned

  bool operator==(const LayerChoice& other) const
  {
    return this->scanned == other.scanned && this->thickness == other.thickness;
  }
};
} // namespace palpate

#endif

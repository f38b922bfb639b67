// SPDX-License-Identifier: BSD-3-Clause
#include "MaterialPreset.h"

#include <array>
#include <cstddef>

namespace palpate
{
namespace
{
struct Published
{
  double youngsModulus; // MPa
  double poissonRatio;
};

constexpr std::array<Published, 9> Materials = { {
  { 0.1, 0.45 }, // values for Custom, not used
  // Mahvash and Hayward 2002, section 4: E* = 3.45 MPa for a rubber, therefore E = 3.45 (1 - 0.5^2)
  // MPa.
  { 2.5875, 0.5 },
  // Johnston et al. 2014, tension: 1.32 MPa if cured at 25 degrees C, 2.97 MPa at 200 degrees C.
  { 1.32, 0.5 },
  // Nguyen et al. 2014, shear waves in 5 % gelatin: G = 4.18 +- 0.84 kPa.
  { 0.01254, 0.5 },
  // Venkatesh et al. 2014, magnetic resonance elastography, 41 persons: G = 2.09 +- 0.22 kPa.
  { 0.00627, 0.5 },
  // Chakouch et al. 2015, magnetic resonance elastography, rectus femoris: G = 3.91 +- 0.16 kPa.
  { 0.01173, 0.5 },
  // Chakouch et al. 2015, fat under the skin of the thigh: G = 3.04 +- 0.12 kPa.
  { 0.00912, 0.5 },
  // Briot et al. 2022, suction, 7 persons: 3.04 +- 1.17 kPa.
  { 0.00304, 0.5 },
  // Briot et al. 2022, skin: 56.3 +- 16.4 kPa.
  { 0.0563, 0.5 },
} };

const Published& published(int material)
{
  return Materials[static_cast<std::size_t>(material)];
}
} // namespace

int MaterialPreset::count()
{
  return static_cast<int>(Materials.size());
}

void MaterialPreset::choose(int material)
{
  if (material >= 0 && material < MaterialPreset::count())
  {
    this->Chosen = material;
  }
}

double MaterialPreset::youngsModulusInForce() const
{
  return this->Chosen == Custom ? this->youngsModulus : published(this->Chosen).youngsModulus;
}

double MaterialPreset::poissonRatioInForce() const
{
  return this->Chosen == Custom ? this->poissonRatio : published(this->Chosen).poissonRatio;
}
} // namespace palpate

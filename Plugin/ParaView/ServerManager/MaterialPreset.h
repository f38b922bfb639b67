// SPDX-License-Identifier: BSD-3-Clause
/**
 * Named materials with published values of Young's modulus and Poisson's ratio.
 *
 * The list has the order of the enumeration "Material" of ToolContactResponse and ContactRegime.
 * The help of the enumeration names author, year and method of measurement. Published values of a
 * soft tissue differ by a factor of two and more, depending on the person, the location, the strain
 * and the method. Therefore a preset is only a starting value. If a shear modulus G was published,
 * E = 3 G is used, which assumes a Poisson's ratio of 0.5.
 */
#ifndef palpate_MaterialPreset_h
#define palpate_MaterialPreset_h

namespace palpate
{
class MaterialPreset
{
public:
  static constexpr int Custom = 0;
  static int count();

  /// Chooses a material by its index, from 0 (Custom) to count() - 1. Other indices are ignored.
  void choose(int material);
  int chosen() const { return this->Chosen; }

  /// Values of the user, which apply to Custom.
  double youngsModulus = 0.1; // MPa
  double poissonRatio = 0.45;

  /// The value in use, either of the material or of the user.
  double youngsModulusInForce() const;
  double poissonRatioInForce() const;

private:
  int Chosen = Custom;
};
} // namespace palpate

/**
 * Adds a property Material to the subclass of a filter. The named material replaces YoungsModulus
 * and PoissonRatio, whose values are kept for Custom. The macro must be used at the end of the
 * class.
 */
#define palpateMaterialPresetMacro()                                                               \
public:                                                                                            \
  void SetMaterial(int material)                                                                   \
  {                                                                                                \
    this->Preset.choose(material);                                                                 \
    this->TakeMaterial();                                                                          \
  }                                                                                                \
  int GetMaterial()                                                                                \
  {                                                                                                \
    return this->Preset.chosen();                                                                  \
  }                                                                                                \
  void SetYoungsModulus(double modulus) override                                                   \
  {                                                                                                \
    this->Preset.youngsModulus = modulus;                                                          \
    this->TakeMaterial();                                                                          \
  }                                                                                                \
  void SetPoissonRatio(double ratio) override                                                      \
  {                                                                                                \
    this->Preset.poissonRatio = ratio;                                                             \
    this->TakeMaterial();                                                                          \
  }                                                                                                \
                                                                                                   \
private:                                                                                           \
  void TakeMaterial()                                                                              \
  {                                                                                                \
    this->Superclass::SetYoungsModulus(this->Preset.youngsModulusInForce());                       \
    this->Superclass::SetPoissonRatio(this->Preset.poissonRatioInForce());                         \
  }                                                                                                \
  palpate::MaterialPreset Preset

#endif

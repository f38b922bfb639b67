// SPDX-License-Identifier: BSD-3-Clause
/**
 * Named materials: Young's modulus and Poisson's ratio as published.
 *
 * The list is the enumeration "Material" of ToolContactResponse and ContactRegime, in its order.
 * The help there names author, year and method of measurement. Published values of a soft tissue
 * differ by a factor of two and more, with the person, the place, the strain and the method: a
 * preset is only a starting value. If a shear modulus G was published, E = 3 G, which assumes
 * Poisson's ratio 0.5.
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

  /// Chooses a material, from 0 (Custom) to count() - 1; other values are ignored.
  void choose(int material);
  int chosen() const { return this->Chosen; }

  /// The user's values, which are used for Custom.
  double youngsModulus = 0.1; // MPa
  double poissonRatio = 0.45;

  /// The value in use, of the material or of the user.
  double youngsModulusInForce() const;
  double poissonRatioInForce() const;

private:
  int Chosen = Custom;
};
} // namespace palpate

/**
 * Adds a property Material to a filter's subclass; used at the end of the class. The named material
 * replaces YoungsModulus and PoissonRatio, whose values are kept for Custom.
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

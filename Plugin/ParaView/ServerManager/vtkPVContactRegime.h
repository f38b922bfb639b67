// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVContactRegime
 * @brief the regime of a material by name
 *
 * A Material by name takes the place of YoungsModulus and PoissonRatio, which are kept for Custom;
 * arrays per point still come first.
 */
#ifndef vtkPVContactRegime_h
#define vtkPVContactRegime_h

#include "MaterialPreset.h"             // For palpate::MaterialPreset
#include "palpateServerManagerModule.h" // For export macro
#include "vtkContactRegime.h"

class PALPATESERVERMANAGER_EXPORT vtkPVContactRegime : public vtkContactRegime
{
public:
  static vtkPVContactRegime* New();
  vtkTypeMacro(vtkPVContactRegime, vtkContactRegime);

  ///@{
  /** 0, the default, is Custom; the others are MaterialPreset's. */
  void SetMaterial(int material);
  int GetMaterial();
  ///@}

  ///@{
  /** Of Custom; in force only then. */
  void SetYoungsModulus(double modulus) override;
  void SetPoissonRatio(double ratio) override;
  ///@}

protected:
  vtkPVContactRegime() = default;
  ~vtkPVContactRegime() override = default;

private:
  vtkPVContactRegime(const vtkPVContactRegime&) = delete;
  void operator=(const vtkPVContactRegime&) = delete;

  void TakeMaterial();

  palpate::MaterialPreset Preset;
};

#endif

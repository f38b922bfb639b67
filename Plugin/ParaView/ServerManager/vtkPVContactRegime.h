// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVContactRegime
 * @brief the regime of a named material
 *
 * A named material replaces YoungsModulus and PoissonRatio, whose values are kept for Custom. Point
 * arrays take precedence over both.
 */
#ifndef vtkPVContactRegime_h
#define vtkPVContactRegime_h

#include "MaterialPreset.h"             // For its macro
#include "palpateServerManagerModule.h" // For export macro
#include "vtkContactRegime.h"

class PALPATESERVERMANAGER_EXPORT vtkPVContactRegime : public vtkContactRegime
{
public:
  static vtkPVContactRegime* New();
  vtkTypeMacro(vtkPVContactRegime, vtkContactRegime);

protected:
  vtkPVContactRegime() = default;
  ~vtkPVContactRegime() override = default;

private:
  vtkPVContactRegime(const vtkPVContactRegime&) = delete;
  void operator=(const vtkPVContactRegime&) = delete;

  palpateMaterialPresetMacro();
};

#endif

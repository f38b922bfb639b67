// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVToolContactResponse
 * @brief responses of any body, of a material by name
 *
 * The filter as ParaView's menu offers it: its body may be any surface or volume, composite or not,
 * in any unit of length; vtkBodySurface makes triangles in mm of it. Settings and results are those
 * of the superclass; all lengths but the input's coordinates are in mm.
 * A Material by name takes the place of YoungsModulus and PoissonRatio, which are kept for Custom;
 * arrays per point still come first.
 */
#ifndef vtkPVToolContactResponse_h
#define vtkPVToolContactResponse_h

#include "BodyInput.h"                  // For palpate::BodyInput
#include "MaterialPreset.h"             // For palpate::MaterialPreset
#include "palpateServerManagerModule.h" // For export macro
#include "vtkToolContactResponse.h"

class PALPATESERVERMANAGER_EXPORT vtkPVToolContactResponse : public vtkToolContactResponse
{
public:
  static vtkPVToolContactResponse* New();
  vtkTypeMacro(vtkPVToolContactResponse, vtkToolContactResponse);

  ///@{
  /** The unit of the input's coordinates: 0 mm (default), 1 cm, 2 m. */
  void SetLengthUnit(int unit);
  int GetLengthUnit();
  ///@}

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

  vtkMTimeType GetMTime() override;

protected:
  vtkPVToolContactResponse() = default;
  ~vtkPVToolContactResponse() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkPVToolContactResponse(const vtkPVToolContactResponse&) = delete;
  void operator=(const vtkPVToolContactResponse&) = delete;

  void TakeMaterial();

  palpate::BodyInput Body;
  palpate::MaterialPreset Preset;
};

#endif

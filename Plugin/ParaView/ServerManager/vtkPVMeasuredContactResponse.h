// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVMeasuredContactResponse
 * @brief measured responses on any body
 *
 * The filter as ParaView's menu offers it: its body may be any surface or volume, composite or not,
 * in any unit of length; vtkBodySurface makes triangles in mm of it. Settings and results are those
 * of the superclass; all lengths but the input's coordinates are in mm.
 */
#ifndef vtkPVMeasuredContactResponse_h
#define vtkPVMeasuredContactResponse_h

#include "BodyInput.h"                  // For palpate::BodyInput
#include "palpateServerManagerModule.h" // For export macro
#include "vtkMeasuredContactResponse.h"

class PALPATESERVERMANAGER_EXPORT vtkPVMeasuredContactResponse : public vtkMeasuredContactResponse
{
public:
  static vtkPVMeasuredContactResponse* New();
  vtkTypeMacro(vtkPVMeasuredContactResponse, vtkMeasuredContactResponse);

  ///@{
  /** The unit of the input's coordinates: 0 mm (default), 1 cm, 2 m. */
  void SetLengthUnit(int unit);
  int GetLengthUnit();
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkPVMeasuredContactResponse() = default;
  ~vtkPVMeasuredContactResponse() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkPVMeasuredContactResponse(const vtkPVMeasuredContactResponse&) = delete;
  void operator=(const vtkPVMeasuredContactResponse&) = delete;

  palpate::BodyInput Body;
};

#endif

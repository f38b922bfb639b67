// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVVoxelBody
 * @brief any body filled with hexahedra
 *
 * The filter as ParaView's menu offers it: its body may be any surface or volume, composite or not,
 * in any unit of length; vtkBodySurface makes triangles in mm of it. Settings and results are those
 * of the superclass; all lengths but the input's coordinates are in mm.
 */
#ifndef vtkPVVoxelBody_h
#define vtkPVVoxelBody_h

#include "BodyInput.h"                  // For palpate::BodyInput
#include "palpateServerManagerModule.h" // For export macro
#include "vtkVoxelBody.h"

class PALPATESERVERMANAGER_EXPORT vtkPVVoxelBody : public vtkVoxelBody
{
public:
  static vtkPVVoxelBody* New();
  vtkTypeMacro(vtkPVVoxelBody, vtkVoxelBody);

  ///@{
  /** The unit of the input's coordinates: 0 mm (default), 1 cm, 2 m. */
  void SetLengthUnit(int unit);
  int GetLengthUnit();
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkPVVoxelBody() = default;
  ~vtkPVVoxelBody() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkPVVoxelBody(const vtkPVVoxelBody&) = delete;
  void operator=(const vtkPVVoxelBody&) = delete;

  palpate::BodyInput Body;
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVElasticCompliance
 * @brief the compliance of any volume
 *
 * The filter as ParaView's menu offers it: its body may be any volume mesh, in any unit of length,
 * in blocks or partitions too, which are joined where their points coincide exactly. A surface is
 * an error that names Voxel Body. Settings and results are those of the superclass; all lengths but
 * the input's coordinates are in mm.
 */
#ifndef vtkPVElasticCompliance_h
#define vtkPVElasticCompliance_h

#include "palpateServerManagerModule.h" // For export macro
#include "vtkElasticCompliance.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

class vtkDataObject;
class vtkUnstructuredGrid;

class PALPATESERVERMANAGER_EXPORT vtkPVElasticCompliance : public vtkElasticCompliance
{
public:
  static vtkPVElasticCompliance* New();
  vtkTypeMacro(vtkPVElasticCompliance, vtkElasticCompliance);

  ///@{
  /** The unit of the input's coordinates: 0 mm (default), 1 cm, 2 m. */
  vtkSetClampMacro(LengthUnit, int, 0, 2);
  vtkGetMacro(LengthUnit, int);
  ///@}

protected:
  vtkPVElasticCompliance() = default;
  ~vtkPVElasticCompliance() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkPVElasticCompliance(const vtkPVElasticCompliance&) = delete;
  void operator=(const vtkPVElasticCompliance&) = delete;

  /** As one mesh in mm; null after an error. */
  vtkSmartPointer<vtkUnstructuredGrid> MakeMesh(vtkDataObject* data);

  int LengthUnit = 0;
};

#endif

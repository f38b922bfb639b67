// SPDX-License-Identifier: BSD-3-Clause
/**
 * The volume input of a proxy. It converts any data of ParaView for a filter that needs one
 * vtkUnstructuredGrid in mm. A thin subclass of the filter gets this member from
 * palpateVolumeInputMacro; see BodyInput.h.
 */
#ifndef palpate_VolumeInput_h
#define palpate_VolumeInput_h

#include "vtkSmartPointer.h"
#include "vtkType.h" // For vtkMTimeType

#include <string> // For std::string

class vtkDataObject;
class vtkInformation;
class vtkInformationVector;
class vtkUnstructuredGrid;

namespace palpate
{
class VolumeInput
{
public:
  /// The unit of the input's coordinates: 0 for mm, 1 for cm, 2 for m.
  int LengthUnit = 0;

  /// Returns the converted inputs of up to three ports. The first port has one mesh in mm, in which
  /// blocks and partitions are joined where their points coincide exactly. The other ports have a
  /// surface, image or mesh in mm. Returns null after an error, which sets `fault`. The same
  /// objects are returned for the same data and unit.
  vtkInformationVector** replace(vtkInformationVector** inputs, int ports, std::string& fault);

private:
  /// The converted data of a port other than the first one, in mm.
  struct Other
  {
    vtkSmartPointer<vtkDataObject> Made;
    vtkSmartPointer<vtkDataObject> MadeOf;
    vtkMTimeType MadeFrom = 0;
    int Unit = 0;
    vtkSmartPointer<vtkInformationVector> Inputs;
  };

  std::string makeMesh(vtkDataObject* data);
  vtkInformationVector* scaled(vtkInformationVector* inputs, Other& other) const;

  vtkSmartPointer<vtkUnstructuredGrid> Kept;
  vtkSmartPointer<vtkDataObject> KeptData;
  vtkMTimeType KeptFrom = 0;
  int KeptUnit = 0;
  vtkSmartPointer<vtkInformationVector> First;
  Other Others[2];
  vtkInformationVector* Inputs[3] = { nullptr, nullptr, nullptr };
};
} // namespace palpate

/// Makes a filter of a volume accept any volume, in any unit of length. The macro must be used at
/// the end of the subclass. The source file needs BodyInput.h, vtkInformation.h and
/// vtkInformationVector.h.
#define palpateVolumeInputMacro()                                                                  \
public:                                                                                            \
  void SetLengthUnit(int unit)                                                                     \
  {                                                                                                \
    const int known = unit < 0 ? 0 : unit > 2 ? 2 : unit;                                          \
    if (this->Volume.LengthUnit != known)                                                          \
    {                                                                                              \
      this->Volume.LengthUnit = known;                                                             \
      this->Modified();                                                                            \
    }                                                                                              \
  }                                                                                                \
  int GetLengthUnit()                                                                              \
  {                                                                                                \
    return this->Volume.LengthUnit;                                                                \
  }                                                                                                \
                                                                                                   \
protected:                                                                                         \
  int FillInputPortInformation(int port, vtkInformation* info) override                            \
  {                                                                                                \
    if (port > 0)                                                                                  \
    {                                                                                              \
      return this->Superclass::FillInputPortInformation(port, info);                               \
    }                                                                                              \
    palpate::BodyInput::admit(info);                                                               \
    return 1;                                                                                      \
  }                                                                                                \
  int RequestData(                                                                                 \
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override  \
  {                                                                                                \
    std::string fault;                                                                             \
    vtkInformationVector** replaced =                                                              \
      this->Volume.replace(input, this->GetNumberOfInputPorts(), fault);                           \
    if (!replaced)                                                                                 \
    {                                                                                              \
      vtkErrorMacro(<< fault << ".");                                                              \
      return 0;                                                                                    \
    }                                                                                              \
    return this->Superclass::RequestData(request, replaced, output);                               \
  }                                                                                                \
                                                                                                   \
private:                                                                                           \
  palpate::VolumeInput Volume

#endif

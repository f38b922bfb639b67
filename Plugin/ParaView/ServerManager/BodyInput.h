// SPDX-License-Identifier: BSD-3-Clause
/**
 * The body input of a proxy. It converts any data of ParaView for a filter that needs triangles in
 * mm.
 *
 * A thin subclass of the filter gets this member from palpateBodyInputMacro. The subclass declares
 * that the port accepts any data, and its RequestData runs the filter's own RequestData on replaced
 * inputs. For data that are not a body, vtkBodySurface reports an error that names the filter to
 * apply first.
 */
#ifndef palpate_BodyInput_h
#define palpate_BodyInput_h

#include "vtkBodySurface.h" // For vtkBodySurface
#include "vtkNew.h"         // For vtkNew
#include "vtkSmartPointer.h"
#include "vtkType.h" // For vtkMTimeType

#include <algorithm> // For std::max
#include <vector>    // For std::vector

class vtkInformation;
class vtkInformationVector;

namespace palpate
{
class BodyInput
{
public:
  /// To be called in FillInputPortInformation. Makes the port accept any data, with composites
  /// passed as a whole.
  static void admit(vtkInformation* port);

  /// To be called in RequestUpdateExtent after the function of the filter, because volumes that
  /// consist of pieces need ghost cells.
  static void askForGhosts(vtkInformationVector** inputs, vtkInformationVector* outputs);

  /// The filter that converts the body, with the settings of the user. It is not an input of the
  /// main filter, so GetMTime must include its modification time.
  vtkBodySurface* surface() { return this->Surface; }

  /// Returns the inputs of `ports` ports, with the data of the first one replaced by triangles in
  /// mm. After an error, returns null on all ranks. The result is cached for the same data, unit
  /// and rank.
  vtkInformationVector** replace(vtkInformationVector** inputs, int ports);

private:
  bool isKept(vtkDataObject* data) const;

  vtkNew<vtkBodySurface> Surface;
  vtkSmartPointer<vtkPolyData> Kept;
  // Modification times of the data and of the settings for which the result was computed.
  vtkMTimeType KeptFrom = 0;
  vtkMTimeType KeptBy = 0;
  vtkSmartPointer<vtkInformationVector> First;
  std::vector<vtkInformationVector*> Inputs;
};
} // namespace palpate

/**
 * Makes a filter accept any surface or volume, composite or not, in any unit of length. The unit is
 * 0 for mm (the default), 1 for cm and 2 for m. The macro must be used at the end of the subclass.
 */
#define palpateBodyInputMacro()                                                                    \
public:                                                                                            \
  void SetLengthUnit(int unit)                                                                     \
  {                                                                                                \
    this->Body.surface()->SetLengthUnit(unit);                                                     \
  }                                                                                                \
  int GetLengthUnit()                                                                              \
  {                                                                                                \
    return this->Body.surface()->GetLengthUnit();                                                  \
  }                                                                                                \
  vtkMTimeType GetMTime() override                                                                 \
  {                                                                                                \
    return std::max(this->Superclass::GetMTime(), this->Body.surface()->GetMTime());               \
  }                                                                                                \
                                                                                                   \
protected:                                                                                         \
  int FillInputPortInformation(int port, vtkInformation* info) override                            \
  {                                                                                                \
    const int known = this->Superclass::FillInputPortInformation(port, info);                      \
    if (port == 0)                                                                                 \
    {                                                                                              \
      palpate::BodyInput::admit(info);                                                             \
    }                                                                                              \
    return known;                                                                                  \
  }                                                                                                \
  int RequestUpdateExtent(                                                                         \
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override  \
  {                                                                                                \
    const int done = this->Superclass::RequestUpdateExtent(request, input, output);                \
    palpate::BodyInput::askForGhosts(input, output);                                               \
    return done;                                                                                   \
  }                                                                                                \
  int RequestData(                                                                                 \
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override  \
  {                                                                                                \
    vtkInformationVector** replaced = this->Body.replace(input, this->GetNumberOfInputPorts());    \
    return replaced ? this->Superclass::RequestData(request, replaced, output) : 0;                \
  }                                                                                                \
                                                                                                   \
private:                                                                                           \
  palpate::BodyInput Body

#endif

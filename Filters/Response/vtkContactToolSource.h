// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkContactToolSource
 * @brief geometry of a vtkContactTool, for display
 *
 * The output consists of triangles with outward normals, in mm. The tip is at the origin, and the
 * axis of the tool points along +z. The profile is followed by a straight shaft up to Length. A
 * tool with a wall (Flat, Sphere, Profile) is drawn up to its wall. A profile without a wall (all
 * other shapes) ends at MaximumRadius, or at 9/10 of Length, and continues as a shaft. Edges and
 * corners of the profile are points of the geometry.
 *
 * @code{.py}
 * source = palpate.vtkContactToolSource()
 * source.SetTool(tool)
 * source.SetLength(30)                                 # mm
 * source.Update()
 * shape = source.GetOutput()                           # triangles, tip at the origin, mm
 * @endcode
 */
#ifndef vtkContactToolSource_h
#define vtkContactToolSource_h

#include "palpateResponseModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

class vtkContactTool;

class PALPATERESPONSE_EXPORT vtkContactToolSource : public vtkPolyDataAlgorithm
{
public:
  static vtkContactToolSource* New();
  vtkTypeMacro(vtkContactToolSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The tool. It is required. */
  virtual void SetTool(vtkContactTool* tool);
  vtkContactTool* GetTool();
  ///@}

  ///@{
  /** Height of the whole drawn tool, mm, > 0. Default 40. */
  vtkSetMacro(Length, double);
  vtkGetMacro(Length, double);
  ///@}

  ///@{
  /** Largest radius to which a widening profile is drawn, mm, > 0. Default 8. */
  vtkSetMacro(MaximumRadius, double);
  vtkGetMacro(MaximumRadius, double);
  ///@}

  ///@{
  /** Number of facets around the axis, at least 3. Default 64. */
  vtkSetClampMacro(Resolution, int, 3, 1024);
  vtkGetMacro(Resolution, int);
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkContactToolSource();
  ~vtkContactToolSource() override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkContactToolSource(const vtkContactToolSource&) = delete;
  void operator=(const vtkContactToolSource&) = delete;

  vtkSmartPointer<vtkContactTool> Tool;
  double Length = 40.0;
  double MaximumRadius = 8.0;
  int Resolution = 64;
};

#endif

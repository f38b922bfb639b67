// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHapticToolRepresentation
 * @brief the tool where it touches, and the force on it as an arrow with its value
 *
 * The tool stands on its tip along the contact normal, translucent, so that neither the dent nor
 * the arrow hides in it. The arrow starts at the contact point, is ForceScale mm long per newton,
 * and carries the magnitude in newtons at its head. Without force there is no arrow.
 *
 * Body frame; mm and N.
 */
#ifndef vtkHapticToolRepresentation_h
#define vtkHapticToolRepresentation_h

#include "palpateInteractionModule.h" // For export macro
#include "vtkPropAssembly.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

class vtkActor;
class vtkArrowSource;
class vtkContactTool;
class vtkContactToolSource;
class vtkTextActor;

class PALPATEINTERACTION_EXPORT vtkHapticToolRepresentation : public vtkPropAssembly
{
public:
  static vtkHapticToolRepresentation* New();
  vtkTypeMacro(vtkHapticToolRepresentation, vtkPropAssembly);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The tool drawn; required before the first rendering. */
  void SetTool(vtkContactTool* tool);
  vtkContactTool* GetTool();
  ///@}

  ///@{
  /** Length of the arrow, mm per N, > 0. Default 10. */
  vtkSetMacro(ForceScale, double);
  vtkGetMacro(ForceScale, double);
  ///@}

  ///@{
  /** Length of the drawn tool, mm, > 0. Default 22. */
  void SetToolLength(double length);
  double GetToolLength();
  ///@}

  /**
   * Places the tool: its tip, the outward normal it stands along, where the arrow starts, and the
   * force on it (N). A zero normal leaves the direction as it was.
   */
  void SetContact(const double tip[3], const double normal[3], const double contactPoint[3],
    const double force[3]);

protected:
  vtkHapticToolRepresentation();
  ~vtkHapticToolRepresentation() override;

private:
  vtkHapticToolRepresentation(const vtkHapticToolRepresentation&) = delete;
  void operator=(const vtkHapticToolRepresentation&) = delete;

  vtkSmartPointer<vtkContactToolSource> Source;
  vtkSmartPointer<vtkActor> ToolActor;
  vtkSmartPointer<vtkArrowSource> Arrow;
  vtkSmartPointer<vtkActor> ArrowActor;
  vtkSmartPointer<vtkTextActor> Label;
  double ForceScale = 10.0;
  double Axis[3] = { 0.0, 0.0, 1.0 }; ///< the tool stands along it
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef VerdictPanel_h
#define VerdictPanel_h

#include "Comparison/RegimeStatement.h"

#include "vtkSmartPointer.h"

class vtkRenderWindow;
class vtkRenderer;
class vtkTextActor;

namespace palpate
{
/// Shows a statement in words next to a patch in the colour of the verdict.
class VerdictPanel
{
public:
  VerdictPanel();
  ~VerdictPanel();
  VerdictPanel(const VerdictPanel&) = delete;
  VerdictPanel& operator=(const VerdictPanel&) = delete;

  /// Adds the panel to a part of the window. `viewport` contains left, bottom, right and top as
  /// fractions of the window.
  void addTo(vtkRenderWindow* window, const double (&viewport)[4]);

  void show(const RegimeStatement& statement);

private:
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderer> Patch;
  vtkSmartPointer<vtkTextActor> Verdict;
  vtkSmartPointer<vtkTextActor> Numbers;
  vtkSmartPointer<vtkTextActor> Explanation; ///< explanation of the terms
};
} // namespace palpate

#endif

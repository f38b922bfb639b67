// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneLegends_h
#define SceneLegends_h

#include "vtkNew.h"

class vtkLookupTable;
class vtkRenderer;
class vtkScalarBarActor;

namespace palpate
{
/// The colours of a scene, of the displacement (mm) and of the force along the trail (N), and their
/// legends, in a column at the right edge.
class SceneLegends
{
public:
  SceneLegends();
  ~SceneLegends();
  SceneLegends(const SceneLegends&) = delete;
  SceneLegends& operator=(const SceneLegends&) = delete;

  vtkLookupTable* displacementColors() { return this->DisplacementColors; }
  vtkLookupTable* forceColors() { return this->ForceColors; }
  vtkScalarBarActor* displacement() { return this->Displacement; }
  vtkScalarBarActor* force() { return this->Force; }

  /// The fraction of a viewport's width that the column takes.
  static double share(vtkRenderer* renderer);
  /// `captionHeight`: pixels that the caption below them takes.
  void place(vtkRenderer* renderer, double captionHeight);

private:
  vtkNew<vtkLookupTable> DisplacementColors;
  vtkNew<vtkLookupTable> ForceColors;
  vtkNew<vtkScalarBarActor> Displacement;
  vtkNew<vtkScalarBarActor> Force;
};
} // namespace palpate

#endif

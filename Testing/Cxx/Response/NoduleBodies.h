// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_NoduleBodies_h
#define palpate_testing_NoduleBodies_h

#include "TestBodies.h"
#include "VolumeBlock.h"

#include "vtkNoduleDetectability.h"
#include "vtkNoduleMaterial.h"

#include <string>

namespace palpate::testing
{
using Detectability = vtkSmartPointer<vtkNoduleDetectability>;

/// A grid of 1 MPa with one ball inside.
inline Grid withNodule(
  vtkUnstructuredGrid* grid, double x, double y, double z, double radius, double young)
{
  vtkNew<vtkNoduleMaterial> nodule;
  nodule->SetInputData(grid);
  nodule->SetYoungsModulus(1.0);
  nodule->AddNodule(x, y, z, radius, young);
  nodule->Update();
  return nodule->GetOutput();
}

/// The detectability of its nodule with a tool.
inline Detectability felt(vtkUnstructuredGrid* grid, const std::string& tool, double deflection)
{
  auto filter = Detectability::New();
  filter->SetInputData(grid);
  filter->SetTool(makeTool(tool));
  filter->SetMaximumDeflection(deflection);
  return filter;
}
} // namespace palpate::testing

#endif

// SPDX-License-Identifier: BSD-3-Clause
// A response: from RequestData to the arrays, on a half-space and on one layer, for each plain
// tool.
#include "Counted.h"
#include "Response/TestBodies.h"

#include "vtkToolContactResponse.h"

#include <cstdio>

using namespace palpate::testing;

int main()
{
  const Body body = sphereBody(40.0, 2);
  addRadialNormals(body);
  vtkNew<vtkToolContactResponse> filters[2];
  int index = 0;
  for (vtkToolContactResponse* filter : { filters[0].Get(), filters[1].Get() })
  {
    vtkNew<vtkContactTool> tool;
    tool->SetShapeToSphere();
    filter->SetTool(tool);
    filter->SetInputData(body);
    filter->SetYoungsModulus(0.1);
    filter->SetPoissonRatio(0.45);
    filter->SetMaximumDeflection(1.0);
    if (index++ > 0)
    {
      filter->SetLayerThickness(5.0);
    }
    filter->UpdateInformation();
  }
  palpate::reading::counted(
    [&]
    {
      filters[0]->Update();
      filters[1]->Update();
    });
  for (vtkToolContactResponse* filter : { filters[0].Get(), filters[1].Get() })
  {
    std::printf(
      "%g N ", filter->GetOutput()->GetPointData()->GetArray("ResponseForce")->GetRange(0)[1]);
  }
  std::printf("\n");
  return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
// A VTK program that uses the installed filters: a ball pressed half a millimetre deep by a flat.
#include <vtkContactTool.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>
#include <vtkToolContactProbe.h>
#include <vtkToolContactResponse.h>

#include <cmath>
#include <cstdio>

int main()
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(50.0);
  ball->SetThetaResolution(100);
  ball->SetPhiResolution(100);
  vtkNew<vtkContactTool> tool;
  tool->SetShapeToFlat();
  tool->SetRadius(2.0);
  vtkNew<vtkToolContactResponse> response;
  response->SetInputConnection(ball->GetOutputPort());
  response->SetTool(tool);
  response->SetYoungsModulus(0.75);
  response->SetPoissonRatio(0.5); // E* = 1 MPa
  response->CurvatureCorrectionOff();
  vtkNew<vtkPoints> point;
  point->InsertNextPoint(0.0, 0.0, 49.5);
  vtkNew<vtkPolyData> tip;
  tip->SetPoints(point);
  vtkNew<vtkToolContactProbe> probe;
  probe->SetInputConnection(0, response->GetOutputPort());
  probe->SetTipData(tip);
  probe->Update();
  const double depth = probe->GetOutput()->GetPointData()->GetArray("Deflection")->GetTuple1(0);
  const double force = probe->GetOutput()->GetPointData()->GetArray("NormalForce")->GetTuple1(0);
  std::printf("deflection %.6g mm, force %.6g N\n", depth, force);
  // F = 2 a E* δ; responses are stored as floats.
  return std::abs(force - 4.0 * depth) < 1e-6 && std::abs(depth - 0.5) < 0.01 ? 0 : 1;
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/DrawnSurface.h"

#include "Interaction/Display/ModeAttributes.h"
#include "Response/BodyConversion.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstddef>

namespace palpate
{
namespace
{
vtkSmartPointer<vtkFloatArray> normalsOf(const BodyMesh& mesh)
{
  auto normals = vtkSmartPointer<vtkFloatArray>::New();
  normals->SetName(DrawnSurface::Normals);
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(static_cast<vtkIdType>(mesh.pointCount()));
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    const Eigen::Vector3f normal = mesh.pointNormal(static_cast<std::int32_t>(i)).cast<float>();
    normals->SetTypedTuple(i, normal.data());
  }
  return normals;
}
} // namespace

void DrawnSurface::give(
  vtkPolyData* body, const std::vector<vtkDataArray*>& modes, vtkPolyDataMapper* mapper)
{
  vtkNew<vtkPolyData> drawn;
  drawn->CopyStructure(body);
  const BodyMesh mesh = makeBodyMesh(body);
  drawn->GetPointData()->SetNormals(normalsOf(mesh));
  vtkNew<vtkFloatArray> none; // without it the mapper would make no texture of the colours
  none->SetName(Displacement);
  none->SetNumberOfTuples(drawn->GetNumberOfPoints());
  none->Fill(0.0);
  drawn->GetPointData()->AddArray(none);
  addModeAttributes(mesh, modes, drawn, mapper);
  mapper->SetInputData(drawn);
}

double DrawnSurface::edgeOf(const std::array<Vector3, 3>& corners)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    sum += (corners[(i + 1) % 3] - corners[i]).norm();
  }
  return sum / 3.0;
}

double DrawnSurface::longestOf(const std::vector<vtkDataArray*>& modes)
{
  double longest = 0.0;
  for (vtkDataArray* mode : modes)
  {
    longest = std::max(longest, mode->GetMaxNorm());
  }
  return longest;
}

std::vector<vtkMTimeType> DrawnSurface::timesOf(
  vtkPolyData* body, const std::vector<vtkDataArray*>& modes)
{
  std::vector<vtkMTimeType> times;
  if (body->GetPoints())
  {
    times = { body->GetPoints()->GetMTime(), body->GetVerts()->GetMTime(),
      body->GetLines()->GetMTime(), body->GetPolys()->GetMTime(), body->GetStrips()->GetMTime() };
  }
  for (vtkDataArray* mode : modes)
  {
    times.push_back(mode->GetMTime());
  }
  return times;
}
} // namespace palpate

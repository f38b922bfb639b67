// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/DrawnSurface.h"

#include "Contact/BodyMesh.h"
#include "Response/Bodies/SoundBody.h"
#include "Response/BodyConversion.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkSmartPointer.h"

#include <Eigen/Geometry>

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

constexpr int FloatsPerMode = 6;
constexpr int FloatsPerAttribute = 4;

std::string attribute(int index)
{
  return "palpateMode" + std::to_string(index);
}

int attributeCount(int modes)
{
  return (modes * FloatsPerMode + FloatsPerAttribute - 1) / FloatsPerAttribute;
}

/// Returns the GLSL expression for the float with index `place` in the data of a vertex.
std::string component(int place)
{
  return attribute(place / FloatsPerAttribute) + "[" + std::to_string(place % FloatsPerAttribute) +
    "]";
}

std::string vectorFrom(int place)
{
  return "vec3(" + component(place) + ", " + component(place + 1) + ", " + component(place + 2) +
    ")";
}

Vector3 valueAt(vtkDataArray* mode, std::int32_t point)
{
  Vector3 value;
  mode->GetTuple(point, value.data());
  return value;
}

/// Returns the change of the normal -(∇φ)ᵀ n at a point, as the area-weighted mean over the
/// triangles around the point. The mode φ is linear in each triangle.
Vector3 turnAt(const BodyMesh& mesh, vtkDataArray* mode, std::int32_t point)
{
  const Vector3 normal = mesh.pointNormal(point);
  Vector3 sum = Vector3::Zero();
  double area = 0.0;
  const auto around = mesh.trianglesAround(point);
  for (const std::int32_t* triangle = around[0]; triangle != around[1]; ++triangle)
  {
    const TriangleCorners& corners = mesh.corners(*triangle);
    const Vector3 p[3] = { mesh.point(corners[0]), mesh.point(corners[1]), mesh.point(corners[2]) };
    const Vector3 twice = (p[1] - p[0]).cross(p[2] - p[0]);
    const Vector3 up = twice.normalized();
    for (std::size_t i = 0; i < 3; ++i)
    {
      // Twice the area times the gradient of area coordinate i of the triangle.
      const Vector3 gradient = up.cross(p[(i + 2) % 3] - p[(i + 1) % 3]);
      sum -= normal.dot(valueAt(mode, corners[i])) * gradient;
    }
    area += twice.norm();
  }
  return area > 0.0 ? Vector3(sum / area) : sum;
}
} // namespace

void DrawnSurface::give(
  vtkPolyData* body, const std::vector<vtkDataArray*>& modes, vtkPolyDataMapper* mapper)
{
  const SoundBody sound(body);
  vtkNew<vtkPolyData> drawn;
  vtkPolyData* surface = sound.fault().empty() ? sound.body() : body;
  drawn->CopyStructure(surface);
  const BodyMesh mesh = makeBodyMesh(surface);
  drawn->GetPointData()->SetNormals(normalsOf(mesh));
  vtkNew<vtkFloatArray> none; // the mapper makes a texture of the colours only if this array exists
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

void addModeAttributes(const BodyMesh& mesh, const std::vector<vtkDataArray*>& modes,
  vtkPolyData* drawn, vtkPolyDataMapper* mapper)
{
  const int count = static_cast<int>(std::min(modes.size(), MostModes));
  std::vector<vtkFloatArray*> packed;
  for (int i = 0; i < attributeCount(count); ++i)
  {
    vtkNew<vtkFloatArray> array;
    array->SetName(attribute(i).c_str());
    array->SetNumberOfComponents(FloatsPerAttribute);
    array->SetNumberOfTuples(drawn->GetNumberOfPoints());
    array->Fill(0.0);
    drawn->GetPointData()->AddArray(array);
    mapper->MapDataArrayToVertexAttribute(
      array->GetName(), array->GetName(), vtkDataObject::FIELD_ASSOCIATION_POINTS);
    packed.push_back(array);
  }
  const auto points = static_cast<std::int32_t>(drawn->GetNumberOfPoints());
  for (std::int32_t point = 0; point < points; ++point)
  {
    for (int k = 0; k < count; ++k)
    {
      vtkDataArray* mode = modes[static_cast<std::size_t>(k)];
      Eigen::Matrix<double, FloatsPerMode, 1> values;
      values << valueAt(mode, point), turnAt(mesh, mode, point);
      for (int i = 0; i < FloatsPerMode; ++i)
      {
        const int place = k * FloatsPerMode + i;
        packed[static_cast<std::size_t>(place / FloatsPerAttribute)]->SetTypedComponent(
          point, place % FloatsPerAttribute, static_cast<float>(values[i]));
      }
    }
  }
}

std::string modeDeclarations(int modes)
{
  std::string text;
  for (int i = 0; i < attributeCount(modes); ++i)
  {
    text += "in vec4 " + attribute(i) + ";\n";
  }
  return text;
}

std::string modeSum(int modes, const std::string& weights, const std::string& displacement,
  const std::string& normal, const std::string& exaggeration)
{
  std::string text;
  for (int k = 0; k < modes; ++k)
  {
    const std::string weight = weights + "[" + std::to_string(k) + "]";
    const int place = k * FloatsPerMode;
    text += "  " + displacement + " += " + weight + " * " + vectorFrom(place) + ";\n";
    text += "  " + normal + " += " + exaggeration + " * " + weight + " * " + vectorFrom(place + 3) +
      ";\n";
  }
  return text;
}
} // namespace palpate

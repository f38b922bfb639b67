// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_TestBodies_h
#define palpate_testing_TestBodies_h

#include "vtkCellArray.h"
#include "vtkContactTool.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkLinearSubdivisionFilter.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPlatonicSolidSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkSmartPointer.h"
#include "vtkToolContactResponse.h"

#include <array>
#include <cmath>
#include <map>
#include <random>
#include <string>

namespace palpate::testing
{
using Body = vtkSmartPointer<vtkPolyData>;

/// An icosahedron whose faces are split into four `level` times. Its points are at the distance
/// `radius` (mm, exact in double) from the origin. It has no normals.
inline Body sphereBody(double radius, int level)
{
  vtkNew<vtkPlatonicSolidSource> solid;
  solid->SetSolidTypeToIcosahedron();
  solid->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkNew<vtkLinearSubdivisionFilter> finer;
  finer->SetInputConnection(solid->GetOutputPort());
  finer->SetNumberOfSubdivisions(level);
  vtkNew<vtkPolyDataNormals> outward;
  outward->SetInputConnection(finer->GetOutputPort());
  outward->ConsistencyOn();
  outward->AutoOrientNormalsOn();
  outward->SplittingOff();
  outward->Update();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < outward->GetOutput()->GetNumberOfPoints(); ++i)
  {
    double x[3];
    outward->GetOutput()->GetPoint(i, x);
    vtkMath::Normalize(x);
    vtkMath::MultiplyScalar(x, radius);
    points->InsertNextPoint(x);
  }
  auto body = Body::New();
  body->SetPoints(points);
  body->SetPolys(outward->GetOutput()->GetPolys());
  return body;
}

/// The lower half of such a sphere, with inward winding: a bowl that is pressed from above. It has
/// only the points that its triangles use.
inline Body hollowBody(double radius, int level)
{
  const Body ball = sphereBody(radius, level);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  std::map<vtkIdType, vtkIdType> ids;
  for (vtkIdType cell = 0; cell < ball->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    ball->GetPolys()->GetCellAtId(cell, size, corners);
    std::array<vtkIdType, 3> own{};
    double height = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      height += ball->GetPoint(corners[k])[2];
    }
    for (std::size_t k = 0; k < 3 && height < 0.0; ++k)
    {
      const auto found = ids.find(corners[k]);
      own[k] =
        found != ids.end() ? found->second : points->InsertNextPoint(ball->GetPoint(corners[k]));
      ids.emplace(corners[k], own[k]);
    }
    if (height < 0.0)
    {
      triangles->InsertNextCell({ own[0], own[2], own[1] });
    }
  }
  auto body = Body::New();
  body->SetPoints(points);
  body->SetPolys(triangles);
  return body;
}

/// Rounds the points to multiples of 2^-16 mm, which the kernel's float coordinates represent
/// exactly on bodies of less than 128 mm. For references that use the body's own coordinates.
inline void snapPoints(vtkPolyData* body)
{
  constexpr double Grid = 1.0 / 65536.0;
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    double x[3];
    body->GetPoint(i, x);
    for (double& c : x)
    {
      c = Grid * std::round(c / Grid);
    }
    body->GetPoints()->SetPoint(i, x);
  }
}

/// Sets exact normals of a sphere around the origin as the active point normals, with the given
/// length.
inline void addRadialNormals(vtkPolyData* body, double length = 1.0)
{
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Radial");
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    double x[3];
    body->GetPoint(i, x);
    vtkMath::Normalize(x);
    vtkMath::MultiplyScalar(x, length);
    normals->InsertNextTuple(x);
  }
  body->GetPointData()->SetNormals(normals);
}

/// A square in the plane z = `height` from -half to half along x and y, with cells² pairs of
/// triangles. Its normal is +z.
inline Body planeBody(double half, int cells, double height = 0.0)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  const auto id = [cells](int i, int j) { return static_cast<vtkIdType>(j) * (cells + 1) + i; };
  for (int j = 0; j <= cells; ++j)
  {
    for (int i = 0; i <= cells; ++i)
    {
      points->InsertNextPoint(
        half * (2 * i - cells) / cells, half * (2 * j - cells) / cells, height);
      if (i < cells && j < cells)
      {
        triangles->InsertNextCell({ id(i, j), id(i + 1, j), id(i + 1, j + 1) });
        triangles->InsertNextCell({ id(i, j), id(i + 1, j + 1), id(i, j + 1) });
      }
    }
  }
  auto body = Body::New();
  body->SetPoints(points);
  body->SetPolys(triangles);
  return body;
}

/// A box around the origin with outward winding. Each face has cells² pairs of triangles. Faces
/// have common points only at their edges.
inline Body boxBody(double halfX, double halfY, double halfZ, int cells)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  const double half[3] = { halfX, halfY, halfZ };
  std::map<std::array<int, 3>, vtkIdType> ids;
  const auto pointId = [&](std::array<int, 3> index)
  {
    const auto found = ids.find(index);
    if (found != ids.end())
    {
      return found->second;
    }
    const vtkIdType id = points->InsertNextPoint(half[0] * (2 * index[0] - cells) / cells,
      half[1] * (2 * index[1] - cells) / cells, half[2] * (2 * index[2] - cells) / cells);
    ids.emplace(index, id);
    return id;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (const bool upper : { false, true })
    {
      // The axes u and v are counter-clockwise as seen from outside.
      const std::size_t u = (axis + (upper ? 1 : 2)) % 3;
      const std::size_t v = (axis + (upper ? 2 : 1)) % 3;
      const auto corner = [&](int i, int j)
      {
        std::array<int, 3> index{};
        index[axis] = upper ? cells : 0;
        index[u] = i;
        index[v] = j;
        return pointId(index);
      };
      for (int j = 0; j < cells; ++j)
      {
        for (int i = 0; i < cells; ++i)
        {
          triangles->InsertNextCell({ corner(i, j), corner(i + 1, j), corner(i + 1, j + 1) });
          triangles->InsertNextCell({ corner(i, j), corner(i + 1, j + 1), corner(i, j + 1) });
        }
      }
    }
  }
  auto body = Body::New();
  body->SetPoints(points);
  body->SetPolys(triangles);
  return body;
}

/// Tools with F ∝ δ^exponent whose contact radius has a closed form.
struct SinkingTool
{
  const char* tool;
  double exponent;
  double radius; ///< contact radius at a depth of 1 mm, mm
};
inline const std::array<SinkingTool, 3> SinkingTools = { { { "flat:1.6", 1.0, 1.6 },
  { "paraboloid:5", 1.5, std::sqrt(5.0) },
  { "cone:60", 2.0, 2.0 / vtkMath::Pi() * std::sqrt(3.0) } } };

inline vtkSmartPointer<vtkContactTool> makeTool(const std::string& specification)
{
  auto tool = vtkSmartPointer<vtkContactTool>::New();
  tool->SetSpecification(specification);
  return tool;
}

/// A filter for a tool that is pressed `range` mm into a material of 0.1 MPa with Poisson's ratio
/// 0.45.
inline vtkSmartPointer<vtkToolContactResponse> filterOf(
  vtkPolyData* body, const char* tool, double range)
{
  auto filter = vtkSmartPointer<vtkToolContactResponse>::New();
  filter->SetInputData(body);
  filter->SetTool(makeTool(tool));
  filter->SetYoungsModulus(0.1);
  filter->SetPoissonRatio(0.45);
  filter->SetMaximumDeflection(range);
  return filter;
}

/// Selects the law without corrections, with validity up to its first violated assumption.
inline void makePlain(vtkToolContactResponse* filter)
{
  filter->CurvatureCorrectionOff();
  filter->SetErrorTolerance(0.0);
}

/// The body with the uncorrected response of a tool; E* = 3.45 MPa at ν = 0, as in the reference
/// tables.
inline Body withResponse(vtkPolyData* body, const std::string& tool, double range = 2.0)
{
  vtkNew<vtkToolContactResponse> filter;
  filter->SetInputData(body);
  filter->SetTool(makeTool(tool));
  filter->SetYoungsModulus(3.45);
  filter->SetPoissonRatio(0.0);
  filter->SetMaximumDeflection(range);
  makePlain(filter);
  filter->Update();
  auto copy = Body::New();
  copy->ShallowCopy(filter->GetOutput());
  return copy;
}

/// Random tips inside and outside a body, in a cube of size `reach` around the origin.
inline Body tipsInCube(int count, double reach, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-reach, reach);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < count; ++i)
  {
    const double x = coordinate(random); // first, since arguments may be evaluated in any order
    const double y = coordinate(random);
    points->InsertNextPoint(x, y, coordinate(random));
  }
  auto tips = Body::New();
  tips->SetPoints(points);
  return tips;
}

/// An array with one number per point, a function of the point's index.
template <class Array = vtkDoubleArray, class Function>
vtkSmartPointer<Array> pointArray(vtkPolyData* body, const char* name, const Function& value)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    array->InsertNextTuple1(value(i));
  }
  body->GetPointData()->AddArray(array);
  return array;
}
} // namespace palpate::testing

#endif

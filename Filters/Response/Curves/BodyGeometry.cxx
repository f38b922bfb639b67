// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Curves/BodyGeometry.h"

#include "Mechanics/RecentValues.h"
#include "Response/Bodies/BodyContent.h"
#include "Response/Curves/PointNormals.h"
#include "Response/Pieces/BodySeam.h"
#include "Response/Pieces/Ranks.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
constexpr std::size_t MostGeometries = 4;
constexpr std::size_t MostBytesOfGeometries = std::size_t{ 128 } << 20;
constexpr std::size_t BytesPerPoint = 20;

/// Returns the active point normals of the body, 3 numbers per point. Returns an empty list if the
/// body has none.
std::vector<double> storedNormals(vtkPolyData* body)
{
  vtkDataArray* stored = body->GetPointData()->GetNormals();
  std::vector<double> normals(
    stored ? 3 * static_cast<std::size_t>(stored->GetNumberOfTuples()) : 0);
  for (std::size_t i = 0; i < normals.size(); i += 3)
  {
    stored->GetTuple(static_cast<vtkIdType>(i / 3), normals.data() + i);
  }
  return normals;
}

std::shared_ptr<const BodyGeometry> makeGeometry(vtkPolyData* body, const BodySeam& seam)
{
  auto made = std::make_shared<BodyGeometry>();
  vtkNew<vtkFloatArray> normals;
  vtkNew<vtkUnsignedCharArray> status;
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(body->GetNumberOfPoints());
  status->SetNumberOfTuples(body->GetNumberOfPoints());
  made->fault = fillPointNormals(body, seam, normals, status);
  if (made->fault.empty())
  {
    const float* normal = normals->GetPointer(0);
    const unsigned char* state = status->GetPointer(0);
    made->normals.assign(normal, normal + normals->GetNumberOfValues());
    made->status.assign(state, state + status->GetNumberOfValues());
    made->bound = std::make_unique<CurvatureBound>(body, seam, normal);
    made->lengths = lengthsOf(body, seam.ranks());
  }
  return made;
}
} // namespace

std::shared_ptr<const BodyGeometry> findGeometry(
  vtkPolyData* body, const BodyContent& content, const BodySeam& seam)
{
  const bool hasOtherCells = body->GetNumberOfVerts() + body->GetNumberOfLines() > 0;
  // Only whole bodies are cached. Bodies with other cells are not cached, because the key of the
  // cache contains only triangles.
  if (!seam.ranks().areAlone() || hasOtherCells)
  {
    return makeGeometry(body, seam);
  }
  using Key = std::array<std::size_t, 3>;
  static RecentValues<Key, BodyGeometry> recent(MostGeometries, MostBytesOfGeometries);
  const std::vector<double> normals = storedNormals(body);
  const Key key{ content.hash[0], content.hash[1], hashOf(normals.data(), normals.size()) };
  return recent.get(key,
    [&]
    {
      return std::make_pair(makeGeometry(body, seam),
        BytesPerPoint * static_cast<std::size_t>(body->GetNumberOfPoints()));
    });
}
} // namespace palpate

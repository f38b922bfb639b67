// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/ClosedSurface.h"

#include "Mechanics/JoinedText.h"
#include "Response/Bodies/SoundBody.h"
#include "Response/BodyConversion.h"
#include "SolidResponse/Bodies/VolumeConversion.h"

#include "vtkCleanPolyData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace palpate
{
namespace
{
/// Merges points at the same position. The result has no arrays.
vtkSmartPointer<vtkPolyData> mergePoints(vtkPolyData* body)
{
  vtkNew<vtkPolyData> bare;
  bare->CopyStructure(body);
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(bare);
  clean->ToleranceIsAbsoluteOn();
  clean->SetAbsoluteTolerance(0.0);
  clean->ConvertPolysToLinesOff();
  clean->Update();
  return clean->GetOutput();
}

// Smallest cosine of the angle between the normal of a held outer face and the normal of its side
// of the box.
constexpr double LeastCosine = 0.70710678;

Eigen::Vector3d placeOf(vtkDataSet* data, vtkIdType point)
{
  Eigen::Vector3d place;
  data->GetPoint(point, place.data());
  return place;
}

/// Distances of positions from the sides of a body's bounding box.
class SidesOfBox
{
public:
  SidesOfBox(vtkDataSet* body, const HeldFaces& faces)
    : Faces(faces)
  {
    body->GetBounds(this->Bounds.data());
  }

  bool isWithin(const Eigen::Vector3d& place, std::size_t side) const
  {
    const double away = std::abs(place[static_cast<Eigen::Index>(side / 2)] - this->Bounds[side]);
    return away < this->Faces[side].depth;
  }
  double outwardPart(const Eigen::Vector3d& normal, std::size_t side) const
  {
    return normal[static_cast<Eigen::Index>(side / 2)] * (side % 2 == 0 ? -1.0 : 1.0);
  }

private:
  const HeldFaces& Faces;
  std::array<double, 6> Bounds{};
};
} // namespace

std::string takeClosedSurface(vtkPolyData* body, ClosedSurface& closed)
{
  const SoundBody sound(body);
  if (!sound.fault().empty())
  {
    return "Wrong input: " + sound.fault();
  }
  closed.surface = mergePoints(sound.body());
  const BodyMesh mesh = makeBodyMesh(closed.surface);
  closed.volume = mesh.enclosedVolume();
  closed.isOpen = !mesh.isClosed();
  if (closed.isOpen || closed.volume <= 0.0)
  {
    return joined("Wrong input: the surface ", closed.isOpen ? "is not closed" : "is inside out",
      ": it cannot be filled");
  }
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(mesh.triangleCount()); ++t)
  {
    const TriangleCorners& corners = mesh.corners(t);
    const Vector3 from = mesh.point(corners[0]);
    const Vector3 side = mesh.point(corners[1]) - from;
    closed.area += 0.5 * side.cross(mesh.point(corners[2]) - from).norm();
  }
  return {};
}

std::string readHeldFaces(const std::string& text, double usual, HeldFaces& faces)
{
  std::string words = text;
  std::replace(words.begin(), words.end(), ',', ' ');
  std::istringstream stream(words);
  faces.fill({});
  std::string word;
  while (stream >> word)
  {
    const std::string side = word.substr(0, word.find(':'));
    const std::size_t axis = side.size() == 2 ? std::string("xyz").find(side[0]) : 3;
    if (axis > 2 || (side[1] != '-' && side[1] != '+'))
    {
      return "Fixed Faces must name sides among x-, x+, y-, y+, z- and z+, but names '" + side +
        "'";
    }
    HeldFace held{ usual, side.size() < word.size() };
    if (held.isGiven)
    {
      std::istringstream number(word.substr(side.size() + 1));
      if (!(number >> held.depth) || !number.eof() || !(held.depth > 0.0) ||
        !std::isfinite(held.depth))
      {
        return "Fixed Faces: the depth of a side must be positive (mm), as in 'z-:5', but is '" +
          word + "'";
      }
    }
    faces[2 * axis + (side[1] == '+' ? 1 : 0)] = held;
  }
  return {};
}

vtkSmartPointer<vtkUnsignedCharArray> holdFaces(vtkUnstructuredGrid* body, const HeldFaces& faces)
{
  const auto fixed = vtkSmartPointer<vtkUnsignedCharArray>::New();
  fixed->SetName("Fixed");
  fixed->SetNumberOfTuples(body->GetNumberOfPoints());
  fixed->Fill(0);
  const SidesOfBox sides(body, faces);
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    const Eigen::Vector3d at = placeOf(body, i);
    for (std::size_t side = 0; side < faces.size(); ++side)
    {
      if (faces[side].isGiven && sides.isWithin(at, side))
      {
        fixed->SetValue(i, 7);
      }
    }
  }
  VolumeMesh mesh;
  MeshTopology topology;
  if (!convertVolume(body, mesh).empty() || !topology.build(mesh).empty())
  {
    return fixed; // the solver of the body reports the error
  }
  const BodySurface surface(mesh, topology);
  for (std::int32_t t = 0; t < surface.triangleTotal(); ++t)
  {
    const std::array<std::int32_t, 3>& corners = surface.triangle(t);
    for (std::size_t side = 0; side < faces.size(); ++side)
    {
      const bool isFace = std::all_of(corners.begin(), corners.end(),
        [&](std::int32_t corner) { return sides.isWithin(surface.position(corner), side); });
      if (faces[side].isGiven || !isFace ||
        !(sides.outwardPart(surface.triangleNormal(t), side) > LeastCosine))
      {
        continue;
      }
      for (const std::int32_t corner : corners)
      {
        fixed->SetValue(surface.node(corner), 7);
      }
    }
  }
  return fixed;
}
} // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/ClosedSurface.h"

#include "Mechanics/JoinedText.h"
#include "Response/Bodies/SoundBody.h"
#include "Response/BodyConversion.h"

#include "vtkCleanPolyData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace palpate
{
namespace
{
/// Merges points at the same place; without arrays.
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
      return "FixedFaces knows x-, x+, y-, y+, z- and z+, but not '" + side + "'";
    }
    HeldFace held{ usual, side.size() < word.size() };
    if (held.isGiven)
    {
      std::istringstream number(word.substr(side.size() + 1));
      if (!(number >> held.depth) || !number.eof() || !(held.depth > 0.0) ||
        !std::isfinite(held.depth))
      {
        return "FixedFaces: how deep a side holds must be positive (mm), as in 'z-:5', but is '" +
          word + "'";
      }
    }
    faces[2 * axis + (side[1] == '+' ? 1 : 0)] = held;
  }
  return {};
}

vtkSmartPointer<vtkUnsignedCharArray> holdFaces(
  const Eigen::Matrix3Xd& nodes, const HeldFaces& faces)
{
  const auto fixed = vtkSmartPointer<vtkUnsignedCharArray>::New();
  fixed->SetName("Fixed");
  fixed->SetNumberOfTuples(nodes.cols());
  const Eigen::Vector3d lowest = nodes.rowwise().minCoeff();
  const Eigen::Vector3d highest = nodes.rowwise().maxCoeff();
  for (Eigen::Index i = 0; i < nodes.cols(); ++i)
  {
    bool held = false;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto a = static_cast<Eigen::Index>(axis);
      held = held || nodes(a, i) < lowest[a] + faces[2 * axis].depth ||
        nodes(a, i) > highest[a] - faces[2 * axis + 1].depth;
    }
    fixed->SetValue(i, held ? 7 : 0);
  }
  return fixed;
}
} // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Touch/TouchedBody.h"

#include "Response/BodyConversion.h"
#include "Response/Curves/StoredError.h"
#include "Contact/ResponseContract.h"

#include "vtkCellArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace palpate
{
namespace
{
constexpr int Corners = 3;

vtkIdType firstTriangle(vtkPolyData* body)
{
  return body->GetNumberOfVerts() + body->GetNumberOfLines();
}

std::array<vtkIdType, Corners> cornersOf(vtkPolyData* body, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  body->GetPolys()->GetCellAtId(cell - firstTriangle(body), ids);
  return { ids->GetId(0), ids->GetId(1), ids->GetId(2) };
}
} // namespace

TouchedBody::TouchedBody() = default;
TouchedBody::~TouchedBody() = default;

bool TouchedBody::take(vtkPolyData* body, const std::string& name, std::string& error)
{
  this->Body = nullptr;
  this->Locator = nullptr;
  error = checkTriangles(body);
  if (!error.empty())
  {
    return false;
  }
  if (!viewResponse(body, name, this->Response, error))
  {
    const std::string others = listResponses(body);
    error = "no response '" + name + "' on the body: " + error +
      (others.empty() ? "; apply Tool Contact Response first" : "; the body has " + others);
    return false;
  }
  this->Body = body;
  this->Name = name;
  return true;
}

/// Builds the locator on first use. Returns false for a body without triangles.
bool TouchedBody::locate()
{
  if (!this->Locator)
  {
    this->Triangles = vtkSmartPointer<vtkPolyData>::New();
    this->Triangles->SetPoints(this->Body->GetPoints());
    this->Triangles->SetPolys(this->Body->GetPolys());
    this->Locator = vtkSmartPointer<vtkStaticCellLocator>::New();
    this->Locator->SetDataSet(this->Triangles);
    this->Locator->BuildLocator();
  }
  return this->Triangles->GetNumberOfPolys() > 0;
}

TouchedPlace TouchedBody::nearest(const Vector3& tip)
{
  TouchedPlace place;
  if (!this->locate())
  {
    return place;
  }
  Vector3 point;
  vtkIdType triangle = -1;
  int inside = 0;
  double squared = 0.0;
  this->Locator->FindClosestPoint(tip.data(), point.data(), triangle, inside, squared);
  if (triangle < 0)
  {
    return place;
  }
  place = this->placeIn(triangle + firstTriangle(this->Body), point);
  place.distance = std::sqrt(squared);
  return place;
}

TouchedPlace TouchedBody::hit(const Vector3& from, const Vector3& to)
{
  TouchedPlace place;
  if (!this->locate())
  {
    return place;
  }
  // With this tolerance, a line that meets an edge intersects one of the triangles at the edge.
  const double tolerance = 1e-6 * this->Body->GetLength();
  double share = 0.0;
  Vector3 point;
  Vector3 coordinates;
  int part = 0;
  vtkIdType triangle = -1;
  vtkNew<vtkGenericCell> cell;
  const int found = this->Locator->IntersectWithLine(from.data(), to.data(), tolerance, share,
    point.data(), coordinates.data(), part, triangle, cell);
  return found != 0 && triangle >= 0 ? this->placeIn(triangle + firstTriangle(this->Body), point)
                                     : place;
}

Vector3 TouchedBody::normal(const TouchedPlace& place) const
{
  const auto ids = cornersOf(this->Body, place.cell);
  std::array<Vector3, Corners> x;
  Vector3 outward = Vector3::Zero();
  for (std::size_t k = 0; k < x.size(); ++k)
  {
    this->Body->GetPoint(ids[k], x[k].data());
    const float* stored = this->Response.normal + 3 * ids[k];
    outward += Vector3(stored[0], stored[1], stored[2]);
  }
  const Vector3 normal = (x[1] - x[0]).cross(x[2] - x[0]).normalized();
  return normal.dot(outward) < 0.0 ? Vector3(-normal) : normal;
}

bool TouchedBody::isValid(const TouchedPlace& place) const
{
  const auto ids = cornersOf(this->Body, place.cell);
  return std::all_of(ids.begin(), ids.end(),
    [this](vtkIdType id) { return this->Response.isUsable(static_cast<std::size_t>(id)); });
}

const double* TouchedBody::bounds() const
{
  return this->Body->GetBounds();
}

TouchedPlace TouchedBody::placeIn(vtkIdType cell, const Vector3& point) const
{
  TouchedPlace place;
  place.cell = cell;
  place.point = point;
  const auto ids = cornersOf(this->Body, cell);
  std::array<Vector3, Corners> x;
  for (std::size_t k = 0; k < x.size(); ++k)
  {
    this->Body->GetPoint(ids[k], x[k].data());
  }
  place.weights = projectOnTriangle(point, x[0], x[1], x[2]).weights;
  return place;
}

double TouchedBody::range(const TouchedPlace& place) const
{
  const auto ids = cornersOf(this->Body, place.cell);
  double range = 0.0;
  for (int k = 0; k < Corners; ++k)
  {
    const double there = this->Response.range[ids[static_cast<std::size_t>(k)]];
    range += place.weights[k] * there;
  }
  return std::isfinite(range) ? range : 0.0;
}

double TouchedBody::stiffness(const TouchedPlace& place, double depth) const
{
  // The kernel evaluates a copy of the response that has only the three corners of the triangle.
  const auto ids = cornersOf(this->Body, place.cell);
  const auto samples = static_cast<std::size_t>(this->Response.samples);
  const auto laws = static_cast<std::size_t>(this->Response.laws);
  ResponseArrays three = this->Response;
  three.points = Corners;
  std::vector<float> force;
  std::vector<float> slope;
  std::vector<float> coefficient;
  std::vector<float> normal;
  std::array<float, Corners> range{};
  std::array<std::uint8_t, Corners> status{};
  const auto copy =
    [](const float* from, std::size_t point, std::size_t size, std::vector<float>& to)
  {
    if (from)
    {
      to.insert(to.end(), from + point * size, from + (point + 1) * size);
    }
  };
  for (std::size_t k = 0; k < ids.size(); ++k)
  {
    const auto point = static_cast<std::size_t>(ids[k]);
    copy(this->Response.force, point, samples, force);
    copy(this->Response.stiffness, point, samples, slope);
    copy(this->Response.coefficient, point, laws, coefficient);
    copy(this->Response.normal, point, 3, normal);
    range[k] = this->Response.range[point];
    status[k] = this->Response.status[point];
  }
  three.force = this->Response.force ? force.data() : nullptr;
  three.stiffness = this->Response.stiffness ? slope.data() : nullptr;
  three.coefficient = this->Response.coefficient ? coefficient.data() : nullptr;
  three.normal = normal.data();
  three.range = range.data();
  three.status = status.data();
  const ResponseField field(three);
  double stiffness = 0.0;
  for (int k = 0; k < Corners; ++k)
  {
    stiffness += place.weights[k] * field.evaluate(k, depth).stiffness;
  }
  return stiffness;
}

PlaceValidity TouchedBody::validity(const TouchedPlace& place, double depth) const
{
  PlaceValidity weakest;
  const float* validity = nullptr;
  const unsigned char* limit = nullptr;
  std::string missing;
  if (!viewValidity(this->Body, this->Name, validity, limit, missing))
  {
    return weakest;
  }
  weakest.known = true;
  weakest.depth = std::numeric_limits<double>::infinity();
  weakest.error = StoredError(this->Body, this->Name).at(place.cell, place.point.data(), depth);
  for (const vtkIdType id : cornersOf(this->Body, place.cell))
  {
    const double trusted = validity[id];
    if (trusted < weakest.depth)
    {
      weakest.depth = trusted;
      weakest.limit = limitInWords(limit[id]);
    }
  }
  return weakest;
}

double TouchedBody::typicalForce() const
{
  const ResponseField field(this->Response);
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < field.pointCount(); ++i)
  {
    const auto point = static_cast<std::int32_t>(i);
    const double force =
      field.isValid(point) ? field.evaluate(point, 0.5 * field.range(point)).force : 0.0;
    if (force > 0.0 && std::isfinite(force))
    {
      sum += force;
      ++count;
    }
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

std::string listResponses(vtkPolyData* body)
{
  vtkPointData* data = body->GetPointData();
  std::string list;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    const std::string name = data->GetArrayName(i) ? data->GetArrayName(i) : "";
    for (const ResponseArray curves : { ResponseArray::Force, ResponseArray::Coefficient })
    {
      const std::string suffix = contractOf(curves).suffix;
      if (name.size() <= suffix.size() ||
        name.compare(name.size() - suffix.size(), suffix.size(), suffix) != 0)
      {
        continue;
      }
      const std::string prefix = name.substr(0, name.size() - suffix.size());
      if (data->HasArray(arrayName(prefix, ResponseArray::Range).c_str()))
      {
        list += (list.empty() ? "'" : ", '") + prefix + "'";
      }
    }
  }
  return list;
}
} // namespace palpate

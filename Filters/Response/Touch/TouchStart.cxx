// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Touch/TouchStart.h"

#include "Response/ResponseTool.h"
#include "Response/Touch/TouchedBody.h"
#include "vtkContactTool.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace palpate
{
namespace
{
constexpr int PlacesPerSide = 25; // an odd number, so that one place is in the middle
constexpr int NeighbourCount = 8;
constexpr double NeighbourDistance = 2.0; // distance of the surrounding places, in contact radii
// Best direction of the normal, as the ratio of its upward component to its component towards the
// viewer.
constexpr double BestLean = 0.8;
// Cosine of the angle between the normal and the line of sight. If the cosine is smaller, the place
// is rated lower, because it is hard to see.
constexpr double ClearCosine = 0.5;
/// Exponent of the factor of flatness. With this exponent, a disagreement of the normals of 10 %
/// lowers the rating as much as a position in a corner of the picture.
constexpr int FlatnessExponent = 8;
/// Smallest factor of validity, > 0. If no place is within validity, the other factors determine
/// the rating.
constexpr double SmallestValidity = 1e-3;

struct Rectangle
{
  double low[2] = { HUGE_VAL, HUGE_VAL };
  double high[2] = { -HUGE_VAL, -HUGE_VAL };

  bool isEmpty() const { return !(this->low[0] < this->high[0] && this->low[1] < this->high[1]); }
  double at(int axis, double share) const // returns the position at `share`, from -1 to 1
  {
    return 0.5 *
      (this->low[axis] + this->high[axis] + share * (this->high[axis] - this->low[axis]));
  }
};

Vector3 rightOf(const Vector3& up, const Vector3& towards)
{
  const Vector3 right = up.cross(towards);
  return right.norm() > 1e-6 * up.norm() ? Vector3(right.normalized()) : towards.unitOrthogonal();
}

/// The picture of a body, and the lines of sight through it. The units of positions in the picture
/// are those of halfWidth and halfHeight of `Sight`.
class Picture
{
public:
  Picture(const Sight& sight, const std::array<Vector3, 8>& corners)
    : View(sight)
    , Towards(sight.towards.normalized())
    , Right(rightOf(sight.up, Towards))
    , Up(Towards.cross(Right))
  {
    const bool isCut = sight.halfWidth > 0.0 && sight.halfHeight > 0.0;
    const double half[2] = { sight.halfWidth, sight.halfHeight };
    bool isWithin = false; // whether a corner of the body's box is behind the eye
    for (const Vector3& corner : corners)
    {
      const Vector3 off = corner - sight.eye;
      const double depth = -off.dot(this->Towards);
      this->Nearest = std::min(this->Nearest, depth);
      this->Farthest = std::max(this->Farthest, depth);
      isWithin = isWithin || (sight.isNear && depth <= 0.0);
      const double scale = sight.isNear ? depth : 1.0;
      const double place[2] = { off.dot(this->Right) / scale, off.dot(this->Up) / scale };
      for (int axis = 0; axis < 2; ++axis)
      {
        this->Body.low[axis] = std::min(this->Body.low[axis], place[axis]);
        this->Body.high[axis] = std::max(this->Body.high[axis], place[axis]);
      }
    }
    for (int axis = 0; axis < 2 && isCut; ++axis)
    {
      this->Body.low[axis] = isWithin ? -half[axis] : std::max(this->Body.low[axis], -half[axis]);
      this->Body.high[axis] = isWithin ? half[axis] : std::min(this->Body.high[axis], half[axis]);
    }
    const double margin = 0.1 * (corners.back() - corners.front()).norm();
    this->Nearest -= margin;
    this->Farthest += margin;
    this->Nearest = sight.isNear ? std::max(this->Nearest, 1e-6 * this->Farthest) : this->Nearest;
  }

  /// Returns the rectangle of the picture that contains the visible part of the body.
  const Rectangle& visiblePart() const { return this->Body; }
  bool isEmpty() const
  {
    return this->Body.isEmpty() || (this->View.isNear && !(this->Farthest > this->Nearest));
  }

  /// Returns the visible place at a position in the picture.
  TouchedPlace findVisible(TouchedBody& body, double x, double y) const
  {
    const Vector3 aside = x * this->Right + y * this->Up;
    const auto point = [&](double depth) -> Vector3
    { return this->View.eye - depth * this->Towards + (this->View.isNear ? depth : 1.0) * aside; };
    return body.hit(point(this->Nearest), point(this->Farthest));
  }
  /// Returns the visible place along the line of sight through a point.
  TouchedPlace findTowards(TouchedBody& body, const Vector3& point) const
  {
    const Vector3 off = point - this->View.eye;
    const double scale = this->View.isNear ? -off.dot(this->Towards) : 1.0;
    return this->findVisible(body, off.dot(this->Right) / scale, off.dot(this->Up) / scale);
  }
  Vector3 towards(const Vector3& point) const
  {
    return this->View.isNear ? Vector3((this->View.eye - point).normalized()) : this->Towards;
  }
  const Vector3& up() const { return this->Up; }

private:
  const Sight View;
  const Vector3 Towards;
  const Vector3 Right;
  const Vector3 Up;
  Rectangle Body;
  /// Smallest and largest distance of the body from the plane of the eye, mm.
  double Nearest = std::numeric_limits<double>::infinity();
  double Farthest = -std::numeric_limits<double>::infinity();
};

std::array<Vector3, 8> cornersOf(const double bounds[6])
{
  std::array<Vector3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    corners[i] = { bounds[i % 2], bounds[2 + (i / 2) % 2], bounds[4 + i / 4] };
  }
  return corners;
}

/// Returns the mean of the normals at a place and at the places around it. The length of the mean
/// is at most 1 and is a measure of flatness.
Vector3 meanNormalAt(
  TouchedBody& body, const Picture& picture, const TouchedPlace& place, double distance)
{
  const Vector3 normal = body.normal(place);
  const Vector3 first = normal.unitOrthogonal();
  const Vector3 second = normal.cross(first);
  Vector3 sum = normal;
  for (int i = 0; i < NeighbourCount; ++i)
  {
    const double angle = 2.0 * EIGEN_PI * i / NeighbourCount;
    const Vector3 neighbour =
      place.point + distance * (std::cos(angle) * first + std::sin(angle) * second);
    const TouchedPlace ground = picture.findTowards(body, neighbour);
    if (ground.cell >= 0 && std::abs((ground.point - place.point).dot(normal)) < distance)
    {
      sum += body.normal(ground);
    }
  }
  return sum / (NeighbourCount + 1);
}

/// Returns the rating of a place as the start of a touch; 0 means unsuitable.
double rate(
  TouchedBody& body, vtkContactTool* tool, const Picture& picture, const TouchedPlace& place)
{
  if (place.cell < 0 || !body.isValid(place))
  {
    return 0.0;
  }
  const double depth = 0.5 * body.range(place);
  const double radius = tool ? tool->GetContactRadius(depth) : 0.0;
  if (!(depth > 0.0 && radius >= 0.0 && std::isfinite(radius)))
  {
    return 0.0;
  }
  const Vector3 towards = picture.towards(place.point);
  if (!(body.normal(place).dot(towards) > 0.0))
  {
    return 0.0;
  }
  const Vector3 ground =
    meanNormalAt(body, picture, place, NeighbourDistance * std::max(radius, depth));
  const double flatness = std::pow(ground.norm(), FlatnessExponent);
  const Vector3 normal = ground.normalized();
  const double facing =
    std::max(0.0, normal.dot((towards + BestLean * picture.up()).normalized())) *
    std::clamp(normal.dot(towards) / ClearCosine, 0.0, 1.0);
  const PlaceValidity validity = body.validity(place, depth);
  const double within =
    validity.known ? std::clamp(validity.depth / depth, SmallestValidity, 1.0) : 1.0;
  return flatness * facing * within;
}

/// Returns positions in the picture, sorted from the middle outward. Each coordinate is from -1 to
/// 1.
std::vector<Eigen::Vector2d> placesOfPicture()
{
  std::vector<Eigen::Vector2d> places;
  const auto share = [](int i) { return (2.0 * i + 1.0) / PlacesPerSide - 1.0; };
  for (int i = 0; i < PlacesPerSide; ++i)
  {
    for (int j = 0; j < PlacesPerSide; ++j)
    {
      places.emplace_back(share(i), share(j));
    }
  }
  std::stable_sort(places.begin(), places.end(),
    [](const Eigen::Vector2d& one, const Eigen::Vector2d& other)
    { return one.squaredNorm() < other.squaredNorm(); });
  return places;
}

/// Returns the visible place with the best rating. The cell of the place is -1 if there is no
/// suitable place.
TouchedPlace search(TouchedBody& body, vtkContactTool* tool, const Sight& sight)
{
  const Picture picture(sight, cornersOf(body.bounds()));
  TouchedPlace best;
  double most = 0.0;
  for (const Eigen::Vector2d& share : placesOfPicture())
  {
    const double middle = 1.0 - 0.25 * share.squaredNorm();
    if (picture.isEmpty() || middle <= most)
    {
      break; // later places cannot be better, because no factor exceeds 1
    }
    const TouchedPlace place = picture.findVisible(
      body, picture.visiblePart().at(0, share.x()), picture.visiblePart().at(1, share.y()));
    const double merit = middle * rate(body, tool, picture, place);
    if (merit > most)
    {
      most = merit;
      best = place;
    }
  }
  return best;
}
} // namespace

TouchedPlace findTouchStart(TouchedBody& body, vtkContactTool* tool, const Sight& sight)
{
  TouchedPlace place = search(body, tool, sight);
  const std::array<Vector3, 7> sides = { sight.towards, Vector3::UnitZ(), Vector3::UnitX(),
    Vector3::UnitY(), -Vector3::UnitZ(), -Vector3::UnitX(), -Vector3::UnitY() };
  for (std::size_t i = 0; i < sides.size() && place.cell < 0; ++i)
  {
    Sight whole;
    whole.towards = sides[i];
    whole.up = sight.up;
    place = search(body, tool, whole);
  }
  return place;
}

TouchedPlace findTouchStart(vtkPolyData* body, const std::string& name, const Sight& sight)
{
  TouchedBody touched;
  std::string fault;
  if (!body || body->GetNumberOfPolys() == 0 || !touched.take(body, name, fault))
  {
    return {};
  }
  const auto tool = findTool(nullptr, body, name, fault);
  return findTouchStart(touched, tool, sight);
}
} // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
// Embree's point query over its tree of boxes. The query finds the triangles within a radius; the
// caller computes their distance. The radius is the distance from the tip to the previous result,
// which is a point on the body.
#include "TimedMethod.h"

#ifdef PALPATE_WITH_EMBREE
#include "Contact/TriangleProjection.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace palpate::benchmarks
{
namespace
{
/// Relative increase of the radius, because Embree's query uses floats. For a tip 100 mm from the
/// origin and about 1 mm deep the error is 1e-5.
constexpr double RoundUp = 2e-5;

class EmbreePoint
{
public:
  explicit EmbreePoint(const testing::Surface& surface)
    : Device(rtcNewDevice(nullptr))
    , Scene(rtcNewScene(this->Device))
  {
    const RTCGeometry geometry = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* const points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry,
      RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), surface.points.size()));
    auto* const triangles = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry,
      RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), surface.triangles.size()));
    if (points == nullptr || triangles == nullptr)
    {
      throw std::runtime_error("Embree has no memory for the body");
    }
    std::transform(surface.points.front().data(),
      surface.points.front().data() + 3 * surface.points.size(), points,
      [](double x) { return static_cast<float>(x); });
    std::copy_n(surface.triangles.front().data(), 3 * surface.triangles.size(), triangles);
    this->Points = points;
    this->Triangles = triangles;
    rtcSetGeometryPointQueryFunction(geometry, &EmbreePoint::consider);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(this->Scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(this->Scene);
  }
  ~EmbreePoint()
  {
    rtcReleaseScene(this->Scene);
    rtcReleaseDevice(this->Device);
  }
  EmbreePoint(const EmbreePoint&) = delete;
  EmbreePoint& operator=(const EmbreePoint&) = delete;

  Vector3 prepare(const Vector3* tips) { return *tips; }
  double operator()(const Vector3& tip)
  {
    const double bound = this->Known ? (tip - this->Last).norm() * (1.0 + RoundUp)
                                     : std::numeric_limits<double>::infinity();
    RTCPointQuery query;
    query.x = static_cast<float>(tip.x());
    query.y = static_cast<float>(tip.y());
    query.z = static_cast<float>(tip.z());
    query.time = 0.0F;
    query.radius = static_cast<float>(bound);
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    Search search{ this, tip, this->Last, std::numeric_limits<double>::infinity() };
    rtcPointQuery(this->Scene, &query, &context, nullptr, &search);
    this->Known = search.squaredDistance < std::numeric_limits<double>::infinity();
    this->Last = search.point;
    return search.squaredDistance;
  }
  double distance(const Vector3* /*tips*/, double squaredDistance) const
  {
    return std::sqrt(squaredDistance);
  }
  void reset() { this->Known = false; }

private:
  struct Search
  {
    const EmbreePoint* body;
    Vector3 tip;
    Vector3 point;
    double squaredDistance;
  };

  /// Checks a triangle within the radius. Returns true if the radius was reduced.
  static bool consider(RTCPointQueryFunctionArguments* arguments)
  {
    Search& search = *static_cast<Search*>(arguments->userPtr);
    const unsigned* const corners =
      search.body->Triangles + 3 * static_cast<std::size_t>(arguments->primID);
    const TriangleProjection projection =
      projectOnTriangle(search.tip, search.body->point(corners[0]), search.body->point(corners[1]),
        search.body->point(corners[2]));
    if (!(projection.squaredDistance < search.squaredDistance))
    {
      return false;
    }
    search.squaredDistance = projection.squaredDistance;
    search.point = projection.point;
    const double radius = std::sqrt(projection.squaredDistance) * (1.0 + RoundUp);
    const bool smaller = radius < static_cast<double>(arguments->query->radius);
    if (smaller)
    {
      arguments->query->radius = static_cast<float>(radius);
    }
    return smaller;
  }

  Vector3 point(unsigned id) const
  {
    return Eigen::Map<const Eigen::Vector3f>(this->Points + 3 * static_cast<std::size_t>(id))
      .cast<double>();
  }

  RTCDevice Device;
  RTCScene Scene;
  const float* Points = nullptr;
  const unsigned* Triangles = nullptr;
  Vector3 Last = Vector3::Zero();
  bool Known = false;
};
} // namespace

std::unique_ptr<TimedMethod> makeEmbreePoint(const testing::Surface& surface)
{
  return timed<EmbreePoint>(surface);
}
} // namespace palpate::benchmarks

#else
namespace palpate::benchmarks
{
std::unique_ptr<TimedMethod> makeEmbreePoint(const testing::Surface& /*surface*/)
{
  return nullptr;
}
} // namespace palpate::benchmarks
#endif

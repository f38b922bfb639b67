// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/SurfaceMotion.h"

#include "Solids/FiniteElements/VisibleDent.h"
#include "Mechanics/ReducedModulus.h"
#include "Mechanics/SharedWork.h"
#include "Solids/TrueShape/SubtractedLoad.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
/// Smallest number of surrounding sources for a quadratic fit and for a linear fit.
constexpr std::size_t LeastForBend = 5;
constexpr std::size_t LeastForSlope = 2;

/// Fraction of the progress, as reported to the observer, that the modes take.
constexpr double ModesShare = 0.8;

/// Returns the motion of the surface under an inward force of 1 N at a source, without the visible
/// dent.
Eigen::Matrix3Xd motionLessDent(
  const RegularGreen& green, const SingularSource& source, const Eigen::VectorXd& smooth)
{
  const ElasticBody& body = green.body();
  const BodySurface& surface = body.surface();
  const BoussinesqField singular(source.material);
  const std::vector<double> fades = dentFades(surface, source.point);
  Eigen::Matrix3Xd field = Eigen::Matrix3Xd::Zero(3, surface.pointTotal());
  for (std::int32_t i = 0; i < surface.pointTotal(); ++i)
  {
    const Eigen::Vector3d at = source.inFrame(surface.position(i));
    const bool isItself = i == source.point;
    Eigen::Vector3d moved = Eigen::Vector3d::Zero();
    if (!isItself && SingularSource::isUnder(at))
    {
      moved = source.frame * singular.displacement(at);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const int unknown = body.unknown(surface.node(i), axis);
      moved[axis] = unknown >= 0 ? moved[axis] + smooth[unknown] : 0.0;
    }
    const double fade = fades[static_cast<std::size_t>(i)];
    if (!isItself && fade > 0.0)
    {
      moved -= fade / source.material.youngsModulus *
        dentAt(surface, source.point, i, 0.0, source.material.poissonRatio);
    }
    field.col(i) = moved;
  }
  // u_B is infinite at the source. The known H at the source is used instead.
  const Eigen::Vector3d& normal = surface.normal(source.point);
  const double depth = green.at(source.point, source.point);
  auto itself = field.col(source.point);
  itself -= (itself.dot(normal) + depth) * normal;
  return field;
}

/// Returns H(x, X) without the part that the modes represent, mm/N.
double residualOfModes(
  const RegularGreen& green, const GlobalModes& modes, std::int32_t x, std::int32_t source)
{
  const BodySurface& surface = green.body().surface();
  double left = green.at(x, source);
  for (std::size_t k = 0; k < modes.fields.size(); ++k)
  {
    const Eigen::Matrix3Xd& field = modes.fields[k];
    left -= modes.signs[k] * surface.normal(x).dot(field.col(x)) *
      surface.normal(source).dot(field.col(source));
  }
  return left;
}

NearField nearFieldAt(const RegularGreen& green, const GlobalModes& modes, std::int32_t source)
{
  const SurfaceDisc& disc = *green.disc(source);
  NearField near;
  const SingularSource frame(green.body(), source);
  near.reducedModulus = reducedModulus(frame.material.youngsModulus, frame.material.poissonRatio);
  near.depth = residualOfModes(green, modes, source, source);
  std::vector<const DiscPoint*> known;
  for (const DiscPoint& at : disc.points)
  {
    if (at.distance > 0.0 && std::isfinite(green.at(at.point, source)))
    {
      known.push_back(&at);
      near.radius = std::max(near.radius, at.distance);
    }
  }
  if (known.size() < LeastForSlope)
  {
    near.radius = std::max(near.radius, green.radius());
    return near;
  }
  const Eigen::Index terms = known.size() < LeastForBend ? 2 : 5;
  Eigen::MatrixXd system(static_cast<Eigen::Index>(known.size()), terms);
  Eigen::VectorXd left(system.rows());
  for (Eigen::Index i = 0; i < system.rows(); ++i)
  {
    const DiscPoint& at = *known[static_cast<std::size_t>(i)];
    const Eigen::Vector2d d = at.at / near.radius;
    system.row(i).head<2>() = d.transpose();
    if (terms == 5)
    {
      system.row(i).tail<3>() << d[0] * d[0], 2.0 * d[0] * d[1], d[1] * d[1];
    }
    left[i] = residualOfModes(green, modes, at.point, source) - near.depth;
  }
  const Eigen::VectorXd found = system.completeOrthogonalDecomposition().solve(left);
  const Eigen::Matrix<double, 3, 2> tangents = frame.frame.leftCols<2>();
  near.slope = tangents * found.head<2>() / near.radius;
  if (terms == 5)
  {
    Eigen::Matrix2d bend;
    bend << found[2], found[3], found[3], found[4];
    near.bend = tangents * bend * tangents.transpose() / (near.radius * near.radius);
  }
  return near;
}
} // namespace

SurfaceMotion surfaceMotion(const RegularGreen& green, int modes, const WorkObserver& observer)
{
  const ElasticBody& body = green.body();
  const std::vector<std::int32_t> points = green.pressedSources();
  SurfaceMotion motion;
  if (points.empty())
  {
    return motion;
  }
  const auto size = [&green](std::int32_t i) { return std::abs(green.at(i, i)); };
  const std::int32_t first = *std::max_element(points.begin(), points.end(),
    [&](std::int32_t a, std::int32_t b) { return size(a) < size(b); });
  const std::vector<std::int32_t> landmarks = spreadPoints(body.surface(), points, first,
    static_cast<std::size_t>(std::clamp(modes, 0, MostGlobalModes)) * LandmarksPerMode);
  const SubtractedLoad loads(body);
  std::vector<Eigen::Matrix3Xd> pulled(landmarks.size());
  const auto pull = [&](std::size_t j)
  {
    const SingularSource source(body, landmarks[j]);
    const Eigen::VectorXd smooth = body.factor().solveAll(loads.load(source));
    pulled[j] = smooth.size() > 0 ? Eigen::Matrix3Xd(-motionLessDent(green, source, smooth))
                                  : Eigen::Matrix3Xd::Zero(3, body.surface().pointTotal());
  };
  const auto share = [&observer](double from, double to) -> WorkObserver
  { return [&observer, from, to](double done) { return observer(from + done * (to - from)); }; };
  if (!shareWork(landmarks.size(), pull, share(0.0, ModesShare)))
  {
    return motion;
  }
  motion.modes = modesOf(body, landmarks, pulled, modes);
  motion.near.resize(points.size());
  const auto fit = [&](std::size_t i)
  { motion.near[i] = nearFieldAt(green, motion.modes, points[i]); };
  if (shareWork(points.size(), fit, share(ModesShare, 1.0)))
  {
    motion.points = points;
  }
  return motion;
}
} // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/Edges/BodyEdges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
/// Blunt edges are seen up to so many depths away, and fade from half of that.
constexpr double BluntReach = 6.0;
/// Less than this part of the depth under the contact's own face; so that none goes to and fro.
constexpr double Nearer = 1.0 - 1e-6;

struct Fade
{
  double value = 0.0;
  double slope = 0.0;
};

/// 1 up to half of `end`, 0 from `end` on, without a kink.
Fade fade(double x, double end) noexcept
{
  const double t = std::clamp(2.0 * x / end - 1.0, 0.0, 1.0);
  return { 1.0 - t * t * (3.0 - 2.0 * t), -12.0 * t * (1.0 - t) / end };
}

/// Without its part along a unit normal.
Vector3 within(const Vector3& normal, const Vector3& vector) noexcept
{
  return vector - normal.dot(vector) * normal;
}

double blend(const std::array<double, 2>& ends, double part) noexcept
{
  return ends[0] + part * (ends[1] - ends[0]);
}

double contactRadius(const EdgeTerms& terms, double depth) noexcept
{
  return terms.exponent == 1.0 ? terms.radius
                               : terms.radius * std::pow(depth, terms.exponent - 1.0);
}

/// The depth under several planes: δ^-p = δ_A^-p + Σ w δ_k^-p.
class DepthOfFaces
{
public:
  DepthOfFaces(const Vector3& normal, double depth) noexcept
    : Own(normal)
    , OwnDepth(depth)
  {
  }

  void add(const EdgeChains::Segment& segment, const EdgeChains::Place& place,
    const Vector3& tip) noexcept
  {
    const Fade weight = fade(std::max(0.0, place.distance) / this->OwnDepth, BluntReach);
    const Vector3 normal =
      (segment.otherNormal[0] + place.part * (segment.otherNormal[1] - segment.otherNormal[0]))
        .normalized();
    const double depth = normal.dot(place.point - tip);
    if (weight.value == 0.0)
    {
      return;
    }
    Face& face = this->Faces[this->Count++];
    face = { normal, depth, weight, blend(segment.strength, place.part), place.distance,
      within(this->Own, place.gradient) };
    if (depth < this->Least)
    {
      this->Least = depth;
      this->Nearest = segment.across;
    }
  }

  void tell(EdgeEffect& effect) const noexcept
  {
    effect.depth = this->OwnDepth;
    if (this->Count == 0)
    {
      return;
    }
    if (!(this->Least > 0.0))
    {
      effect.depth = 0.0;
      return;
    }
    effect.nearerAcross = this->Least < Nearer * this->OwnDepth ? this->Nearest : -1;
    double weights = 0.0;
    double power = 0.0;
    for (std::size_t k = 0; k < this->Count; ++k)
    {
      weights += this->Faces[k].weight.value;
      power += this->Faces[k].weight.value * this->Faces[k].power;
    }
    power /= weights;
    std::array<double, EdgeChains::MostNear> ratio{};
    double sum = 1.0;
    for (std::size_t k = 0; k < this->Count; ++k)
    {
      ratio[k] = std::pow(this->OwnDepth / this->Faces[k].depth, power);
      sum += this->Faces[k].weight.value * ratio[k];
    }
    effect.depth = this->OwnDepth * std::pow(sum, -1.0 / power);
    effect.ownNormal = 1.0;
    for (std::size_t k = 0; k < this->Count; ++k)
    {
      const Face& face = this->Faces[k];
      const double part = face.weight.value * ratio[k] / sum;
      const double fading = ratio[k] * face.weight.slope / (power * sum);
      effect.ownNormal -= part;
      effect.ownNormal += fading * std::max(0.0, face.distance) / this->OwnDepth;
      effect.otherNormals += effect.depth / face.depth * part * face.normal;
      effect.otherNormals += effect.depth / this->OwnDepth * fading * face.distanceGradient;
    }
    effect.ownNormal *= effect.depth / this->OwnDepth;
  }

private:
  struct Face
  {
    Vector3 normal;
    double depth = 0.0;
    Fade weight;
    double power = 0.0;
    double distance = 0.0;
    Vector3 distanceGradient; ///< as the tip moves
  };

  Vector3 Own;
  double OwnDepth;
  std::size_t Count = 0;
  std::array<Face, EdgeChains::MostNear> Faces;
  double Least = std::numeric_limits<double>::infinity();
  std::int32_t Nearest = -1;
};
} // namespace

BodyEdges::BodyEdges(const PackedMesh& mesh, const EdgeTerms& terms, double range)
  : Terms(terms)
  , Law(terms)
  , Chains(mesh, terms.poissonRatio,
      { (terms.isInCurves ? 2.0 * this->Law.end() : Reach) * contactRadius(terms, range),
        BluntReach * range })
{
}

EdgeEffect BodyEdges::at(const Vector3& tip, std::int32_t triangle, const Vector3& normal,
  double depth) const noexcept
{
  EdgeEffect effect;
  effect.depth = depth;
  const EdgeChains::Near* const near = this->Chains.near(triangle);
  if (!near || !(depth > 0.0))
  {
    return effect;
  }
  const Vector3 foot = tip + depth * normal;
  std::array<EdgeChains::Place, EdgeChains::MostNear> places;
  DepthOfFaces faces(normal, depth);
  for (std::size_t k = 0; k < places.size() && near->segments[k] != EdgeChains::None; ++k)
  {
    places[k] = this->Chains.closest(foot, near->segments[k]);
    if (places[k].segment != EdgeChains::None)
    {
      const EdgeChains::Segment& segment = this->Chains.segment(places[k].segment);
      // Of others, what is beyond a dent or a groove does not bound the body here.
      const bool bounds = segment.face == near->face ||
        (places[k].distance > 0.0 &&
          segment.otherNormal[0].dot(foot - places[k].point) <= 0.0);
      if (segment.isBlunt && bounds)
      {
        faces.add(segment, places[k], tip);
      }
    }
  }
  faces.tell(effect);
  for (std::size_t k = 0; k < places.size() && effect.depth > 0.0; ++k)
  {
    const std::int32_t at = places[k].segment;
    if (at != EdgeChains::None && !this->Chains.segment(at).isBlunt)
    {
      this->takeShare(places[k], normal, effect);
    }
  }
  return effect;
}

/// Multiplies what is left by what one edge leaves of it.
void BodyEdges::takeShare(
  const EdgeChains::Place& place, const Vector3& normal, EdgeEffect& effect) const noexcept
{
  const EdgeChains::Segment& segment = this->Chains.segment(place.segment);
  const double m = this->Terms.exponent;
  const double radius = contactRadius(this->Terms, effect.depth);
  const double u = place.distance / radius;
  const EdgeLaw::Value law = this->Law.at(u, blend(segment.strength, place.part));
  const Fade far = fade(std::max(0.0, place.distance), this->Chains.reach());
  const double one = -u * (m - 1.0) / effect.depth; // du/dδ
  const double two = u * (m - 1.0) * m / (effect.depth * effect.depth);
  const double share = 1.0 - (1.0 - law.share) * far.value;
  const double byDepth = far.value * law.slope * one;
  const double byDepthTwice = far.value * (law.bend * one * one + law.slope * two);
  const double byDistance = far.value * law.slope / radius - (1.0 - law.share) * far.slope;
  effect.byPlace = effect.byPlace * share +
    effect.share * byDistance * within(normal, place.gradient);
  effect.byDepthTwice = effect.byDepthTwice * share + 2.0 * effect.byDepth * byDepth +
    effect.share * byDepthTwice;
  effect.byDepth = effect.byDepth * share + effect.share * byDepth;
  effect.share *= share;
}
} // namespace palpate

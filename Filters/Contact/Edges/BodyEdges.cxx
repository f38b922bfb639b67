// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/Edges/BodyEdges.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
/// Faces across blunt edges are searched up to a distance of this multiple of the range of the
/// curves.
constexpr double BluntReach = 6.0;
/// Smallest share of a face in the sum of δ^-4. A face with a smaller share has no weight; from
/// twice this share on, it has full weight.
constexpr double LeastPart = 1e-3;
/// A tip above the plane of a face across a blunt edge is outside the body if the edge is at most
/// this many depths away (1/tan 20°). Planes of faces farther away are ignored.
constexpr double OutsideWithin = 2.75;
/// Another face counts as nearer only if its depth is below this fraction of the depth under the
/// contact's own face. This prevents the contact from alternating between two faces.
constexpr double Nearer = 1.0 - 1e-6;
constexpr std::size_t MostFaces = 8;
/// The softness of an edge decays with x = d/h, the distance from the edge divided by the depth at
/// which the body is fixed: e^-2.75x, and 0 for x >= 1.5. For x below 1/50 the function is rounded,
/// so that its slope is continuous at the edge.
constexpr double Holding = 2.75;
constexpr double ExtentsAway = 1.5;
constexpr double RoundedWithin = 0.02;

/// A quantity and its derivative.
struct Fade
{
  double value = 0.0;
  double slope = 0.0;
};

/// Returns 1 up to half of `end` and 0 beyond `end`, with a continuous slope in between.
Fade fade(double x, double end) noexcept
{
  const double t = std::clamp(2.0 * x / end - 1.0, 0.0, 1.0);
  return { 1.0 - t * t * (3.0 - 2.0 * t), -12.0 * t * (1.0 - t) / end };
}

/// Returns the vector without its component along a unit normal.
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

/// Distance from a triangle within which a sharp edge is considered, mm. It is at least the
/// distance by which a contact may extend beyond the edge.
double reachOf(const EdgeTerms& terms, double end, double largestRadius) noexcept
{
  const double least = 2.0 * end * largestRadius;
  const double endless = BodyEdges::Reach * largestRadius;
  const double usual = terms.extent > 0.0 ? std::min(endless, ExtentsAway * terms.extent) : endless;
  return terms.isInCurves ? least : std::max(least, usual);
}

/// Returns the weighted share of a face and its derivative with respect to r, where r is the
/// unweighted contribution of the face to the sum of δ^-4. The weighted share is 0 if r is
/// negligible.
Fade partOf(double r) noexcept
{
  const double t = std::clamp(r / LeastPart - 1.0, 0.0, 1.0);
  return { r * t * t * (3.0 - 2.0 * t),
    t * t * (3.0 - 2.0 * t) + r * 6.0 * t * (1.0 - t) / LeastPart };
}
} // namespace

BodyEdges::BodyEdges(const PackedMesh& mesh, const EdgeTerms& terms, double range)
  : Terms(terms)
  , Law(terms)
  , Chains(mesh, terms.poissonRatio,
      { reachOf(terms, this->Law.end(), contactRadius(terms, range)), BluntReach * range })
{
}

/// The faces near the blunt edges around a contact: the face of the contact, the faces across its
/// blunt edges, and the faces one edge farther away.
class BodyEdges::Faces
{
public:
  Faces(const BodyEdges& edges, const Vector3& tip, std::int32_t triangle, const Vector3& normal,
    double depth) noexcept
    : Edges(edges)
    , Tip(tip)
  {
    this->Known[0].triangle = triangle;
    this->Known[0].normal = normal;
    this->Known[0].depth = depth;
    this->Count = 1;
    for (std::size_t i = 0; i < this->Count && !this->IsOutside; ++i)
    {
      this->look(i);
    }
  }

  ContactReach reach() noexcept
  {
    ContactReach reach;
    reach.depth = this->IsOutside ? 0.0 : this->own().depth;
    if (this->Count > 1 && !this->IsOutside)
    {
      this->join(reach);
    }
    if (reach.depth > 0.0)
    {
      this->addShares(reach);
    }
    return reach;
  }

private:
  struct Face
  {
    std::int32_t triangle = EdgeChains::None;
    std::int32_t number = EdgeChains::None; ///< index of the face; None if it is unknown
    Vector3 normal = Vector3::Zero();
    double depth = 0.0;
    /// The weight is 1 for a neighbour of the contact's own face. For a face beyond a neighbour,
    /// the weight rises from 0 to the weight of that neighbour as the depth under the neighbour
    /// approaches the depth under the contact's own face.
    double weight = 1.0;
    Vector3 weightChange = Vector3::Zero(); ///< gradient with respect to the tip's position
    double part = 1.0;                      ///< share of the face in the sum of δ^-4
    Vector3 partChange = Vector3::Zero();
  };

  const Face& own() const noexcept { return this->Known[0]; }
  /// Returns (δ_own/δ)^4. ratioChange() is the gradient of this ratio with respect to the tip's
  /// position; -∇δ is the normal of the face.
  double ratio(const Face& face) const noexcept
  {
    const double x = this->own().depth / face.depth;
    return x * x * x * x;
  }
  Vector3 ratioChange(const Face& face, double ratio) const noexcept
  {
    return 4.0 * ratio * (face.normal / face.depth - this->own().normal / this->own().depth);
  }

  /// Finds the faces across the blunt edges of face i.
  void look(std::size_t i) noexcept
  {
    const EdgeChains& chains = this->Edges.Chains;
    const EdgeChains::Near* const near = chains.near(this->Known[i].triangle);
    const Vector3 foot = this->Tip + this->Known[i].depth * this->Known[i].normal;
    for (std::size_t k = 0; near && k < near->size() && (*near)[k] != EdgeChains::None; ++k)
    {
      const EdgeChains::Segment& first = chains.segment((*near)[k]);
      this->Known[i].number = first.face;
      if (!first.isBlunt || this->isKnown(first.other))
      {
        continue;
      }
      const EdgeChains::Place place = chains.closest(foot, (*near)[k]);
      const EdgeChains::Segment& segment = chains.segment(place.segment);
      const Vector3 toEdge = place.point - this->Tip;
      if (!(segment.normal.dot(toEdge) > 0.0))
      {
        continue; // the other face is on the far side of a groove
      }
      Face face;
      face.triangle = segment.across;
      face.number = segment.other;
      face.normal =
        (segment.otherNormal[0] + place.part * (segment.otherNormal[1] - segment.otherNormal[0]))
          .normalized();
      face.depth = face.normal.dot(toEdge);
      if (i > 0)
      {
        this->weigh(this->Known[i], face);
      }
      this->add(face, std::abs(place.distance) <= OutsideWithin * this->Known[i].depth);
    }
  }

  bool isKnown(std::int32_t number) const noexcept
  {
    bool is = false;
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      is = is || this->Known[i].number == number;
    }
    return is;
  }

  void weigh(const Face& between, Face& face) const noexcept
  {
    const double ratio = this->ratio(between);
    const double t = std::clamp((ratio - LeastPart) / (1.0 - LeastPart), 0.0, 1.0);
    const double part = t * t * (3.0 - 2.0 * t);
    const double slope = 6.0 * t * (1.0 - t) / (1.0 - LeastPart);
    face.weight = between.weight * part;
    face.weightChange =
      part * between.weightChange + between.weight * slope * this->ratioChange(between, ratio);
  }

  void add(const Face& face, bool isClose) noexcept
  {
    const bool counts = face.weight > 0.0;
    const bool isUnder = face.depth > 0.0;
    this->IsOutside = this->IsOutside || (counts && !isUnder && isClose);
    const bool isFelt = counts && isUnder && this->ratio(face) > LeastPart;
    if (isFelt && this->Count != MostFaces)
    {
      this->Known[this->Count++] = face;
    }
  }

  /// Combines the depths of all faces: δ^-4 = Σ w_k δ_k^-4.
  void join(ContactReach& reach) noexcept
  {
    double sum = 0.0;
    Vector3 sumChange = Vector3::Zero();
    double least = Nearer * this->own().depth;
    for (std::size_t k = 0; k < this->Count; ++k)
    {
      Face& face = this->Known[k];
      const double ratio = this->ratio(face);
      const Fade part = partOf(ratio);
      face.part = face.weight * part.value;
      face.partChange =
        part.value * face.weightChange + face.weight * part.slope * this->ratioChange(face, ratio);
      sum += face.part;
      sumChange += face.partChange;
      if (face.depth < least)
      {
        least = face.depth;
        reach.nearerAcross = face.triangle;
      }
    }
    reach.depth = this->own().depth / std::sqrt(std::sqrt(sum));
    // -∇δ = δ (n/δ_own + Σ ∇part / (4 Σ part)).
    const Vector3 outward =
      reach.depth * (this->own().normal / this->own().depth + 0.25 / sum * sumChange);
    for (std::size_t k = 0; k < this->Count; ++k)
    {
      Face& face = this->Known[k];
      face.part /= sum;
      face.partChange = (face.partChange - face.part * sumChange) / sum;
    }
    // The component along the contact's own normal is kept separate, because on a curved surface
    // the contact's normal differs from that of its face.
    reach.ownNormal = reach.depth / this->own().depth * this->own().part;
    reach.otherNormals = outward - reach.ownNormal * this->own().normal;
  }

  void addShares(ContactReach& reach) const noexcept
  {
    reach.share.value = 0.0;
    for (std::size_t k = 0; k < this->Count; ++k)
    {
      const Face& face = this->Known[k];
      if (face.part > 0.0)
      {
        Jet share = this->Edges.shareOf(
          face.triangle, this->Tip + face.depth * face.normal, face.normal, reach.depth);
        share *= { face.part, 0.0, 0.0, 0.0, face.partChange };
        reach.share += share;
      }
    }
  }

  const BodyEdges& Edges;
  Vector3 Tip;
  bool IsOutside = false;
  std::size_t Count = 0;
  std::array<Face, MostFaces> Known;
};

ContactReach BodyEdges::at(
  const Vector3& tip, std::int32_t triangle, const Vector3& normal, double depth) const noexcept
{
  if (!this->areNear(triangle) || !(depth > 0.0))
  {
    ContactReach reach;
    reach.depth = depth;
    return reach;
  }
  return Faces(*this, tip, triangle, normal, depth).reach();
}

void BodyEdges::reach(const PackedMesh& mesh, const Vector3& tip, Pressed& pressed) const noexcept
{
  ContactPlace& place = pressed.place();
  if (place.onCrease && !place.isSmooth)
  {
    place.normal = mesh.faceNormal(place.triangle);
  }
  const double height =
    place.normal.dot(place.projection.point - tip); // height of the plane of the face above the tip
  const Vector3 deepest = tip + pressed.sunk * place.normal;
  pressed.reach =
    this->at(mesh.toLocal(deepest), place.triangle, place.normal, height - pressed.sunk);
  if (place.onCrease)
  {
    place.projection.point = tip + height * place.normal;
  }
}

/// Remaining fraction of an edge's sharpness at a distance, and its derivative with respect to the
/// distance.
struct BodyEdges::Softness
{
  double part = 1.0;
  double slope = 0.0;
};

BodyEdges::Softness BodyEdges::softnessAt(double distance) const noexcept
{
  const double d = std::max(0.0, distance);
  const Fade far = fade(d, this->Chains.reach());
  const double extent = this->Terms.extent;
  if (!(extent > 0.0))
  {
    return { far.value, far.slope };
  }
  const double rounded = d + RoundedWithin * extent;
  const double held = std::exp(-Holding * d * d / (rounded * extent));
  const double bySlope =
    -Holding * d * (rounded + RoundedWithin * extent) / (rounded * rounded * extent);
  return { far.value * held, held * (far.slope + far.value * bySlope) };
}

Jet BodyEdges::shareOf(
  std::int32_t triangle, const Vector3& foot, const Vector3& normal, double depth) const noexcept
{
  Jet all;
  const double m = this->Terms.exponent;
  const double radius = contactRadius(this->Terms, depth);
  const EdgeChains::Near* const near = this->Chains.near(triangle);
  for (std::size_t k = 0; near && k < near->size() && (*near)[k] != EdgeChains::None; ++k)
  {
    if (this->Chains.segment((*near)[k]).isBlunt)
    {
      continue;
    }
    const EdgeChains::Place place = this->Chains.closest(foot, (*near)[k]);
    const EdgeChains::Segment& segment = this->Chains.segment(place.segment);
    const Softness softness = this->softnessAt(place.distance);
    const double u = place.distance / radius;
    const double sharpness = blend(segment.sharpness, place.part) * softness.part;
    const EdgeLaw::Value law = this->Law.at(u, sharpness);
    const double one = -u * (m - 1.0) / depth; // du/dδ
    const double two = u * (m - 1.0) * m / (depth * depth);
    // Ψ = 1/(1 + s k), where s is the sharpness. Therefore dΨ/ds = -Ψ (1 - Ψ)/s.
    const double bySharpness =
      softness.part > 0.0 ? -law.share * (1.0 - law.share) / softness.part : 0.0;
    const double byDistance = law.slope / radius + bySharpness * softness.slope;
    all *= { law.share, law.slope * one, law.bend * one * one + law.slope * two, 0.0,
      byDistance * within(normal, place.gradient) };
  }
  return all;
}
} // namespace palpate

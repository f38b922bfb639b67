// SPDX-License-Identifier: BSD-3-Clause
// A tip slides under a bumpy sphere. In every tick the contact is the nearest point of the
// triangles within two rings of the last contact, by enumeration in long double. A plain descent
// does not find this point.
#include "BruteForce.h"
#include "BumpySphere.h"
#include "Contact/ContactTracker.h"

#include <gtest/gtest.h>

#include <cmath>

namespace palpate::testing
{
namespace
{
constexpr std::size_t Ticks = 4000;

/// The triangles within two rings, as twoRings(), but without a search over all triangles of a
/// large surface.
class Rings
{
public:
  explicit Rings(const Surface& body)
    : Body(body)
    , Around(body.points.size())
    , Seen(body.triangles.size(), -1)
  {
    for (const std::int32_t t : allTriangles(body))
    {
      for (const std::int32_t corner : body.triangles[static_cast<std::size_t>(t)])
      {
        this->Around[static_cast<std::size_t>(corner)].push_back(t);
      }
    }
  }

  std::vector<std::int32_t> twoRings(std::int32_t triangle)
  {
    ++this->Stamp;
    std::vector<std::int32_t> ring{ triangle };
    this->Seen[static_cast<std::size_t>(triangle)] = this->Stamp;
    for (int pass = 0; pass < 2; ++pass)
    {
      const std::size_t before = ring.size();
      for (std::size_t i = 0; i < before; ++i)
      {
        this->addAround(ring[i], ring);
      }
    }
    return ring;
  }

private:
  void addAround(std::int32_t triangle, std::vector<std::int32_t>& ring)
  {
    for (const std::int32_t corner : this->Body.triangles[static_cast<std::size_t>(triangle)])
    {
      for (const std::int32_t t : this->Around[static_cast<std::size_t>(corner)])
      {
        if (this->Seen[static_cast<std::size_t>(t)] != this->Stamp)
        {
          this->Seen[static_cast<std::size_t>(t)] = this->Stamp;
          ring.push_back(t);
        }
      }
    }
  }

  const Surface& Body;
  std::vector<std::vector<std::int32_t>> Around;
  std::vector<int> Seen;
  int Stamp = 0;
};

/// A bumpy sphere in the form that the tick uses, and its coordinates for the enumeration.
struct Track
{
  explicit Track(double triangles)
    : mesh(bumpySphere(bumpyCuts(triangles)).packed())
    , tree(mesh)
    , body(bumpySphere(bumpyCuts(triangles)).rounded())
    , rings(body)
  {
  }
  PackedMesh mesh;
  TriangleTree tree;
  Surface body;
  Rings rings;
};

/// The required accuracy: 1e-9 of the diagonal of the bounding box.
double tolerance(const Track& track)
{
  return 1e-9 * diagonal(track.body);
}

struct Moved
{
  int farther = 0;    ///< number of ticks whose contact is beyond the two rings
  double worst = 0.0; ///< largest distance between the tick's contact and the enumerated one, mm
};

/// Follows a path. The enumeration starts from the last contact and is repeated from its own result
/// until the result no longer changes. One round is enough unless the tip left the two rings.
Moved follow(Track& track, double depth, double step, std::size_t ticks)
{
  ContactTracker tracker(track.mesh, track.tree);
  const std::vector<Vector3> tips = windingTips(ticks, depth, step);
  Moved moved;
  std::int32_t last = -1;
  for (const Vector3& tip : tips)
  {
    const ContactTracker::Result contact = tracker.update(tip);
    EXPECT_EQ(contact.outcome, ContactTracker::Outcome::Inside);
    if (last >= 0)
    {
      Nearest nearest = nearestOf(track.body, tip, track.rings.twoRings(last));
      for (bool first = true;; first = false)
      {
        const Nearest next = nearestOf(track.body, tip, track.rings.twoRings(nearest.triangle));
        if (!(next.distance < nearest.distance))
        {
          break;
        }
        nearest = next;
        moved.farther += first;
      }
      const auto apart =
        static_cast<double>((contact.place.projection.point.cast<Real>() - nearest.point).norm());
      moved.worst = std::max(moved.worst, apart);
    }
    last = track.mesh.inputTriangle(contact.place.triangle);
  }
  return moved;
}

/// The tracker without its certificate: from a point on an edge it moves to the neighbour if this
/// is nearer, and it stops on a face.
class PlainDescent
{
public:
  PlainDescent(const PackedMesh& mesh, std::int32_t triangle)
    : Mesh(mesh)
    , Triangle(triangle)
  {
  }

  /// Returns the distance from the tip (local coordinates) to the final point.
  double update(const Vector3& tip)
  {
    TriangleProjection place = this->Mesh.project(tip, this->Triangle);
    while (this->cross(tip, place))
    {
    }
    return std::sqrt(place.squaredDistance);
  }

private:
  bool cross(const Vector3& tip, TriangleProjection& place)
  {
    for (int edge = 0; edge < 3; ++edge)
    {
      // Edge i is opposite corner i + 2, whose weight is 0 on the edge.
      if (place.weights[(edge + 2) % 3] != 0.0)
      {
        continue;
      }
      const std::int32_t across = this->Mesh.neighbour(this->Triangle, edge);
      const TriangleProjection candidate = this->Mesh.project(tip, across);
      if (candidate.squaredDistance < place.squaredDistance)
      {
        place = candidate;
        this->Triangle = across;
        return true;
      }
    }
    return false;
  }

  const PackedMesh& Mesh;
  std::int32_t Triangle;
};
} // namespace

class ExactContact : public ::testing::TestWithParam<double>
{
};

TEST_P(ExactContact, TenthOfAMillimetrePerTick)
{
  Track track(GetParam());
  for (const double depth : { 1.0, 5.0 })
  {
    const Moved moved = follow(track, depth, 0.1, Ticks);
    EXPECT_EQ(moved.farther, 0) << depth; // the rule of two rings holds in every tick
    EXPECT_LE(moved.worst, tolerance(track)) << depth;
  }
}

TEST_P(ExactContact, OneMetrePerSecond)
{
  // 1 mm per tick of a millisecond. Edges are 8 mm long with 20 thousand triangles and 1.1 mm with
  // 200 thousand, so the tip stays within the two rings or next to them.
  Track track(GetParam());
  for (const double depth : { 1.0, 5.0 })
  {
    const Moved moved = follow(track, depth, 1.0, Ticks / 2);
    EXPECT_LE(moved.farther, static_cast<int>(Ticks) / 100) << depth;
    EXPECT_LE(moved.worst, tolerance(track)) << depth;
  }
}

TEST_P(ExactContact, TenMetresPerSecond)
{
  Track track(GetParam());
  for (const double depth : { 1.0, 5.0 })
  {
    EXPECT_LE(follow(track, depth, 10.0, Ticks / 20).worst, tolerance(track)) << depth;
  }
}

TEST_P(ExactContact, ADescentOverEdgesFails)
{
  // Reason for the certificate: each facet of a convex pair has its own nearest point. A plain
  // descent stops at the wrong one in 1 to 3 % of these ticks at a depth of 1 mm, and in 9 to 10 %
  // at 5 mm.
  const Track track(GetParam());
  ContactTracker tracker(track.mesh, track.tree);
  for (const double depth : { 1.0, 5.0 })
  {
    const std::vector<Vector3> tips = windingTips(Ticks, depth, 0.1);
    tracker.reset();
    tracker.update(tips.front());
    PlainDescent descent(track.mesh, tracker.triangle());
    std::size_t wrong = 0;
    for (const Vector3& tip : tips)
    {
      const double distance = -tracker.update(tip).place.signedDistance;
      const double reached = descent.update(track.mesh.toLocal(tip));
      EXPECT_GE(reached, distance - 1e-13 * depth) << "the tracker is not nearer than a descent";
      wrong += reached > distance + 1e-9;
    }
    RecordProperty(
      "wrong_ticks_at_" + std::to_string(static_cast<int>(depth)) + "_mm", static_cast<int>(wrong));
    EXPECT_GE(wrong, Ticks / 200) << depth;
  }
}

TEST_P(ExactContact, MostTicksNeedNoSearchAround)
{
  // Measured: 88 % of the ticks are certified with 20 thousand triangles, 93 % with 200 thousand.
  // The other ticks are near an edge or a corner.
  const Track track(GetParam());
  ContactTracker tracker(track.mesh, track.tree);
  int certified = 0;
  for (const Vector3& tip : windingTips(Ticks, 1.0, 0.1))
  {
    const SurfacePoint found = tracker.update(tip).place;
    const Vector3 local = track.mesh.toLocal(tip);
    certified += found.projection.feature == TriangleFeature::Face &&
      track.mesh.isCertainlyNearest(
        local, found.triangle, track.mesh.project(local, found.triangle));
  }
  RecordProperty("certified", certified);
  EXPECT_GT(certified, static_cast<int>(Ticks) * 8 / 10);
}

INSTANTIATE_TEST_SUITE_P(Triangles, ExactContact, ::testing::Values(2e4, 2e5));
} // namespace palpate::testing

// SPDX-License-Identifier: BSD-3-Clause
// A body that is built, reduced and pressed with 1, 2 and 8 threads gives identical bits. It has so
// many points that each of eight threads has work.
#include "BumpySphere.h"
#include "Contact/Reduction/LeadingLaws.h"
#include "Contact/ParallelRanges.h"
#include "Contact/Reduction/ReducibleCurves.h"
#include "Contact/Reduction/ResponseChoice.h"
#include "Contact/Reduction/ResponseReduction.h"
#include "SampleResponses.h"
#include "Sanitized.h"
#include "Contact/ToolContact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <type_traits>
#include <vector>

using namespace palpate;
using namespace palpate::testing;

namespace
{
#ifdef PALPATE_SANITIZED
constexpr int Cuts = 64; // 16386 points: at most two threads, which is enough to find a race
#else
constexpr int Cuts = 136; // 73986 points, 147968 triangles
#endif
constexpr std::size_t Ticks = 4000;

/// The bytes of all compared results, one after the other.
class Bytes
{
public:
  template <class Value>
  void add(const Value* values, std::size_t count)
  {
    static_assert(std::is_arithmetic_v<Value>, "no padding");
    const auto* bytes = reinterpret_cast<const unsigned char*>(values);
    this->Stored.insert(this->Stored.end(), bytes, bytes + count * sizeof(Value));
  }
  template <class Value>
  void add(Value value)
  {
    this->add(&value, 1);
  }
  void add(const Vector3& vector) { this->add(vector.data(), 3); }
  template <class Value>
  void add(const std::vector<Value>& values)
  {
    this->add(values.size());
    this->add(values.data(), values.size());
  }

  bool operator==(const Bytes& other) const { return this->Stored == other.Stored; }
  std::size_t size() const { return this->Stored.size(); }

private:
  std::vector<unsigned char> Stored;
};

/// Expects the same bits for 1, 2 and 8 threads, and checks that this number of threads was used.
template <class Work>
void expectSameBits(const Work& work)
{
  Bytes alone;
  for (const std::size_t threads : { 1, 2, 8 })
  {
    const ThreadLimit limit(threads);
    ASSERT_EQ(rangeCount(8 * 8192), threads);
    const Bytes found = work();
    ASSERT_GT(found.size(), 10000U);
    alone = threads == 1 ? found : alone;
    EXPECT_TRUE(found == alone) << threads << " threads";
  }
}

/// Points and triangles in random order, so that the order along the curve differs from that of the
/// input. The curves are not sums of a few laws, unless takeTwoLaws() is called.
struct Made
{
  Surface surface = shuffled(bumpySphere(Cuts), 11);
  ResponseStore store{ this->surface.points.size() };

  Made()
  {
    takeMeshNormals(this->store, this->surface);
    this->store.randomizeCurves(12);
  }

  /// Sets F = 10 δ^1.5 (1 + a part that grows faster), times a scale, so that two laws represent
  /// all curves.
  void takeTwoLaws()
  {
    const std::size_t n = this->store.force.size() / this->store.range.size();
    for (std::size_t p = 0; p < this->store.range.size(); ++p)
    {
      this->store.range[p] = 2.0F;
      const double scale = 1.0 + 0.5 * std::sin(0.37 * static_cast<double>(p));
      const double share = 0.5 + 0.4 * std::sin(0.11 * static_cast<double>(p));
      for (std::size_t i = 0; i < n; ++i)
      {
        const double s = static_cast<double>(i + 1) / static_cast<double>(n);
        const double d = 2.0 * s * s;
        this->store.force[n * p + i] =
          static_cast<float>(scale * (10.0 * std::pow(d, 1.5) + share * 8.0 * d * d));
        this->store.stiffness[n * p + i] =
          static_cast<float>(scale * (15.0 * std::sqrt(d) + share * 16.0 * d));
      }
    }
  }
};

void addSurface(Bytes& bytes, const PackedMesh& mesh)
{
  bytes.add(mesh.centre());
  for (std::size_t i = 0; i < mesh.triangleCount(); ++i)
  {
    const auto t = static_cast<std::int32_t>(i);
    bytes.add(mesh.inputTriangle(t));
    for (int k = 0; k < 3; ++k)
    {
      bytes.add(mesh.corners(t)[static_cast<std::size_t>(k)]);
      bytes.add(mesh.neighbour(t, k));
      bytes.add(mesh.corner(t, k));
    }
  }
  for (std::size_t i = 0; i < mesh.pointCount(); ++i)
  {
    const auto point = static_cast<std::int32_t>(i);
    bytes.add(mesh.inputPoint(point));
    bytes.add(mesh.pointNormal(point));
    mesh.visitAround(point, [&bytes](std::int32_t triangle) { bytes.add(triangle); });
  }
}

/// Adds the results of single queries and of a path in contact with friction.
void addContact(Bytes& bytes, const ContactBody& body)
{
  for (const Vector3& tip : windingTips(Ticks, 1.3, 7.0))
  {
    const SurfacePoint found = body.tree.closest(tip);
    bytes.add(found.triangle);
    bytes.add(found.signedDistance);
    bytes.add(found.projection.point);
  }
  ContactSettings settings;
  settings.friction.coefficient = 0.4;
  ToolContact contact(body, settings);
  int touching = 0;
  for (const Vector3& tip : windingTips(Ticks, 0.9, 0.2))
  {
    const Contact felt = contact.update(tip);
    touching += felt.normalForce > 0.0;
    bytes.add(felt.force);
    bytes.add(felt.friction);
    bytes.add(felt.contactPoint);
    bytes.add(felt.deflection);
    bytes.add(felt.triangle);
  }
  EXPECT_GT(touching, static_cast<int>(Ticks / 2));
}

void addReduction(Bytes& bytes, const ResponseArrays& arrays, ReducedForm expected)
{
  const ReducedResponse reduced = reduceResponse(arrays, {});
  EXPECT_EQ(reduced.form, expected);
  bytes.add(static_cast<int>(reduced.form));
  bytes.add(reduced.basis);
  bytes.add(reduced.coefficient);
  bytes.add(reduced.force);
  bytes.add(reduced.stiffness);
  bytes.add(reduced.largestError);
  bytes.add(reduced.largestSlopeError);
  bytes.add(reduced.worstPoint);
}
} // namespace

TEST(Determinism, BodyAndContact)
{
  const Made made;
  expectSameBits(
    [&made]
    {
      Bytes bytes;
      const auto body = contactBody(made.surface, made.store);
      addSurface(bytes, body->surface);
      addContact(bytes, *body);
      return bytes;
    });
}

TEST(Determinism, Reduction)
{
  Made made;
  made.takeTwoLaws();
  expectSameBits(
    [&made]
    {
      Bytes bytes;
      addReduction(bytes, made.store.arrays(), ReducedForm::Basis);
      // The laws before they are rounded to float, because rounding would hide the order of the
      // sums.
      const Eigen::MatrixXd laws = leadingLaws(ReducibleCurves(made.store.arrays()), 4);
      bytes.add(laws.data(), static_cast<std::size_t>(laws.size()));
      return bytes;
    });
}

TEST(Determinism, Choice)
{
  Made made;
  made.takeTwoLaws();
  expectSameBits(
    [&made]
    {
      Bytes bytes;
      const palpate::ResponseChoice choice = chooseResponse(made.store.arrays(), {}, {});
      EXPECT_EQ(choice.need, ResponseNeed::FewLaws);
      bytes.add(choice.exponent);
      bytes.add(choice.basis);
      bytes.add(choice.coefficient);
      bytes.add(choice.keptShare);
      bytes.add(choice.largestError);
      bytes.add(choice.springLoss);
      return bytes;
    });
}

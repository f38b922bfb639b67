// SPDX-License-Identifier: BSD-3-Clause
// The motion of a surface around a contact: a paraboloid on a plane against its closed form, modes
// against values computed by hand.
#include "Laws/ContactField.h"

#include "Paraboloid.h"
#include "Mechanics/Layers/LayerContact.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace palpate;
using palpate::testing::Paraboloid;

namespace
{
constexpr double Depth = 1.0;  // mm
constexpr double Float = 2e-7; // rounding of a displacement of about 1 mm

/// Displacement of the surface at the radius r under a paraboloid (Johnson 1985, eq. 3.42).
double normalDisplacement(const Paraboloid& shape, double r)
{
  const double a = std::sqrt(shape.radius * Depth);
  return r <= a ? Depth - 0.5 * r * r / shape.radius
                : ((2.0 * a * a - r * r) * std::asin(a / r) + a * std::sqrt(r * r - a * a)) /
      (Pi * shape.radius);
}

/// The plane z = 0, triangles facing +z, with a point at the origin.
BodyMesh makePlane(int half, double spacing)
{
  std::vector<double> points;
  std::vector<std::int32_t> triangles;
  const int side = 2 * half + 1;
  for (int j = 0; j < side; ++j)
  {
    for (int i = 0; i < side; ++i)
    {
      points.insert(points.end(), { spacing * (i - half), spacing * (j - half), 0.0 });
      if (i + 1 < side && j + 1 < side)
      {
        const std::int32_t at = side * j + i;
        triangles.insert(
          triangles.end(), { at, at + 1, at + side + 1, at, at + side + 1, at + side });
      }
    }
  }
  return { points.data(), points.size() / 3, triangles.data(), triangles.size() / 3 };
}

FieldTriangle unitTriangle()
{
  FieldTriangle triangle;
  triangle.corners = { Vector3::Zero(), Vector3::UnitX(), Vector3::UnitY() };
  return triangle;
}

FieldContact contactAt(const Vector3& point)
{
  return { 0, Depth, 0.5, point, Vector3::UnitZ() };
}

class Field : public ::testing::Test
{
protected:
  ContactField make(const FieldTriangle& triangle, const FieldContact& contact, double reach = 0.0)
  {
    return { triangle, *this->Tool, contact, { 0.5, reach }, this->Kernel };
  }

  Paraboloid Shape;
  std::unique_ptr<AxisymmetricTool> Tool = Shape.make();
  std::shared_ptr<const LayerKernel> Kernel;
};
} // namespace

TEST_F(Field, AParaboloidOnAPlane)
{
  const BodyMesh mesh = makePlane(10, 0.7);
  const FieldContact contact = contactAt(Vector3::Zero());
  const ContactField field = this->make(unitTriangle(), contact);
  EXPECT_NEAR(field.contactRadius(), 2.0, 1e-12); // √(R δ)
  SurfacePatch patch(mesh, contact.point, contact.normal, 0.0);
  patch.enter(220); // the middle point of 21 x 21
  std::vector<float> u(3 * mesh.pointCount(), 0.0F);
  ASSERT_TRUE(contactField(field, contact.normal, {}, patch, mesh.pointCount(), u.data()));
  for (std::size_t i = 0; i < mesh.pointCount(); ++i)
  {
    const Vector3 x = mesh.point(static_cast<std::int32_t>(i));
    const Vector3 moved(u[3 * i], u[3 * i + 1], u[3 * i + 2]);
    EXPECT_NEAR(moved.z(), -normalDisplacement(Shape, x.norm()), Float) << i;
    // An incompressible half-space has no tangential motion, inside or outside the contact.
    EXPECT_NEAR(moved.head<2>().norm(), 0.0, Float) << i;
  }
}

TEST_F(Field, EndsAtItsReachWithoutAnEdge)
{
  const ContactField field = this->make(unitTriangle(), contactAt(Vector3::Zero()), 8.0);
  EXPECT_EQ(field.fade(6.0, 1.0), 1.0);
  EXPECT_NEAR(field.fade(7.0, 1.0), 0.5, 1e-12); // half-way in a symmetric fade
  EXPECT_EQ(field.fade(8.0, 1.0), 0.0);
  EXPECT_EQ(field.fade(0.0, std::cos(Pi / 3.0) - 1e-9), 0.0);
  EXPECT_NEAR(field.fade(0.0, std::cos(Pi / 3.6)), 1.0, 1e-12);
}

TEST_F(Field, WithoutContactNothingMoves)
{
  FieldContact contact = contactAt(Vector3::Zero());
  contact.cell = -1;
  EXPECT_TRUE(this->make(unitTriangle(), contact).isEmpty());
  contact = contactAt(Vector3::Zero());
  contact.deflection = 0.0;
  EXPECT_TRUE(this->make(unitTriangle(), contact).isEmpty());
  EXPECT_EQ(ContactField().local(0.0).normal, 0.0);
}

TEST_F(Field, ModesTakeTheirShareOfTheDepth)
{
  FieldTriangle triangle = unitTriangle();
  FieldTriangle::Mode mode;
  mode.sign = 1.0;
  mode.vectors = { Vector3(0, 0, 0.2), Vector3(0, 0, 0.6), Vector3(9, 9, 1.0) };
  triangle.modes = { mode };
  const FieldContact contact = contactAt(Vector3(0.25, 0.5, 0.0)); // weights 1/4, 1/4, 1/2
  const ContactField field = this->make(triangle, contact);
  const double phi = 0.7;
  ASSERT_EQ(field.modeWeights().size(), 1U);
  EXPECT_NEAR(field.modeWeights()[0], -0.5 * phi, 1e-15);
  EXPECT_NEAR(field.localDeflection(), Depth - 0.5 * phi * phi, 1e-15);
  EXPECT_NEAR(field.local(0.0).normal, field.localDeflection(), 1e-12);
}

TEST_F(Field, ModesMoveAllPointsAlikeInFloatsAndDoubles)
{
  constexpr std::size_t count = 30000; // enough for several threads
  FieldTriangle triangle = unitTriangle();
  triangle.modes.resize(2);
  for (FieldTriangle::Mode& mode : triangle.modes)
  {
    mode.sign = 1.0;
    mode.vectors.fill(Vector3::UnitZ());
  }
  const FieldContact contact = contactAt(Vector3::Zero());
  const ContactField field = this->make(triangle, contact);
  EXPECT_TRUE(field.isEmpty()); // the modes take the whole depth
  std::vector<float> floats(3 * count);
  std::vector<double> doubles(3 * count);
  for (std::size_t i = 0; i < floats.size(); ++i)
  {
    floats[i] = static_cast<float>(i);
    doubles[i] = 2.0;
  }
  const BodyMesh mesh(nullptr, 0, nullptr, 0);
  SurfacePatch patch(mesh, contact.point, contact.normal, 0.0);
  std::vector<float> u(3 * count, 1.0F);
  ASSERT_TRUE(
    contactField(field, contact.normal, { floats.data(), doubles.data() }, patch, count, u.data()));
  for (std::size_t i = 0; i < u.size(); ++i)
  {
    ASSERT_EQ(u[i], 1.0F - 0.5F * static_cast<float>(i) - 1.0F) << i; // w = -F φ = -1/2
  }
  floats[7] = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(
    contactField(field, contact.normal, { floats.data(), doubles.data() }, patch, count, u.data()));
}

TEST_F(Field, BetweenCornersTheInverseOfTheThicknessIsLinear)
{
  FieldTriangle triangle = unitTriangle();
  triangle.thickness = { 4.0, 4.0, 0.0 }; // 0: no layer, 1/h = 0
  triangle.base = LayerBase::Slip;
  const ContactField field = this->make(triangle, contactAt(Vector3(1.0 / 3.0, 1.0 / 3.0, 0.0)));
  const LayerContact layer(
    *this->Tool, std::make_shared<const LayerKernel>(0.5, LayerBase::Slip), 6.0);
  EXPECT_NEAR(field.contactRadius(), layer.contactRadius(Depth), 1e-9);
  EXPECT_EQ(this->Kernel->base(), LayerBase::Slip);
}

TEST_F(Field, ALayerThatIsTooThinIsAFault)
{
  FieldTriangle triangle = unitTriangle();
  triangle.thickness = { 0.01, 0.01, 0.01 };
  const ContactField field = this->make(triangle, contactAt(Vector3::Zero()));
  EXPECT_TRUE(field.isEmpty());
  EXPECT_NE(field.fault().find("0.01 mm"), std::string::npos) << field.fault();
}

TEST_F(Field, ANearFieldIsDrawnBesideTheDentOfItsForce)
{
  FieldTriangle triangle = unitTriangle();
  NearField corner;
  corner.depth = 0.1;
  corner.slope = Vector3(0.02, 0.0, 0.0);
  corner.bend = Vector3(0.0, 0.003, 0.0).asDiagonal();
  corner.radius = 6.0;
  corner.reducedModulus = 0.2;
  triangle.near = { corner, corner, corner };
  FieldContact contact = contactAt(Vector3(0.25, 0.25, 0.0));
  const double local = 0.7; // mm; deflection at which a half-space has this force
  contact.force = this->Tool->force(local, corner.reducedModulus);
  const ContactField field = this->make(triangle, contact);
  EXPECT_NEAR(field.localDeflection(), local, 1e-7); // tolerance of increasingRoot
  const double a = field.contactRadius();
  EXPECT_NEAR(a, std::sqrt(this->Shape.radius * local), 1e-6);
  // Inside the contact the surface follows the tool.
  EXPECT_NEAR(field.near(Vector3::Zero()), Depth - local, 1e-7);
  EXPECT_NEAR(field.near(Vector3(0.9 * a, 0.0, 0.0)), Depth - local, 1e-7);
  // At twice the contact radius: asin(1/2) = π/6 and (1/2) √(3/4) = √3/4.
  const double held = 2.0 / Pi * (Pi / 6.0 - std::sqrt(3.0) / 4.0);
  EXPECT_NEAR(field.near(Vector3(2.0 * a, 0.0, 0.0)),
    held * (Depth - local) + (1.0 - held) * contact.force * (0.1 + 0.02 * 2.0 * a), 1e-7);
  EXPECT_NEAR(field.near(Vector3(0.0, 2.0 * a, 0.0)),
    held * (Depth - local) + (1.0 - held) * contact.force * (0.1 + 0.003 * 4.0 * a * a), 1e-7);
  // Beyond the radius of the near field the displacement decays as 1/r².
  EXPECT_NEAR(corner.at(Vector3(12.0, 0.0, 0.0)), 0.25 * (0.1 + 0.02 * 6.0), 1e-15);
}

TEST_F(Field, ANearFieldThatIsNoNumberIsNone)
{
  FieldTriangle triangle = unitTriangle();
  for (NearField& near : triangle.near)
  {
    near.radius = 6.0;
    near.reducedModulus = 0.2;
    near.depth = std::numeric_limits<double>::quiet_NaN();
  }
  const ContactField field = this->make(triangle, contactAt(Vector3::Zero()));
  EXPECT_EQ(field.near(Vector3(1.0, 0.0, 0.0)), 0.0);
  EXPECT_EQ(field.localDeflection(), Depth);
}

TEST(NearField, IsStoredAsItsNumbers)
{
  std::array<double, NearField::Numbers> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    numbers[i] = static_cast<double>(i) + 0.5;
  }
  EXPECT_EQ(numbersOf(nearFieldOf(numbers)), numbers);
  EXPECT_TRUE(nearFieldOf(numbers).bend.isApprox(nearFieldOf(numbers).bend.transpose()));
}

TEST_F(Field, APatchGoesOnBeyondASeam)
{
  const BodyMesh mesh = makePlane(2, 1.0);
  // on another piece of the surface
  const FieldContact contact = contactAt(Vector3(100.0, 0.0, 0.0));
  const ContactField field = this->make(unitTriangle(), contact);
  SurfacePatch patch(mesh, contact.point, contact.normal, 0.0);
  std::vector<float> u(3 * mesh.pointCount(), 0.0F);
  int crossed = 0;
  ASSERT_TRUE(contactField(field, contact.normal, {}, patch, mesh.pointCount(), u.data(),
    [&](SurfacePatch& pending)
    {
      pending.enter(24);
      return ++crossed == 1;
    }));
  EXPECT_EQ(crossed, 2);
  EXPECT_TRUE(std::none_of(u.begin(), u.end(), [](float value) { return std::isnan(value); }));
  EXPECT_LT(u[2], 0.0F);
}

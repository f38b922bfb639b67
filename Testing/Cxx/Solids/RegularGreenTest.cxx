// SPDX-License-Identifier: BSD-3-Clause
// The singular field, the sources and the law on small bodies: equations that they must satisfy,
// the number of threads, an abort, and error messages.
#include "ShapedBodies.h"

#include "Agreement.h"
#include "Mechanics/ThreadCount.h"
#include "Solids/TrueShape/BoussinesqField.h"
#include "TestTools.h"

#include <cstring>

namespace regular_green
{
namespace
{
using namespace palpate;
using palpate::testing::agrees;
using palpate::testing::heldBelow;
using palpate::testing::hexahedronBlock;
using palpate::testing::pointAt;

bool always(double)
{
  return true;
}

void makeBody(ElasticBody& body, VolumeMesh mesh, const std::vector<ElasticMaterial>& materials)
{
  const std::vector<unsigned char> fixed = heldBelow(mesh);
  ASSERT_EQ(body.assemble({ std::move(mesh), materials, fixed }), "");
  ASSERT_EQ(body.analyse(StiffnessFactor::Kind::Automatic), "");
  ASSERT_EQ(body.factorise(), "");
}

/// Young's modulus 2 for x > 4, else 1.
std::vector<ElasticMaterial> twoMaterials(const VolumeMesh& mesh)
{
  std::vector<ElasticMaterial> materials;
  for (const VolumeElement& cell : mesh.elements)
  {
    materials.push_back({ elementMiddle(mesh, cell)[0] > 4.0 ? 2.0 : 1.0, 0.3 });
  }
  return materials;
}
} // namespace

// ε and σ by central differences of u: step² gives an error of 1e-8, and rounding the same.
TEST(BoussinesqField, StrainAndStressAreThoseOfTheDisplacement)
{
  const ElasticMaterial material{ 3.0, 0.35 };
  const BoussinesqField field(material);
  for (const Eigen::Vector3d& at :
    { Eigen::Vector3d(1.0, 0.5, 0.8), Eigen::Vector3d(-0.3, 0.9, 0.0),
      Eigen::Vector3d(0.7, -0.4, -0.3), Eigen::Vector3d(0.0, 0.0, 1.2) })
  {
    Eigen::Matrix3d gradient;
    for (int axis = 0; axis < 3; ++axis)
    {
      const Eigen::Vector3d step = 1e-4 * Eigen::Vector3d::Unit(axis);
      gradient.col(axis) = (field.displacement(at + step) - field.displacement(at - step)) / 2e-4;
    }
    const Eigen::Matrix3d strain = 0.5 * (gradient + gradient.transpose());
    EXPECT_LT((field.strain(at) - strain).norm(), 1e-7 * strain.norm());
    Eigen::Matrix3d stress = 3.0 / 1.35 * strain;
    stress.diagonal().array() += 3.0 * 0.35 / (1.35 * 0.3) * strain.trace();
    EXPECT_LT((field.stress(at) - stress).norm(), 1e-6 * stress.norm());
  }
  // The plane surface is free of stress and sinks by 1/(πE*r).
  const Eigen::Vector3d on(0.6, 0.8, 0.0);
  EXPECT_LT(field.stress(on).col(2).norm(), 1e-16);
  EXPECT_TRUE(
    agrees(field.displacement(on)[2], (1.0 - 0.35 * 0.35) / (3.0 * 3.14159265358979), 1e-12));
}

// Without a kernel the law is that of a half-space, which has a closed form for each tool.
TEST(ShapedContact, IsTheToolsOwnOnAHalfSpace)
{
  ContactKernel none;
  none.order = 1;
  for (const char* name : { "sphere:6.35", "cone:60", "truncated:1,75", "rounded:2,4" })
  {
    const auto pressed = palpate::testing::tool(name);
    const ShapedContact contact(*pressed);
    for (const double radius : { 2.2, 3.0, 5.0 })
    {
      const ShapedContact::Contact found = contact.at(radius, none, 1.7);
      EXPECT_TRUE(found.stable);
      EXPECT_TRUE(agrees(found.deflection, pressed->depthAtContactRadius(radius), 1e-12)) << name;
      // Error of the rule of 48 points over g.
      EXPECT_TRUE(agrees(found.force, pressed->force(found.deflection, 1.7), 1e-9)) << name;
      EXPECT_TRUE(agrees(found.stiffness, 2.0 * 1.7 * radius, 1e-12)) << name;
    }
  }
}

// A constant kernel is a compliance in series, for any tool and contact radius.
TEST(ShapedContact, AConstantKernelIsInSeries)
{
  ContactKernel constant;
  constant.order = 1;
  constant.coefficients(0, 0) = 0.07;
  const auto pressed = palpate::testing::tool("sphere:6.35");
  const ShapedContact::Contact found = ShapedContact(*pressed).at(2.0, constant, 1.2);
  const double local = pressed->depthAtContactRadius(2.0);
  const double force = pressed->force(local, 1.2);
  EXPECT_TRUE(agrees(found.force, force, 1e-10));
  EXPECT_TRUE(agrees(found.deflection, local + 0.07 * force, 1e-10));
}

// A contact tilted by s has a tangential force of s times its normal force. The compliance is then
// the normal compliance, plus 2 s times the coupling of both directions, plus s² times the
// tangential compliance.
TEST(ShapedContact, SaysWhatLeaningAsideMayDo)
{
  static constexpr double self = 0.07;
  static constexpr double lean = 0.1;
  class Leaning : public ContactKernels
  {
  public:
    Leaning()
    {
      this->Site.status = PatchStatus::Valid;
      this->Site.material = { 1.0, 0.4 };
      this->Site.reducedModulus = 1.2;
      this->Site.largestRadius = 3.0;
      this->Site.elements = { 0.0, 0.0, 0.0 };
      this->Site.directed << 4.0, 0.0, 0.3, 0.0, 1.0, 0.0, 0.3, 0.0, self;
    }
    ContactKernel at(double, int) const override
    {
      ContactKernel kernel;
      kernel.order = 1;
      kernel.coefficients(0, 0) = self;
      kernel.gap.lean = { lean, 0.0 };
      return kernel;
    }
  };
  const auto pressed = palpate::testing::tool("sphere:6.35");
  const ContactSample last = ShapedContact(*pressed).curve(Leaning()).samples().back();
  const double stiffness = 1.0 / (1.0 / (2.0 * 1.2 * last.radius) + self);
  EXPECT_NEAR(last.direction, stiffness * (2.0 * lean * 0.3 + lean * lean * 4.0), 1e-12);
}

// A power of δ is a straight line in the coordinates of the curve. The stiffness is the derivative.
TEST(ContactCurve, KeepsAPowerAndItsDerivative)
{
  std::vector<ContactSample> samples;
  for (int i = 1; i <= 9; ++i)
  {
    ContactSample sample;
    sample.radius = std::sqrt(0.1 * i);
    sample.deflection = 0.1 * i;
    sample.force = 3.0 * std::pow(0.1 * i, 1.5);
    samples.push_back(sample);
  }
  const ContactCurve curve(samples, 1.5, false, 0.0, CurveEnd::Patch, 0.0);
  for (const double depth : { 0.02, 0.1, 0.234, 0.77, 0.9 })
  {
    const IndentationPoint found = curve.evaluate(depth);
    EXPECT_TRUE(agrees(found.force, 3.0 * std::pow(depth, 1.5), 1e-12));
    EXPECT_TRUE(agrees(found.stiffness, 4.5 * std::sqrt(depth), 1e-12));
    EXPECT_TRUE(agrees(found.contactRadius, std::sqrt(depth), 1e-12));
  }
  EXPECT_EQ(curve.evaluate(-1.0).force, 0.0);
  EXPECT_TRUE(std::isnan(curve.evaluate(0.91).force));
}

TEST(RegularGreen, SameBitsForAnyNumberOfThreads)
{
  VolumeMesh mesh = hexahedronBlock(8, 8, 4, 1.0);
  const std::vector<ElasticMaterial> materials = twoMaterials(mesh);
  ElasticBody body;
  makeBody(body, mesh, materials);
  std::vector<std::int32_t> points;
  for (int x = 1; x < 8; ++x)
  {
    for (int y = 1; y < 8; ++y)
    {
      points.push_back(pointAt(body.surface(), Eigen::Vector3d(x, y, 4.0)));
    }
  }
  std::vector<double> alone;
  for (const std::size_t threads : { 1U, 2U, 3U })
  {
    const ThreadLimit limit(threads);
    RegularGreen green(body);
    ASSERT_EQ(green.solve(points, 2.0, always), "");
    EXPECT_GT(green.sources(), 32U); // more than one block
    std::vector<double> found;
    for (const std::int32_t point : points)
    {
      found.push_back(green.at(point, point));
      found.push_back(green.at(point, points.front()));
    }
    alone = threads == 1 ? found : alone;
    EXPECT_EQ(std::memcmp(found.data(), alone.data(), 8 * found.size()), 0) << threads;
  }
}

TEST(RegularGreen, StopsWhenToldTo)
{
  ElasticBody body;
  makeBody(body, hexahedronBlock(8, 8, 3, 1.0), { { 1.0, 0.3 } });
  std::vector<std::int32_t> points;
  for (std::int32_t i = 0; i < body.surface().pointTotal(); ++i)
  {
    points.push_back(i);
  }
  RegularGreen green(body);
  EXPECT_EQ(green.solve(points, 2.0, [](double) { return false; }), "stopped");
  EXPECT_EQ(green.sources(), 0U);
  double last = 0.0;
  EXPECT_EQ(green.solve(points, 2.0,
              [&last](double done)
              {
                EXPECT_GT(done, last);
                last = done;
                return true;
              }),
    "");
  EXPECT_EQ(last, 1.0);
}

TEST(RegularGreen, SaysWhatIsWrong)
{
  const VolumeMesh mesh = hexahedronBlock(8, 8, 3, 1.0);
  ElasticBody body;
  makeBody(body, mesh, twoMaterials(mesh));
  const auto at = [&](double x, double y, double z)
  { return pointAt(body.surface(), Eigen::Vector3d(x, y, z)); };
  EXPECT_EQ(whyNotPressed(body, at(2, 4, 3)), "");
  EXPECT_NE(whyNotPressed(body, at(4, 4, 3)).find("between materials"), std::string::npos);
  EXPECT_NE(whyNotPressed(body, at(0, 4, 3)).find("on an edge"), std::string::npos);
  EXPECT_NE(whyNotPressed(body, at(4, 4, 0)).find("is held"), std::string::npos);
  EXPECT_NE(whyNotPressed(body, 9999).find("does not exist"), std::string::npos);

  RegularGreen green(body);
  EXPECT_NE(
    green.solve({ at(4, 4, 0) }, 1.0, always).find("no point can be pressed"), std::string::npos);
  EXPECT_NE(green.solve({}, 1.0, always).find("no point"), std::string::npos);
  EXPECT_NE(green.solve({ at(2, 4, 3) }, -1.0, always).find("radius"), std::string::npos);
  EXPECT_NE(green.solve({ 9999 }, 1.0, always).find("does not exist"), std::string::npos);

  EXPECT_NE(green.solve({ at(2, 4, 3) }, 1.0, always, -1.0).find("spacing"), std::string::npos);

  ASSERT_EQ(green.solve({ at(2, 4, 3), at(4, 4, 3), at(0, 4, 3) }, 3.0, always), "");
  EXPECT_EQ(ContactKernelFit(green, at(4, 4, 3)).site().status, PatchStatus::Edge);
  EXPECT_EQ(ContactKernelFit(green, at(0, 4, 3)).site().status, PatchStatus::Edge);
  const ContactKernelFit fit(green, at(2, 4, 3));
  EXPECT_EQ(fit.site().status, PatchStatus::Valid);
  EXPECT_EQ(fit.site().limitedBy, PatchStatus::Edge);
  EXPECT_NEAR(
    fit.site().largestRadius, 2.0, 1e-9); // distance of the edge and of the other material
  EXPECT_TRUE(std::isnan(green.at(at(2, 4, 3), at(8, 8, 3))));
  EXPECT_EQ(fit.at(std::numeric_limits<double>::quiet_NaN()).order, 0);
  EXPECT_EQ(fit.at(0.0).order, 0);
  EXPECT_GT(fit.at(100.0).order, 0); // all points that exist
  const ContactKernelFit unknown(green, at(8, 8, 3));
  EXPECT_EQ(unknown.site().status, PatchStatus::Degenerate);
  const auto pressed = palpate::testing::tool("sphere:6.35");
  EXPECT_TRUE(ShapedContact(*pressed).curve(unknown).isEmpty());
}

// A body shaped as a mouth: the line on which the subtracted field is singular passes through the
// upper jaw. The effect of the jaw, computed without any subtraction from nodal forces on both
// bodies, is almost zero.
TEST(RegularGreen, SeesPastABodyThatStandsOverItself)
{
  const VolumeMesh whole = hexahedronBlock(12, 10, 11, 1.0);
  const Eigen::Vector3d place(4.0, 5.0, 4.0);
  const std::vector<Eigen::Vector3d> ways = { { 0.0, 0.0, 0.0 }, { 3.0, 0.0, 0.0 },
    { -3.0, 0.0, 0.0 }, { 0.0, 3.0, 0.0 } };
  std::array<std::vector<double>, 2> found;
  std::array<std::vector<double>, 2> direct;
  for (std::size_t jaw = 0; jaw < 2; ++jaw)
  {
    VolumeMesh mesh = whole;
    mesh.elements.clear();
    for (const VolumeElement& cell : whole.elements)
    {
      const Eigen::Vector3d at = elementMiddle(whole, cell);
      if (at[0] > 10.0 || at[2] < 4.0 || (jaw == 1 && at[2] > 7.0))
      {
        mesh.elements.push_back(cell);
      }
    }
    std::vector<unsigned char> fixed = heldBelow(mesh);
    for (std::size_t i = 0; i < fixed.size(); ++i)
    {
      fixed[i] = mesh.nodes(2, static_cast<Eigen::Index>(i)) > 10.5 ? 7 : fixed[i];
    }
    ElasticBody body;
    ASSERT_EQ(body.assemble({ mesh, { { 1.0, 0.3 } }, fixed }), "");
    ASSERT_EQ(body.analyse(StiffnessFactor::Kind::Automatic), "");
    ASSERT_EQ(body.factorise(), "");
    const std::int32_t source = pointAt(body.surface(), place);
    RegularGreen green(body);
    ASSERT_EQ(green.solve({ source }, 3.0, always), "");
    Eigen::Matrix3Xd force = Eigen::Matrix3Xd::Zero(3, mesh.nodes.cols());
    force(2, body.surface().node(source)) = -1.0;
    const Eigen::Matrix3Xd moved = body.displacement(force);
    for (const Eigen::Vector3d& way : ways)
    {
      const std::int32_t at = pointAt(body.surface(), place + way);
      found[jaw].push_back(green.at(at, source));
      direct[jaw].push_back(-moved(2, body.surface().node(at)));
    }
  }
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    // H is -0.09 mm/N here; 1 % of H is allowed.
    EXPECT_NEAR(found[1][i] - found[0][i], direct[1][i] - direct[0][i], 0.0009) << i;
  }
}

// The held part of a block's top ends along diagonals of the squares. This rim is nearer at the
// middle of the diagonals than at their corners.
TEST(SurfaceDisc, EndsAtTheEdgeOfWhatIsHeld)
{
  constexpr int cells = 6;
  ElasticBodyInput input;
  input.mesh = palpate::testing::tetrahedra(hexahedronBlock(cells, cells, 2, 1.0));
  input.materials = { { 1.0, 0.3 } };
  for (Eigen::Index i = 0; i < input.mesh.nodes.cols(); ++i)
  {
    const Eigen::Vector3d at = input.mesh.nodes.col(i);
    input.fixed.push_back(at[2] == 2.0 && at[0] - at[1] > 1.5 ? 7 : 0);
  }
  ElasticBody body;
  ASSERT_EQ(body.assemble(std::move(input)), "");
  const SurfaceDisc disc =
    surfaceDisc(body, pointAt(body.surface(), Eigen::Vector3d(3.0, 2.0, 2.0)), 3.0);
  EXPECT_EQ(disc.status, PatchStatus::Valid);
  EXPECT_EQ(disc.limitedBy, PatchStatus::OutOfReach);
  EXPECT_NEAR(disc.limit, std::sqrt(0.5), 1e-12); // the corners of the rim are at a distance of 1
}

// The distance is measured to the edges of the held part, not to its corners, and only to edges of
// faces that have the orientation of the place.
TEST(HeldRim, IsWhereWhatIsHeldEnds)
{
  ElasticBodyInput input;
  input.mesh = hexahedronBlock(6, 6, 2, 1.0);
  input.materials = { { 1.0, 0.3 } };
  for (Eigen::Index i = 0; i < input.mesh.nodes.cols(); ++i)
  {
    const Eigen::Vector3d at = input.mesh.nodes.col(i);
    input.fixed.push_back(at[2] == 0.0 || (at[2] == 2.0 && at[0] <= 2.0) ? 7 : 0);
  }
  ElasticBody body;
  ASSERT_EQ(body.assemble(std::move(input)), "");
  const HeldRim rim(body);
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  EXPECT_NEAR(rim.distance({ 3.25, 2.6, 2.0 }, up), 1.25, 1e-12);
  EXPECT_NEAR(
    // beyond the end of the edge the distance is that to its corner
    rim.distance({ 5.0, 7.0, 2.0 }, up), std::sqrt(10.0), 1e-12);
  // The held base ends at the sides, which counts only for places on the sides.
  EXPECT_NEAR(rim.distance({ 6.0, 3.0, 0.5 }, Eigen::Vector3d::UnitX()), 0.5, 1e-12);
  EXPECT_EQ(HeldRim().distance({ 0.0, 0.0, 0.0 }, up), Infinity);
}

// A contact needs only rows of the Green function. The forecast is larger than the memory used, but
// not much larger.
TEST(RegularGreen, ForecastsItsMemory)
{
  ElasticBody body;
  makeBody(body, hexahedronBlock(12, 12, 3, 1.0), { { 1.0, 0.3 } });
  const std::int32_t point = pointAt(body.surface(), Eigen::Vector3d(6.0, 6.0, 3.0));
  RegularGreen green(body);
  const ThreadLimit limit(1);
  const double block = 32.0 * body.unknowns() * 8.0;
  const double small = green.memoryForecast({ point }, 1.0);
  EXPECT_GT(small, 2.0 * block); // memory for loads and solutions
  EXPECT_LT(small, 6.0 * block);
  EXPECT_GT(green.memoryForecast({ point }, 4.0), small);
}
} // namespace regular_green

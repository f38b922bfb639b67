// SPDX-License-Identifier: BSD-3-Clause
// Jumps of the force between triangles, energy gained on closed paths, and the difference from the
// force on the smooth body: the formulas for polygons, and the orders in the size of the mesh.
#include "ContinuityMeasures.h"
#include "ReferenceTable.h"
#include "SampleResponses.h"
#include "Contact/ToolContact.h"
#include "Mechanics/Numerics/Constants.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace palpate::testing;
using palpate::Contact;
using palpate::ContactSettings;
using palpate::ContactState;
using palpate::ContactSurface;
using palpate::ForceForm;
using palpate::Pi;
using palpate::ToolContact;
using palpate::Vector3;

namespace
{
constexpr double Radius = 20.0;
constexpr double Depth = 1.0;

ContactSettings formOf(ForceForm form, ContactSurface surface)
{
  ContactSettings settings;
  settings.form = form;
  settings.surface = surface;
  return settings;
}

const std::vector<ForceForm> allForms = { ForceForm::Paper, ForceForm::NormalizedDirection,
  ForceForm::EnergyConsistent };

/// Meshes of a sphere; the edges of the second are half as long.
const MeshedBody& sphere(std::size_t fineness, bool isVaried)
{
  static const std::vector<MeshedBody> equal = []
  {
    std::vector<MeshedBody> bodies;
    bodies.emplace_back(smoothSphere(Radius), 10, uniform);
    bodies.emplace_back(smoothSphere(Radius), 20, uniform);
    return bodies;
  }();
  static const std::vector<MeshedBody> changing = []
  {
    std::vector<MeshedBody> bodies;
    bodies.emplace_back(smoothSphere(Radius), 10, varied);
    bodies.emplace_back(smoothSphere(Radius), 20, varied);
    return bodies;
  }();
  return (isVaried ? changing : equal)[fineness];
}

/// Jump of the force on a prism with N sides, 40 mm high, with radial normals, as a tip passes
/// below its first edge: from 1e-7 rad before to 1e-7 rad after the edge.
struct PolygonJump
{
  double force;        ///< |ΔF| / f
  double contactPoint; ///< jump of the contact point, mm
};

PolygonJump polygonJump(int sides, double depth, const ContactSettings& settings)
{
  std::vector<Eigen::Vector2d> polygon;
  std::vector<std::array<std::int32_t, 3>> caps;
  for (int i = 0; i < sides; ++i)
  {
    const double angle = 2.0 * Pi * i / sides;
    polygon.emplace_back(Radius * std::cos(angle), Radius * std::sin(angle));
    if (i > 1)
    {
      caps.push_back({ 0, i - 1, i });
    }
  }
  const Surface surface = prism(polygon, caps, 40.0);
  ResponseStore store(surface.points.size());
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    const Vector3 radial(surface.points[p].x() / Radius, surface.points[p].y() / Radius, 0.0);
    Eigen::Map<Eigen::Vector3f>(store.normal.data() + 3 * p) = radial.cast<float>();
  }
  const auto body = contactBody(surface, store);
  ToolContact contact(*body, settings);
  const auto at = [&](double angle)
  {
    const double r = Radius - depth;
    const Contact found = contact.update(Vector3(r * std::cos(angle), r * std::sin(angle), 17.3));
    EXPECT_NE(found.triangle, -1);
    return found;
  };
  at(-1e-3);
  const Contact before = at(-1e-7);
  const Contact after = at(1e-7);
  const double f = store.curveOf(0).evaluate(before.deflection).force;
  return { (after.force - before.force).norm() / f,
    (after.contactPoint - before.contactPoint).norm() };
}
} // namespace

TEST(Continuity, JumpsUnderTheCornersOfPolygons)
{
  const ReferenceTable table("geometry_jumps.csv");
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const int sides = std::stoi(table.text(row, "N"));
    const double h = table.number(row, "h");
    const double depth = table.number(row, "depth");
    const double paper = table.number(row, "eq3_rel_jump");
    const double point = table.number(row, "contact_point_jump");
    const double facets = table.number(row, "flatnormal_jump");
    // The table contains the geometry of polygons, without the path of 2e-7 rad.
    EXPECT_NEAR(h, 2.0 * Radius * std::sin(Pi / sides), 1e-13);
    EXPECT_NEAR(paper, depth / Radius * std::sin(2.0 * Pi / sides), 4e-7);
    EXPECT_NEAR(point, depth * std::sin(2.0 * Pi / sides), 2e-7 * 2.0 * Radius);
    EXPECT_NEAR(facets, 2.0 * std::sin(Pi / sides), 1e-12);

    // Coordinates are float32, 2e-6 mm: an edge of length h is rotated by 4e-6 mm / h.
    const double turned = 4e-6 / h;
    const PolygonJump ofPaper =
      polygonJump(sides, depth, formOf(ForceForm::Paper, ContactSurface::Facets));
    EXPECT_NEAR(ofPaper.contactPoint, point, 2.0 * depth * turned);
    EXPECT_NEAR(ofPaper.force, paper, 2.0 * turned * depth / h * (h / Radius) + 1e-7);
    // Blending direction and magnitude separately changes only terms of second order.
    const PolygonJump normalized =
      polygonJump(sides, depth, formOf(ForceForm::NormalizedDirection, ContactSurface::Facets));
    EXPECT_NEAR(normalized.force, paper, paper * h * h / (Radius * Radius) + 1e-6);
    // The force is along the normal of the facets.
    const PolygonJump energy =
      polygonJump(sides, depth, formOf(ForceForm::EnergyConsistent, ContactSurface::Facets));
    EXPECT_NEAR(energy.force, facets, 2.0 * turned);
    // On the smooth surface the direction of every form changes only with the path (`phong` in the
    // table, 2e-7), divided by 1 - δ/R.
    for (const ForceForm form : allForms)
    {
      const PolygonJump smooth = polygonJump(sides, depth, formOf(form, ContactSurface::Smooth));
      EXPECT_LE(smooth.force, 3.0 * table.number(row, "phong"));
      EXPECT_LE(smooth.contactPoint, 3.0 * Radius * table.number(row, "phong"));
    }
  }
}

TEST(Continuity, FacetsJumpInProportionToTheirSize)
{
  for (const bool isVaried : { false, true })
  {
    for (const ForceForm form : { ForceForm::Paper, ForceForm::NormalizedDirection })
    {
      const ContactSettings settings = formOf(form, ContactSurface::Facets);
      const double coarse = forceJump(sphere(0, isVaried), settings, Depth, 100.0);
      const double fine = forceJump(sphere(1, isVaried), settings, Depth, 100.0);
      // ΔF/f ≈ δh/R² for the crossed edge. Varying responses add the same amount.
      const double expected = Depth * sphere(0, isVaried).longestEdge / (Radius * Radius);
      EXPECT_GT(coarse, 0.4 * expected);
      EXPECT_LT(coarse, (isVaried ? 2.0 : 1.0) * expected);
      EXPECT_NEAR(coarse / fine, 2.0, 0.35);
    }
    // The normal of the facets changes by the whole angle between them: altitude / R.
    const ContactSettings energy = formOf(ForceForm::EnergyConsistent, ContactSurface::Facets);
    const double coarse = forceJump(sphere(0, isVaried), energy, Depth, 100.0);
    EXPECT_GT(coarse, 0.5 * sphere(0, isVaried).longestEdge / Radius);
    EXPECT_LT(coarse, 1.0 * sphere(0, isVaried).longestEdge / Radius);
    EXPECT_NEAR(coarse / forceJump(sphere(1, isVaried), energy, Depth, 100.0), 2.0, 0.35);
  }
}

TEST(Continuity, SmoothSurfaceDoesNotJump)
{
  for (const bool isVaried : { false, true })
  {
    for (const ForceForm form : { ForceForm::Paper, ForceForm::NormalizedDirection })
    {
      // Two tips are 1e-9 mm apart. Contact points are accurate to 1e-9 of an edge, times 1/R and
      // 1/h.
      EXPECT_LE(
        forceJump(sphere(0, isVaried), formOf(form, ContactSurface::Smooth), Depth, 100.0), 1e-8);
    }
  }
  const ContactSettings energy = formOf(ForceForm::EnergyConsistent, ContactSurface::Smooth);
  EXPECT_LE(forceJump(sphere(0, false), energy, Depth, 100.0), 1e-8);
  // If responses differ, Σ e_i ∇n_i jumps as the slopes of a piecewise linear e do: by h e″, where
  // e is 0.4 f δ times a factor whose second derivative is at most about 2/R².
  const double coarse = forceJump(sphere(0, true), energy, Depth, 100.0);
  const double fine = forceJump(sphere(1, true), energy, Depth, 100.0);
  EXPECT_LT(coarse, 4.0 * 0.4 * Depth * sphere(0, true).longestEdge * 2.0 / (Radius * Radius));
  EXPECT_GT(coarse, 1e-3);
  EXPECT_NEAR(coarse / fine, 2.0, 0.35);
}

TEST(Continuity, ClosedPathsWithEqualResponses)
{
  const double floor = 1e-6; // error of the quadrature with 4000 steps
  for (const ForceForm form : { ForceForm::Paper, ForceForm::NormalizedDirection })
  {
    // O(h²/(Rδ)), relative to force times path. The jumps on the path have both signs.
    const ContactSettings settings = formOf(form, ContactSurface::Facets);
    const double coarse = loopEnergy(sphere(0, false), settings, Depth, 8);
    const double fine = loopEnergy(sphere(1, false), settings, Depth, 8);
    const double h = sphere(0, false).longestEdge;
    EXPECT_LT(coarse, h * h / (Radius * Depth));
    EXPECT_GT(coarse, 1e-3);
    EXPECT_GT(coarse / fine, 3.0); // order 2 or better
  }
  EXPECT_LT(loopEnergy(sphere(0, false),
              formOf(ForceForm::EnergyConsistent, ContactSurface::Facets), Depth, 8),
    floor);
  for (const ForceForm form : { ForceForm::NormalizedDirection, ForceForm::EnergyConsistent })
  {
    EXPECT_LT(loopEnergy(sphere(0, false), formOf(form, ContactSurface::Smooth), Depth, 8), floor);
  }
  // Eq. 3 of Mahvash and Hayward loses energy also on the smooth surface, because its blended
  // normal is shorter than 1.
  const ContactSettings paper = formOf(ForceForm::Paper, ContactSurface::Smooth);
  const double coarse = loopEnergy(sphere(0, false), paper, Depth, 8);
  EXPECT_GT(coarse, 10.0 * floor);
  EXPECT_GT(coarse / loopEnergy(sphere(1, false), paper, Depth, 8), 3.0);
}

TEST(Continuity, ClosedPathsWithResponsesThatDiffer)
{
  // A press at one place and a release at another place gain e_k - e_j for any fineness of the
  // mesh.
  for (const ContactSurface surface : { ContactSurface::Facets, ContactSurface::Smooth })
  {
    for (const ForceForm form : { ForceForm::Paper, ForceForm::NormalizedDirection })
    {
      EXPECT_GT(loopEnergy(sphere(1, true), formOf(form, surface), Depth, 8), 3e-3);
    }
  }
  // The energy-consistent form gains energy only from jumps of the energy itself, from facet to
  // facet.
  const double facets = loopEnergy(
    sphere(1, true), formOf(ForceForm::EnergyConsistent, ContactSurface::Facets), Depth, 8);
  EXPECT_LT(facets, 1e-3);
  EXPECT_LT(loopEnergy(sphere(1, true), formOf(ForceForm::EnergyConsistent, ContactSurface::Smooth),
              Depth, 8),
    1e-6); // error of the quadrature
}

TEST(Continuity, ErrorAgainstTheSmoothSphere)
{
  for (std::size_t fineness = 0; fineness < 2; ++fineness)
  {
    const MeshedBody& body = sphere(fineness, false);
    const double h = body.longestEdge;
    for (const ForceForm form : allForms)
    {
      // A facet is up to h²/(6R) below the surface (h²/(8R) at its edges), which reduces the depth;
      // the force is δ^1.5. The triangles are longer than wide, so the reduction is smaller than
      // this.
      const ForceError facets = forceError(body, formOf(form, ContactSurface::Facets), Depth, 2000);
      const double sag = h * h / (6.0 * Radius);
      EXPECT_LT(facets.size, 1.5 * sag / Depth + h * h / (6.0 * Radius * Radius));
      EXPECT_GT(facets.size, 0.5 * sag / Depth);
    }
    for (const ForceForm form : { ForceForm::NormalizedDirection, ForceForm::EnergyConsistent })
    {
      // 0.005 h⁴/R³ (SmoothTriangle), with float32 coordinates and normals.
      const ForceError smooth = forceError(body, formOf(form, ContactSurface::Smooth), Depth, 2000);
      EXPECT_LT(smooth.size, 1.5 * 0.005 * std::pow(h, 4) / std::pow(Radius, 3) + 4e-6);
      EXPECT_LT(smooth.direction, 0.01 * std::pow(h / Radius, 3) + 1e-5);
    }
    // In eq. 3 of Mahvash and Hayward the blended normals reduce the force by h²/(6R²) on any
    // surface.
    const ForceError paper =
      forceError(body, formOf(ForceForm::Paper, ContactSurface::Smooth), Depth, 2000);
    EXPECT_LT(paper.size, 1.1 * h * h / (6.0 * Radius * Radius));
    EXPECT_GT(paper.size, 0.5 * h * h / (6.0 * Radius * Radius));
  }
}

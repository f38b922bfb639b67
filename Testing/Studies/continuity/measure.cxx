// SPDX-License-Identifier: BSD-3-Clause
// palpateContinuity prints the rows of the continuity study as CSV on the standard output. One row
// per body, mesh, force form and surface; columns in README.md. --quick: one mesh of each, short
// paths.
#include "ContinuityMeasures.h"
#include "Contact/ToolContact.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

namespace
{
using namespace palpate::testing;
using palpate::ContactSettings;
using palpate::ContactSurface;
using palpate::ForceForm;
using palpate::ToolContact;
using palpate::Vector3;

constexpr double Depth = 1.0; // mm

struct Case
{
  SmoothBody shape;
  MeshNormals normals;
  std::array<int, 3> cuts; ///< each refinement halves the width
};

std::vector<Case> cases()
{
  const SmoothBody ellipsoid = smoothEllipsoid({ 26.0, 20.0, 16.0 });
  return { { smoothSphere(20.0), MeshNormals::Exact, { 10, 20, 40 } },
    { ellipsoid, MeshNormals::Exact, { 10, 20, 40 } },
    { smoothBumpySphere(), MeshNormals::Exact, { 50, 100, 200 } },
    { smoothBumpySphere(), MeshNormals::AngleWeighted, { 50, 100, 200 } } };
}

/// Median time of a tick, ns, in batches of 100 along a path around the body, 0.1 mm per tick; the
/// best of five passes.
double tickTime(const MeshedBody& body, const ContactSettings& settings)
{
  constexpr std::size_t batch = 100;
  constexpr std::size_t batches = 100;
  std::vector<Vector3> tips;
  const Vector3 axis = Vector3(0.31, -0.47, 0.83).normalized();
  for (std::size_t i = 0; i < batch * batches; ++i)
  {
    const double angle = 0.1 / body.shape.meanRadius * static_cast<double>(i);
    const Vector3 turned = Eigen::AngleAxisd(angle, axis) * axis.unitOrthogonal();
    const Vector3 direction = Eigen::AngleAxisd(0.037 * angle, axis.unitOrthogonal()) * turned;
    tips.push_back(body.shape.point(direction) - Depth * body.shape.normal(direction));
  }
  double best = 1e300;
  double sum = 0.0; // keeps the compiler from removing the work
  for (int pass = 0; pass < 5; ++pass)
  {
    ToolContact contact(*body.contact, settings);
    std::vector<double> times;
    for (std::size_t first = 0; first < tips.size(); first += batch)
    {
      const auto start = std::chrono::steady_clock::now();
      for (std::size_t i = first; i < first + batch; ++i)
      {
        sum += contact.update(tips[i]).force.x();
      }
      const std::chrono::duration<double, std::nano> taken =
        std::chrono::steady_clock::now() - start;
      times.push_back(taken.count() / batch);
    }
    std::nth_element(times.begin(), times.begin() + batches / 2, times.end());
    best = std::min(best, times[batches / 2]);
  }
  return sum == 0.12345 ? 0.0 : best;
}

const char* nameOf(ForceForm form)
{
  switch (form)
  {
    case ForceForm::Paper:
      return "Paper";
    case ForceForm::NormalizedDirection:
      return "NormalizedDirection";
    default:
      return "EnergyConsistent";
  }
}

void measure(const Case& one, int cuts, bool isQuick)
{
  const MeshedBody equal(one.shape, cuts, uniform, one.normals);
  const MeshedBody differing(one.shape, cuts, varied, one.normals);
  const double length = isQuick ? 30.0 : 400.0;
  const int loops = isQuick ? 2 : 16;
  for (const ContactSurface surface : { ContactSurface::Facets, ContactSurface::Smooth })
  {
    for (const ForceForm form :
      { ForceForm::Paper, ForceForm::NormalizedDirection, ForceForm::EnergyConsistent })
    {
      ContactSettings settings;
      settings.form = form;
      settings.surface = surface;
      const ForceError error = forceError(equal, settings, Depth, isQuick ? 300 : 10000);
      std::printf("%s,%s,%zu,%.4f,%.4f,%.3f,%s,%s,%.3e,%.3e,%.3e,%.3e,%.3e,%.3e,%.0f,%.0f\n",
        one.shape.name.c_str(), one.normals == MeshNormals::Exact ? "exact" : "mesh",
        equal.contact->surface.triangleCount(), equal.meanEdge, equal.longestEdge,
        one.shape.smallestRadius, nameOf(form),
        surface == ContactSurface::Facets ? "Facets" : "Smooth",
        forceJump(equal, settings, Depth, length), forceJump(differing, settings, Depth, length),
        loopEnergy(equal, settings, Depth, loops), loopEnergy(differing, settings, Depth, loops),
        error.size, error.direction, tickTime(equal, settings), tickTime(differing, settings));
      std::fflush(stdout);
    }
  }
}
} // namespace

int main(int argc, char* argv[])
{
  const bool isQuick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  std::puts("body,normals,triangles,edge_mm,longest_edge_mm,smallest_radius_mm,form,surface,"
            "jump_equal,jump_differing,loop_equal,loop_differing,error_size,error_direction_rad,"
            "tick_equal_ns,tick_differing_ns");
  for (const Case& one : cases())
  {
    for (const int cuts : one.cuts)
    {
      if (!isQuick || cuts == one.cuts[0])
      {
        measure(one, cuts, isQuick);
      }
    }
  }
  return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
// Structural compliance at the centre of a circular plate clamped at its rim, b = 30, t = 4, ν =
// 0.3: C_g E* = 3.4516 /mm (a fine axisymmetric mesh, extrapolated; Kirchhoff's b²/(16πD) E*,
// without shear, is 3.3572). Also the deflection under the load.
#include "ElasticBlocks.h"
#include "FilterChecks.h"
#include "Solids/FiniteElements/PatchCompliance.h"

#include <cmath>

namespace
{
using namespace palpate;

constexpr double Radius = 30.0;
constexpr double Thickness = 4.0;
constexpr double Exact = 3.4516; // C_g E*, 1/mm

/// A plate of n × n × layers hexahedra; ellipses map the square to the disc.
ElasticBodyInput plate(int n, int layers)
{
  ElasticBodyInput input;
  input.mesh = palpate::testing::hexahedronBlock(n, n, layers, 1.0);
  for (Eigen::Index i = 0; i < input.mesh.nodes.cols(); ++i)
  {
    const Eigen::Vector3d x = input.mesh.nodes.col(i);
    const double u = 2.0 * x[0] / n - 1.0;
    const double v = 2.0 * x[1] / n - 1.0;
    input.mesh.nodes.col(i) << Radius * u * std::sqrt(1.0 - 0.5 * v * v),
      Radius * v * std::sqrt(1.0 - 0.5 * u * u), Thickness * x[2] / layers;
    input.fixed.push_back(std::abs(u) == 1.0 || std::abs(v) == 1.0 ? 7 : 0);
  }
  return input;
}

/// C_g E* at the centre of the top. `bottom` receives the deflection of the bottom below the
/// centre, times E*.
double atCentre(int n, int layers, double& bottom)
{
  const double modulus = 5.0;
  const double reduced = modulus / (1.0 - 0.3 * 0.3);
  ElasticBodyInput input = plate(n, layers);
  input.materials = { { modulus, 0.3 } };
  ElasticBody body;
  PALPATE_CHECK(body.assemble(std::move(input)).empty());
  PALPATE_CHECK(body.analyse(StiffnessFactor::Kind::Automatic).empty());
  PALPATE_CHECK(body.factorise().empty());
  const BodySurface& surface = body.surface();
  const std::int32_t top = palpate::testing::pointAt(surface, { 0.0, 0.0, Thickness });
  const PatchCompliances found = patchCompliances(body, { top }, 0.0, [](double) { return true; });
  PALPATE_CHECK(found.status[static_cast<std::size_t>(top)] == PatchStatus::Valid);
  const double scaled = found.compliance[static_cast<std::size_t>(top)] * reduced;

  const Eigen::Matrix3Xd moved = body.displacement(patchForces(body, top, 0.0));
  const std::int32_t below = palpate::testing::pointAt(surface, { 0.0, 0.0, 0.0 });
  bottom = -moved(2, surface.node(below)) * reduced;
  std::cout << n << " x " << n << " x " << layers << ": C_g E* " << scaled << " /mm, "
            << 100.0 * (scaled / Exact - 1.0) << " %; bottom " << bottom << std::endl;
  return scaled;
}
} // namespace

int TestElasticCompliancePlate(int, char*[])
{
  double bottom = 0.0;
  const double coarse = atCentre(30, 2, bottom);
  const double fine = atCentre(60, 4, bottom);
  PALPATE_CHECK_NEAR(fine, Exact, 0.02 * Exact); // required by the reference
  PALPATE_CHECK(std::abs(fine - Exact) < 0.5 * std::abs(coarse - Exact));
  // The local dent does not reach the bottom, so its deflection is bending and shear only, within 5
  // % of C_g.
  PALPATE_CHECK_NEAR(bottom, Exact, 0.05 * Exact);
  return palpate::testing::result();
}

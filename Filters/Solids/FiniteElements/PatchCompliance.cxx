// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/FiniteElements/PatchCompliance.h"

#include "Mechanics/Numerics/Constants.h"
#include "Solids/FiniteElements/ElasticElement.h"
#include "Solids/FiniteElements/NearestAlong.h"
#include "Solids/FiniteElements/PatchCut.h"
#include "Solids/FiniteElements/PatchSelfTerm.h"
#include "Solids/FiniteElements/PatchSite.h"
#include "Mechanics/SharedWork.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace palpate
{
namespace
{
/// Fractions of the progress after the patches and cut-outs, and after the self-terms.
constexpr double CutDone = 0.1;
constexpr double SelfTermsDone = 0.3;

/// Calls work(i) for i < count on threadCount() threads, in blocks. Calls the observer between the
/// blocks. Returns false if the observer stopped the work.
template <class Work>
bool forAll(std::size_t count, const WorkObserver& observer, double from, double to, Work&& work)
{
  constexpr std::size_t block = 512;
  for (std::size_t first = 0; first < count; first += block)
  {
    const std::size_t last = std::min(first + block, count);
    shareWork(last - first, [&](std::size_t i) { work(first + i); });
    if (!observer(from + (to - from) * static_cast<double>(last) / static_cast<double>(count)))
    {
      return false;
    }
  }
  return true;
}

/// Centres and sizes of a body's elements, used for the error of the energy beyond a cut.
class MissedEnergy
{
public:
  explicit MissedEnergy(const VolumeMesh& mesh);

  /// Returns the fraction of the difference (outer - inner) that is added to the self-term of the
  /// outer cut. It is 0 for quadratic elements.
  double fraction(const Eigen::Vector3d& point, const LocalPatch& patch) const;

private:
  double missedAt(const Eigen::Vector3d& point, std::size_t element) const;

  Eigen::Matrix3Xd Middles;
  std::vector<double> Weights; ///< V h², or 0 for quadratic elements
};

MissedEnergy::MissedEnergy(const VolumeMesh& mesh)
  : Middles(3, mesh.elementTotal())
  , Weights(mesh.elements.size(), 0.0)
{
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
  {
    const VolumeElement& element = mesh.elements[e];
    this->Middles.col(static_cast<Eigen::Index>(e)) = elementMiddle(mesh, element);
    if (element.kind != ElementKind::QuadraticTetrahedron)
    {
      const double volume = leastVolume(element.kind, elementNodes(mesh, element));
      this->Weights[e] = volume * std::pow(volume, 2.0 / 3.0);
    }
  }
}

double MissedEnergy::missedAt(const Eigen::Vector3d& point, std::size_t element) const
{
  const double square =
    (this->Middles.col(static_cast<Eigen::Index>(element)) - point).squaredNorm();
  return this->Weights[element] / (square * square * square);
}

double MissedEnergy::fraction(const Eigen::Vector3d& point, const LocalPatch& patch) const
{
  double inner = 0.0;
  double outer = 0.0;
  for (std::size_t i = 0; i < patch.elements.size(); ++i)
  {
    const double energy = this->missedAt(point, static_cast<std::size_t>(patch.elements[i]));
    outer += energy;
    inner += patch.inner[i] ? energy : 0.0;
  }
  double all = 0.0;
  for (std::size_t e = 0; e < this->Weights.size(); ++e)
  {
    all += this->missedAt(point, e);
  }
  const double between = outer - inner;
  return between > 1e-9 * outer ? std::max(all - outer, 0.0) / between : 0.0;
}

/// Intermediate data of one point: the two loads, and the key of the cut-out.
struct Site
{
  PatchStatus status = PatchStatus::Valid;
  std::array<PatchLoad, 2> loads;
  PatchKey key{};
  double missedFraction = 0.0;
};

bool isFixedAlong(const ElasticBody& body, std::int32_t node, const Eigen::Vector3d& direction)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (body.unknown(node, axis) < 0 && std::abs(direction[axis]) > 1e-6)
    {
      return true;
    }
  }
  return false;
}

void prepareSite(const ElasticBody& body, std::int32_t point, double radius, Site& site)
{
  const BodySurface& surface = body.surface();
  const Eigen::Vector3d& normal = surface.normal(point);
  if (normal.isZero() || !(surface.spacing(point) > 0.0))
  {
    site.status = PatchStatus::Degenerate;
    return;
  }
  site.loads = patchLoadsAt(body, point, radius);
  for (const PatchLoad& load : site.loads)
  {
    if (!load.complete)
    {
      site.status = PatchStatus::Edge;
      return;
    }
    for (const auto& entry : load.nodes)
    {
      if (isFixedAlong(body, entry.first, normal))
      {
        site.status = PatchStatus::OutOfReach;
        return;
      }
    }
  }
}

SparseLoad sparseLoad(
  const ElasticBody& body, const Eigen::Vector3d& normal, const PatchLoad& patch)
{
  SparseLoad load;
  for (const auto& [node, weight] : patch.nodes)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const int unknown = body.unknown(node, axis);
      if (unknown >= 0 && normal[axis] != 0.0)
      {
        load.emplace_back(unknown, -weight * normal[axis]);
      }
    }
  }
  return load;
}

using TermsByKey = std::map<PatchKey, SelfTerms>;

/// Computes the self-terms of all cut-outs. Equal cut-outs are computed only once.
bool findSelfTerms(const ElasticBody& body, const std::vector<std::int32_t>& points, double radius,
  std::vector<Site>& sites, const WorkObserver& observer, TermsByKey& terms)
{
  const MissedEnergy missed(body.mesh());
  if (!forAll(points.size(), observer, 0.0, CutDone,
        [&](std::size_t i)
        {
          Site& site = sites[i];
          prepareSite(body, points[i], radius, site);
          if (site.status == PatchStatus::Valid)
          {
            const LocalPatch patch = patchCutAt(body, points[i], radius, site.loads);
            site.key = patchKey(patch);
            site.missedFraction = missed.fraction(body.surface().position(points[i]), patch);
          }
        }))
  {
    return false;
  }
  std::vector<std::pair<std::size_t, SelfTerms*>>
    jobs; // the first site with a key represents all sites with this key
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    if (sites[i].status == PatchStatus::Valid)
    {
      const auto [at, isNew] = terms.try_emplace(sites[i].key);
      if (isNew)
      {
        jobs.emplace_back(i, &at->second);
      }
    }
  }
  return forAll(jobs.size(), observer, CutDone, SelfTermsDone,
    [&](std::size_t j)
    {
      const auto& [site, result] = jobs[j];
      *result = patchSelfTerms(patchCutAt(body, points[site], radius, sites[site].loads));
    });
}
} // namespace

PatchCompliances patchCompliances(const ElasticBody& body, const std::vector<std::int32_t>& points,
  double radius, const WorkObserver& observer)
{
  const BodySurface& surface = body.surface();
  const auto total = static_cast<std::size_t>(surface.pointTotal());
  std::vector<Site> sites(points.size());
  TermsByKey terms;
  if (!findSelfTerms(body, points, radius, sites, observer, terms))
  {
    return {};
  }
  std::vector<SparseLoad> loads(2 * points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (std::size_t k = 0; k < 2 && sites[i].status == PatchStatus::Valid; ++k)
    {
      loads[2 * i + k] = sparseLoad(body, surface.normal(points[i]), sites[i].loads[k]);
    }
  }
  const std::vector<double> whole = body.factor().compliances(loads,
    [&observer](double done) { return observer(SelfTermsDone + (1.0 - SelfTermsDone) * done); });
  if (whole.size() != loads.size())
  {
    return {};
  }

  PatchCompliances result;
  result.compliance.assign(total, NotANumber);
  result.status.assign(total, PatchStatus::Degenerate);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto point = static_cast<std::size_t>(points[i]);
    Site& site = sites[i];
    result.status[point] = site.status;
    if (site.status != PatchStatus::Valid)
    {
      continue;
    }
    const double modulus = body.materialAt(surface.node(points[i])).youngsModulus;
    const SelfTerms& cuts = terms.at(site.key);
    std::array<double, 2> structural{};
    for (std::size_t k = 0; k < 2; ++k)
    {
      const double self = cuts[1][k] + site.missedFraction * (cuts[1][k] - cuts[0][k]);
      structural[k] = whole[2 * i + k] - self / modulus;
    }
    result.compliance[point] = (4.0 * structural[0] - structural[1]) / 3.0;
    if (!std::isfinite(result.compliance[point]))
    {
      result.compliance[point] = NotANumber;
      result.status[point] = PatchStatus::Degenerate;
    }
  }
  return result;
}

Eigen::Matrix3Xd patchForces(const ElasticBody& body, std::int32_t point, double radius)
{
  const BodySurface& surface = body.surface();
  const Eigen::Vector3d inward = -surface.normal(point);
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, body.mesh().nodes.cols());
  const PatchLoad load =
    makePatchLoad(body.mesh(), surface, point, patchRadiusAt(body, point, radius));
  if (!load.complete)
  {
    forces.col(surface.node(point)) = inward;
    return forces;
  }
  for (const auto& [node, weight] : load.nodes)
  {
    forces.col(node) = weight * inward;
  }
  return forces;
}

void spreadValidCompliances(const BodySurface& surface, PatchCompliances& compliances)
{
  constexpr std::size_t wanted = 6;
  const auto isValid = [&compliances](std::int32_t point)
  { return compliances.status[static_cast<std::size_t>(point)] == PatchStatus::Valid; };
  for (std::int32_t point = 0; point < surface.pointTotal(); ++point)
  {
    if (isValid(point))
    {
      continue;
    }
    const std::vector<AlongSurface> around = nearestAlong(surface, point, wanted, isValid);
    const std::vector<double> weights = weightsAlong(around);
    double sum = around.empty() ? NotANumber : 0.0;
    for (std::size_t i = 0; i < around.size(); ++i)
    {
      sum += weights[i] * compliances.compliance[static_cast<std::size_t>(around[i].point)];
    }
    compliances.compliance[static_cast<std::size_t>(point)] = sum;
  }
}
} // namespace palpate

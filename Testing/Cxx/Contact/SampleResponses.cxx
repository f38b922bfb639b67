// SPDX-License-Identifier: BSD-3-Clause
#include "SampleResponses.h"

#include "Contact/ContactBody.h"

#include <cmath>
#include <random>

namespace palpate::testing
{
namespace
{
constexpr std::size_t Samples = 8;
}

ResponseStore::ResponseStore(std::size_t points)
  : range(points, 2.0F)
  , status(points, 0)
{
  for (std::size_t p = 0; p < points; ++p)
  {
    for (std::size_t i = 1; i <= Samples; ++i)
    {
      const double depth = 2.0 * static_cast<double>(i * i) / (Samples * Samples);
      this->force.push_back(static_cast<float>(10.0 * std::pow(depth, 1.5)));
      this->stiffness.push_back(static_cast<float>(15.0 * std::sqrt(depth)));
    }
    this->normal.insert(this->normal.end(), { 0.0F, 0.0F, 1.0F });
  }
}

void ResponseStore::normalsFromPoints(const Surface& body)
{
  for (std::size_t p = 0; p < body.points.size(); ++p)
  {
    const Vector3 unit = body.points[p].normalized();
    for (Eigen::Index k = 0; k < 3; ++k)
    {
      this->normal[3 * p + static_cast<std::size_t>(k)] = static_cast<float>(unit[k]);
    }
  }
}

void ResponseStore::randomizeCurves(unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> share(0.0F, 1.0F);
  for (std::size_t p = 0; p < this->range.size(); ++p)
  {
    this->range[p] = 1.0F + share(random);
    float sum = 0.0F;
    for (std::size_t i = 0; i < Samples; ++i)
    {
      sum += 0.05F + share(random);
      this->force[Samples * p + i] = sum;
      this->stiffness[Samples * p + i] = 0.5F + 8.0F * share(random);
    }
  }
}

void ResponseStore::randomize(unsigned seed)
{
  this->randomizeCurves(seed);
  std::mt19937 random(seed + 1000);
  std::normal_distribution<double> gauss;
  for (std::size_t p = 0; p < this->range.size(); ++p)
  {
    Vector3 unit;
    for (double& coordinate : unit)
    {
      coordinate = gauss(random);
    }
    unit.normalize();
    for (Eigen::Index k = 0; k < 3; ++k)
    {
      this->normal[3 * p + static_cast<std::size_t>(k)] = static_cast<float>(unit[k]);
    }
  }
}

ResponseArrays ResponseStore::arrays() const
{
  ResponseArrays arrays;
  arrays.points = this->range.size();
  arrays.samples = static_cast<int>(Samples);
  arrays.exponent = 1.5;
  arrays.force = this->force.data();
  arrays.stiffness = this->stiffness.data();
  arrays.normal = this->normal.data();
  arrays.range = this->range.data();
  arrays.status = this->status.data();
  arrays.edges = this->edges;
  return arrays;
}

ContractCurve ResponseStore::curveOf(std::size_t point) const
{
  ContractCurve curve{ 1.5, static_cast<double>(this->range[point]), {}, {} };
  for (std::size_t i = Samples * point; i < Samples * (point + 1); ++i)
  {
    curve.force.push_back(static_cast<double>(this->force[i]));
    curve.stiffness.push_back(static_cast<double>(this->stiffness[i]));
  }
  return curve;
}

Vector3 ResponseStore::normalOf(std::size_t point) const
{
  return Eigen::Map<const Eigen::Vector3f>(this->normal.data() + 3 * point).cast<double>();
}

std::unique_ptr<ContactBody> contactBody(const Surface& surface, const ResponseArrays& responses)
{
  return std::make_unique<ContactBody>(
    surface.points.empty() ? nullptr : surface.points.front().data(), surface.points.size(),
    surface.triangles.empty() ? nullptr : surface.triangles.front().data(),
    surface.triangles.size(), responses);
}

std::unique_ptr<ContactBody> contactBody(const Surface& surface, const ResponseStore& store)
{
  return contactBody(surface, store.arrays());
}

void takeMeshNormals(ResponseStore& store, const Surface& surface)
{
  const BodyMesh mesh = surface.mesh();
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    const Vector3 unit = mesh.pointNormal(static_cast<std::int32_t>(p));
    for (Eigen::Index k = 0; k < 3; ++k)
    {
      store.normal[3 * p + static_cast<std::size_t>(k)] = static_cast<float>(unit[k]);
    }
  }
}

std::vector<ContactSettings> allFormsAndSurfaces()
{
  std::vector<ContactSettings> all;
  for (const ContactSurface surface : { ContactSurface::Facets, ContactSurface::Smooth })
  {
    for (const ForceForm form :
      { ForceForm::Paper, ForceForm::NormalizedDirection, ForceForm::EnergyConsistent })
    {
      all.push_back({ form, surface, {} });
    }
  }
  return all;
}

EdgeTerms sphereOverEdges()
{
  EdgeTerms terms;
  terms.exponent = 1.5;
  terms.radius = std::sqrt(5.0);
  terms.poissonRatio = 0.45;
  return terms;
}

std::unique_ptr<ContactBody> uniformBody(const Surface& surface, const EdgeTerms& edges)
{
  ResponseStore store(surface.points.size());
  store.edges = edges;
  takeMeshNormals(store, surface);
  return contactBody(surface, store);
}
} // namespace palpate::testing

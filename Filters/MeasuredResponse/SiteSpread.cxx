// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredResponse/SiteSpread.h"

#include "Laws/SurfacePatch.h"

#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkShepardKernel.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
/// Largest ratio of arc to chord in a patch whose normals differ by at most 60°: (π/6)/sin(π/6).
constexpr double ArcPerChord = 1.0472;
} // namespace

SiteSpread::SiteSpread(const BodyMesh& mesh, const std::vector<SiteAnchor>& sites, double reach)
{
  struct Share
  {
    std::int32_t point;
    std::int32_t site;
  };
  std::vector<Share> shares;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (std::size_t s = 0; s < sites.size(); ++s)
  {
    const SiteAnchor& site = sites[s];
    points->InsertNextPoint(site.point.data());
    visitSurfacePatch(mesh, site.triangle, site.point, site.normal, ArcPerChord * reach,
      [&](std::int32_t point, double, const Vector3&, const Vector3&)
      {
        if ((mesh.point(point) - site.point).norm() < reach)
        {
          shares.push_back({ point, static_cast<std::int32_t>(s) });
        }
      });
  }
  // A stable sort keeps the sites of each point in their order.
  std::stable_sort(
    shares.begin(), shares.end(), [](const Share& a, const Share& b) { return a.point < b.point; });

  vtkNew<vtkPolyData> sources;
  sources->SetPoints(points);
  vtkNew<vtkShepardKernel> kernel;
  kernel->Initialize(nullptr, sources, sources->GetPointData());
  vtkNew<vtkIdList> ids;
  vtkNew<vtkDoubleArray> fading;
  vtkNew<vtkDoubleArray> weights;
  this->Start.reserve(mesh.pointCount() + 1);
  this->Start.push_back(0);
  std::size_t next = 0;
  for (std::size_t p = 0; p < mesh.pointCount(); ++p)
  {
    ids->Reset();
    fading->Reset();
    Vector3 x = mesh.point(static_cast<std::int32_t>(p));
    for (; next < shares.size() && shares[next].point == static_cast<std::int32_t>(p); ++next)
    {
      const auto site = static_cast<std::size_t>(shares[next].site);
      const double left = 1.0 - (x - sites[site].point).norm() / reach;
      ids->InsertNextId(shares[next].site);
      fading->InsertNextValue(left * left);
    }
    if (ids->GetNumberOfIds() > 0)
    {
      const vtkIdType count = kernel->ComputeWeights(x.data(), ids, fading, weights);
      for (vtkIdType i = 0; i < count; ++i)
      {
        this->Site.push_back(static_cast<std::int32_t>(ids->GetId(i)));
        this->Weight.push_back(weights->GetValue(i));
      }
    }
    this->Start.push_back(this->Site.size());
  }
}

double SiteSpread::at(std::int32_t point, const std::vector<double>& values) const
{
  double sum = 0.0;
  for (std::size_t i = this->Start[static_cast<std::size_t>(point)];
       i < this->Start[static_cast<std::size_t>(point) + 1]; ++i)
  {
    sum += this->Weight[i] * values[static_cast<std::size_t>(this->Site[i])];
  }
  return sum;
}

double SiteSpread::deviationAt(std::int32_t point, const std::vector<double>& values) const
{
  const double mean = this->at(point, values);
  double sum = 0.0;
  for (std::size_t i = this->Start[static_cast<std::size_t>(point)];
       i < this->Start[static_cast<std::size_t>(point) + 1]; ++i)
  {
    const double off = values[static_cast<std::size_t>(this->Site[i])] - mean;
    sum += this->Weight[i] * off * off;
  }
  return std::sqrt(sum);
}
} // namespace palpate

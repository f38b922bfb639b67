// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/SurfaceYield.h"

#include "Mechanics/ReducedModulus.h"
#include "Mechanics/SharedWork.h"
#include "SolidResponse/Bodies/LargeTriangles.h"
#include "Solids/TrueShape/KernelError.h"
#include "Solids/TrueShape/LandmarkKernels.h"
#include "Solids/TrueShape/MeshDifference.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
/// Means of (r/a)^{2m}, weighted by the pressure of a sphere and of a flat end.
const Eigen::Vector4d UnderSphere(1.0, 2.0 / 5.0, 8.0 / 35.0, 16.0 / 105.0);
const Eigen::Vector4d UnderFlat(1.0, 2.0 / 3.0, 8.0 / 15.0, 16.0 / 35.0);

/// Smallest compliance, as a fraction of the compliance of a contact on a half-space. A smaller
/// value means that the contact reaches the held part, where the series of the kernel does not
/// converge.
constexpr double LeastCompliance = -0.4;

/// Error of the force if C(a) is used for all radii r < a, although C(r) = C₀ + β r². The constant
/// is the ratio of the largest error at r < a to the error that the difference C(a) - C₀ would
/// cause at a.
constexpr double OfGrowth = 2.0 / 3.0;

/// Compliance C at one position.
class PlaceYield
{
public:
  PlaceYield(const ContactKernels& kernels, double radius)
    : Kernels(kernels)
    , Radius(radius)
    , Kernel(kernels.at(radius))
  {
  }

  bool isKnown() const { return this->Kernel.order > 0; }
  double compliance() const { return under(UnderSphere, this->Kernel); }
  double error() const
  {
    const double here = this->compliance();
    const double shape = std::abs(under(UnderFlat, this->Kernel) - here);
    const double growth = OfGrowth * std::abs(here - this->Kernel.coefficients(0, 0));
    return std::sqrt(std::pow(meshError(this->Kernel, this->Kernels.site(), this->Radius), 2) +
      std::pow(this->truncation(), 2) + std::pow(std::max(shape, growth), 2));
  }

private:
  static double under(const Eigen::Vector4d& pressure, const ContactKernel& kernel)
  {
    return pressure.dot(kernel.coefficients * pressure);
  }
  double truncation() const
  {
    if (this->Kernel.order == 1)
    {
      return missedByOne(this->Kernel, this->Kernels.site(), this->Radius);
    }
    const ContactKernel coarser = this->Kernels.at(this->Radius, this->Kernel.order - 1);
    return std::abs(under(UnderSphere, coarser) - this->compliance());
  }

  const ContactKernels& Kernels;
  double Radius;
  ContactKernel Kernel;
};
} // namespace

YieldField::YieldField(
  vtkPolyData* solid, const LandmarkKernels& landmarks, const MeshDifference* meshes)
  : Landmarks(landmarks)
  , Near(solid, landmarks)
  , Meshes(meshes)
  , Modulus(reducedModulus(landmarks.material(0).youngsModulus, landmarks.material(0).poissonRatio))
{
}

double YieldField::ofHalfSpace(double radius) const
{
  return 1.0 / (2.0 * this->Modulus * radius);
}

SpotYield YieldField::at(const Eigen::Vector3d& place, const Eigen::Vector3d& normal,
  const std::vector<double>& radii) const
{
  SurfaceSpot spot;
  spot.place = place;
  spot.normal = normal;
  BlendedKernels kernels(this->Landmarks, spot, this->Near.around(place.data(), normal));
  if (this->Meshes)
  {
    kernels.setMissed(this->Meshes->at(place, normal));
  }
  SpotYield made;
  made.status = static_cast<unsigned char>(kernels.site().status);
  for (const double radius : radii)
  {
    const PlaceYield yield(kernels, radius);
    const double found = yield.isKnown() ? yield.compliance() : 0.0;
    const double taken = std::max(found, LeastCompliance * this->ofHalfSpace(radius));
    made.compliance.push_back(taken);
    made.error.push_back(
      yield.isKnown() ? std::max(yield.error(), taken - found) : this->ofHalfSpace(radius));
  }
  return made;
}

SurfaceYield yieldOf(vtkPolyData* surface, const float* normals, const YieldField& field,
  const std::vector<double>& radii)
{
  const auto count = static_cast<std::size_t>(surface->GetNumberOfPoints());
  SurfaceYield made;
  made.compliance.resize(count * radii.size());
  made.error.resize(count * radii.size());
  made.status.resize(count);
  shareWork(count,
    [&](std::size_t i)
    {
      Eigen::Vector3d place;
      surface->GetPoint(static_cast<vtkIdType>(i), place.data());
      const SpotYield here =
        field.at(place, Eigen::Map<const Eigen::Vector3f>(normals + 3 * i).cast<double>(), radii);
      made.status[i] = here.status;
      for (std::size_t k = 0; k < radii.size(); ++k)
      {
        made.compliance[k * count + i] = here.compliance[k];
        made.error[k * count + i] = here.error[k];
      }
    });
  includeLargeTriangles(surface, field, radii, made);
  return made;
}
} // namespace palpate

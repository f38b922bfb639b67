// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/SurfaceYield.h"

#include "Mechanics/ReducedModulus.h"
#include "Mechanics/SharedWork.h"
#include "SolidResponse/Bodies/NearLandmarks.h"
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
/// Means of (r/a)^{2m} over the pressure of a sphere and of a flat end.
const Eigen::Vector4d UnderSphere(1.0, 2.0 / 5.0, 8.0 / 35.0, 16.0 / 105.0);
const Eigen::Vector4d UnderFlat(1.0, 2.0 / 3.0, 8.0 / 15.0, 16.0 / 35.0);

/// The least compliance over that of a contact on a half-space. A smaller one means that the
/// contact meets the held part, where no series holds.
constexpr double LeastCompliance = -0.4;

/// C(r) = C₀ + β r² instead of C(a): the largest error of the force at r < a, compared with the
/// error at a of the same change.
constexpr double OfGrowth = 2.0 / 3.0;

/// C of one place.
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

SurfaceYield yieldOf(vtkPolyData* surface, const float* normals, vtkPolyData* solid,
  const LandmarkKernels& landmarks, const MeshDifference* meshes, const std::vector<double>& radii)
{
  const NearLandmarks near(solid, landmarks);
  const auto count = static_cast<std::size_t>(surface->GetNumberOfPoints());
  const ElasticMaterial& material = landmarks.material(0);
  const double modulus = reducedModulus(material.youngsModulus, material.poissonRatio);
  const auto ofHalfSpace = [modulus](double radius) { return 1.0 / (2.0 * modulus * radius); };
  SurfaceYield made;
  made.compliance.assign(count * radii.size(), 0.0);
  for (const double radius : radii)
  {
    made.error.insert(made.error.end(), count, ofHalfSpace(radius));
  }
  made.status.assign(count, static_cast<unsigned char>(PatchStatus::OutOfReach));
  shareWork(count,
    [&](std::size_t i)
    {
      SurfaceSpot spot;
      surface->GetPoint(static_cast<vtkIdType>(i), spot.place.data());
      spot.normal = Eigen::Map<const Eigen::Vector3f>(normals + 3 * i).cast<double>();
      BlendedKernels kernels(landmarks, spot, near.around(spot.place.data(), spot.normal));
      if (meshes)
      {
        kernels.setMissed(meshes->at(spot.place, spot.normal));
      }
      made.status[i] = static_cast<unsigned char>(kernels.site().status);
      for (std::size_t k = 0; k < radii.size(); ++k)
      {
        const PlaceYield yield(kernels, radii[k]);
        if (yield.isKnown())
        {
          const double found = yield.compliance();
          const double taken = std::max(found, LeastCompliance * ofHalfSpace(radii[k]));
          made.compliance[k * count + i] = taken;
          made.error[k * count + i] = std::max(yield.error(), taken - found);
        }
      }
    });
  return made;
}
} // namespace palpate

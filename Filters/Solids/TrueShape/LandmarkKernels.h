// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LandmarkKernels_h
#define palpate_LandmarkKernels_h

#include "Solids/TrueShape/ContactKernels.h"

#include <utility>
#include <vector>

namespace palpate
{
/**
 * The kernels of a body at its landmarks, the sources of its H, for contacts at any place between
 * landmarks, for example on a surface that is finer than the elements. They are valid for any tool.
 *
 * The kernels are fitted once (ContactKernelFit), at radii that increase by a factor of about 5/4.
 * Between radii and between landmarks they are interpolated linearly.
 */
class PALPATE_EXPORT LandmarkKernels
{
public:
  /// `green` must be solved and must outlive this object. isComplete() is false if the observer
  /// stopped the work.
  explicit LandmarkKernels(const RegularGreen& green, const WorkObserver& observer = {});
  bool isComplete() const { return this->Complete; }

  /// The surface points that are landmarks, ascending.
  const std::vector<std::int32_t>& points() const { return this->Points; }
  const RegularGreen& green() const { return this->Green; }
  /// Contact radii of the fits, ascending, mm.
  const std::vector<double>& radii() const { return this->Radii; }
  /// Material of the body at landmark i of points().
  const ElasticMaterial& material(std::size_t i) const { return this->Landmarks[i].site.material; }

private:
  friend class BlendedKernels;

  /// The kernels at one radius: that of the largest order, and that of one order less.
  struct Entry
  {
    Eigen::Matrix4d full = Eigen::Matrix4d::Zero();
    Eigen::Matrix4d coarse = Eigen::Matrix4d::Zero();
    /// Tilt of the kernel, along the axes of the body.
    Eigen::Vector3d tilt = Eigen::Vector3d::Zero();
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();       ///< ContactKernel::normal of `full`
    Eigen::Vector3d coarseNormal = Eigen::Vector3d::Zero(); ///< ContactKernel::normal of `coarse`
    int order = 0;
  };
  struct Landmark
  {
    KernelSite site;
    std::vector<Entry> entries; ///< one per radius of Radii
  };

  const RegularGreen& Green;
  std::vector<double> Radii; ///< ascending, mm
  std::vector<std::int32_t> Points;
  std::vector<Landmark> Landmarks; ///< one per point of Points
  bool Complete = false;
};

/// The surface at a place of contact.
struct SurfaceSpot
{
  Eigen::Vector3d place;  ///< mm
  Eigen::Vector3d normal; ///< outward, unit
  SurfaceGap gap;
};

/**
 * Kernels at a place between landmarks. The values at the landmarks are fitted by a linear function
 * of the position in the tangent plane, by least squares weighted by the inverse square of the
 * distance. The residual of the fit is the kernel's `spread`. If the landmarks are on a line, or
 * all on one side, their mean is used. First the c₀₀ of each landmark is converted from its own
 * normal to the normal of the place (DirectedCompliance). The drop of the surface is that of the
 * spot's gap. The distance to the held part is that of HeldRim, because there may be no landmark
 * near the edge of that part.
 */
class PALPATE_EXPORT BlendedKernels : public ContactKernels
{
public:
  /// `around`: indices in LandmarkKernels::points(), nearest first. Landmarks whose material
  /// differs from that of the first one are left out. Without any landmark the site is out of
  /// reach.
  BlendedKernels(const LandmarkKernels& landmarks, const SurfaceSpot& spot,
    const std::vector<std::size_t>& around);

  /// `largestOrder`: the known order or more gives the full kernel; any smaller value gives the
  /// kernel of one order less.
  ContactKernel at(double radius, int largestOrder = ContactKernel::LargestOrder) const override;
  const SurfaceGap* surface() const override
  {
    return this->Gap.reach() > 0.0 ? &this->Gap : nullptr;
  }

private:
  /// Weights that combine the values at the landmarks to a value at the place.
  struct Weights
  {
    Eigen::VectorXd near;       ///< weights by distance alone, with sum 1
    Eigen::Matrix3Xd plane;     ///< value at the place and slopes, per value at a landmark
    Eigen::Matrix2Xd positions; ///< positions of the landmarks, relative to the place, mm
  };
  struct Blend
  {
    LandmarkKernels::Entry entry;
    double spread = 0.0;
  };

  static Weights weigh(const LandmarkKernels& landmarks, const SurfaceSpot& spot,
    const std::vector<std::size_t>& around);
  void blendSites(const LandmarkKernels& landmarks, const SurfaceSpot& spot, const Weights& w,
    const std::vector<std::size_t>& around);
  void blendKernels(const LandmarkKernels& landmarks, const Weights& w,
    const std::vector<std::size_t>& around, const Eigen::Vector3d& normal);

  const std::vector<double>* Radii = nullptr; ///< contact radii of the kernels
  std::vector<Blend> Blends;                  ///< one per radius
  SurfaceGap Gap;
  Eigen::Matrix<double, 3, 2> Tangents;
};
} // namespace palpate

#endif

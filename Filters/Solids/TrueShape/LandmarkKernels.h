// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LandmarkKernels_h
#define palpate_LandmarkKernels_h

#include "Solids/TrueShape/ContactKernels.h"

#include <utility>
#include <vector>

namespace palpate
{
/**
 * The kernels of a body at its landmarks, which are the sources of its H. They are used for
 * contacts at any position between landmarks, for example on a surface that is finer than the
 * elements. The kernels are valid for any tool.
 *
 * The kernels are fitted once (ContactKernelFit), at contact radii that increase by a factor of
 * about 5/4. Between the radii and between the landmarks, they are interpolated linearly.
 */
class PALPATE_EXPORT LandmarkKernels
{
public:
  /// `green` must be solved and must outlive this object. isComplete() is false if the observer
  /// stopped the work.
  explicit LandmarkKernels(const RegularGreen& green, const WorkObserver& observer = {});
  bool isComplete() const { return this->Complete; }

  /// Returns the surface points that are landmarks, in ascending order.
  const std::vector<std::int32_t>& points() const { return this->Points; }
  const RegularGreen& green() const { return this->Green; }
  /// Returns the contact radii of the fits in ascending order, mm.
  const std::vector<double>& radii() const { return this->Radii; }
  /// Returns the material of the body at landmark i of points().
  const ElasticMaterial& material(std::size_t i) const { return this->Landmarks[i].site.material; }

private:
  friend class BlendedKernels;

  /// The kernels at one radius: `full` with the largest order, and `coarse` with one order less.
  struct Entry
  {
    Eigen::Matrix4d full = Eigen::Matrix4d::Zero();
    Eigen::Matrix4d coarse = Eigen::Matrix4d::Zero();
    /// Tilt of the kernel, in components along the axes of the body.
    Eigen::Vector3d tilt = Eigen::Vector3d::Zero();
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();       ///< ContactKernel::normal of `full`
    Eigen::Vector3d coarseNormal = Eigen::Vector3d::Zero(); ///< ContactKernel::normal of `coarse`
    int order = 0;
  };
  struct Landmark
  {
    KernelSite site;
    std::vector<Entry> entries; ///< kernels of the landmark, one entry per radius of Radii
  };

  const RegularGreen& Green;
  std::vector<double> Radii; ///< contact radii of the kernels in ascending order, mm
  std::vector<std::int32_t> Points;
  std::vector<Landmark> Landmarks; ///< one landmark per point of Points
  bool Complete = false;
};

/// The surface at the position of a contact.
struct SurfaceSpot
{
  Eigen::Vector3d place;  ///< position, mm
  Eigen::Vector3d normal; ///< outward unit normal
  SurfaceGap gap;
};

/**
 * Kernels at a position between landmarks. A linear function of the position in the tangent plane
 * is fitted to the values at the landmarks, by least squares with weights of 1/distance². The
 * residual of the fit is the kernel's `spread`. If the landmarks are on a line, or all on one side
 * of the position, their mean is used. Before the fit, the c₀₀ of each landmark is converted from
 * the normal of the landmark to the normal at the position (DirectedCompliance). The drop of the
 * surface is that of the spot's gap. The distance to the held part is that of HeldRim, because
 * there may be no landmark near the edge of the held part.
 */
class PALPATE_EXPORT BlendedKernels : public ContactKernels
{
public:
  /// `around` contains indices in LandmarkKernels::points(), nearest first. Landmarks whose
  /// material differs from that of the first landmark are left out. Without any landmark, the
  /// status of the site is OutOfReach.
  BlendedKernels(const LandmarkKernels& landmarks, const SurfaceSpot& spot,
    const std::vector<std::size_t>& around);

  /// Returns the full kernel if `largestOrder` is at least the known order. For any smaller value,
  /// returns the kernel of one order less.
  ContactKernel at(double radius, int largestOrder = ContactKernel::LargestOrder) const override;
  const SurfaceGap* surface() const override
  {
    return this->Gap.reach() > 0.0 ? &this->Gap : nullptr;
  }

private:
  /// Weights that combine the values at the landmarks to a value at the position.
  struct Weights
  {
    Eigen::VectorXd near;   ///< weights that depend only on the distance, with sum 1
    Eigen::Matrix3Xd plane; ///< value and slopes at the position, per value at a landmark
    /// Positions of the landmarks relative to the position of the kernels, mm.
    Eigen::Matrix2Xd positions;
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

  const std::vector<double>* Radii = nullptr; ///< contact radii of the kernels, mm
  std::vector<Blend> Blends;                  ///< blended kernels, one per radius of Radii
  SurfaceGap Gap;
  Eigen::Matrix<double, 3, 2> Tangents;
};
} // namespace palpate

#endif

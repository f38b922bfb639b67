// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LandmarkKernels_h
#define palpate_LandmarkKernels_h

#include "Solids/TrueShape/ContactKernels.h"

#include <utility>
#include <vector>

namespace palpate
{
/**
 * The kernels of a body at the sources of its H, its landmarks, for contacts at any place between
 * them: on a surface that is finer than the elements. They hold for any tool.
 *
 * Fitted once (ContactKernelFit) at radii that follow each other by a quarter; in between, and
 * between landmarks, linear.
 */
class PALPATE_EXPORT LandmarkKernels
{
public:
  /// Of a body that has been solved for. Complete unless the observer stopped it; it must stay.
  explicit LandmarkKernels(const RegularGreen& green, const WorkObserver& observer = {});
  bool isComplete() const { return this->Complete; }

  /// The surface points that are landmarks, ascending.
  const std::vector<std::int32_t>& points() const { return this->Points; }
  const RegularGreen& green() const { return this->Green; }
  /// Contact radii that were fitted, ascending, mm.
  const std::vector<double>& radii() const { return this->Radii; }
  /// Of the body at the landmark in a place of points().
  const ElasticMaterial& material(std::size_t i) const { return this->Landmarks[i].site.material; }

private:
  friend class BlendedKernels;

  /// At one radius: of the largest order, and of one less.
  struct Entry
  {
    Eigen::Matrix4d full = Eigen::Matrix4d::Zero();
    Eigen::Matrix4d coarse = Eigen::Matrix4d::Zero();
    Eigen::Vector3d tilt = Eigen::Vector3d::Zero();   ///< of the kernel, along the axes of the body
    Eigen::Vector3d normal = Eigen::Vector3d::Zero(); ///< ContactKernel::normal of `full`
    Eigen::Vector3d coarseNormal = Eigen::Vector3d::Zero(); ///< and of `coarse`
    int order = 0;
  };
  struct Landmark
  {
    KernelSite site;
    std::vector<Entry> entries; ///< beside Radii
  };

  const RegularGreen& Green;
  std::vector<double> Radii; ///< ascending, mm
  std::vector<std::int32_t> Points;
  std::vector<Landmark> Landmarks; ///< beside Points
  bool Complete = false;
};

/// The surface at a place, as a contact there sees it.
struct SurfaceSpot
{
  Eigen::Vector3d place;  ///< mm
  Eigen::Vector3d normal; ///< outward, unit
  SurfaceGap gap;
};

/**
 * Kernels at a place between landmarks: the plane through their values in the tangent plane, by
 * least squares, each by its inverse square distance; what that leaves is the kernel's `spread`.
 * Where they lie on a line, or all to one side, their mean. c₀₀ of each is first turned from its
 * normal to that of the place (DirectedCompliance). The surface falls off as the spot's gap says,
 * and what is held of it begins where it does (HeldRim), which landmarks may not tell.
 */
class PALPATE_EXPORT BlendedKernels : public ContactKernels
{
public:
  /// `around`: places in LandmarkKernels::points(), nearest first; those of another material than
  /// the first are left out. Without any the site is out of reach.
  BlendedKernels(const LandmarkKernels& landmarks, const SurfaceSpot& spot,
    const std::vector<std::size_t>& around);

  /// `largestOrder`: as it is known, or anything below for one less.
  ContactKernel at(double radius, int largestOrder = ContactKernel::LargestOrder) const override;
  const SurfaceGap* surface() const override
  {
    return this->Gap.reach() > 0.0 ? &this->Gap : nullptr;
  }

private:
  /// How values at the landmarks become one at the place.
  struct Weights
  {
    Eigen::VectorXd near;       ///< by distance alone, sum 1
    Eigen::Matrix3Xd plane;     ///< value at the place, and slopes, by the landmarks' values
    Eigen::Matrix2Xd positions; ///< of the landmarks, from the place, mm
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

  const std::vector<double>* Radii = nullptr; ///< the landmarks'
  std::vector<Blend> Blends;                  ///< beside them
  SurfaceGap Gap;
  Eigen::Matrix<double, 3, 2> Tangents;
};
} // namespace palpate

#endif

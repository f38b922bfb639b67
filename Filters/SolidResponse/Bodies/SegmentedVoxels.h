// SPDX-License-Identifier: BSD-3-Clause
#ifndef SegmentedVoxels_h
#define SegmentedVoxels_h

#include "Response/Bodies/SkinScan.h"
#include "Solids/FiniteElements/ElasticElement.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkDataArray;

namespace palpate
{
/// The material of the voxels with one label.
struct Tissue
{
  double label = 0.0;
  ElasticMaterial material;
};

/// A region of one tissue that is enclosed by other tissues. Lengths are in mm.
struct EnclosedRegion
{
  Eigen::Vector3d middle;
  double radius = 0.0; ///< radius of the ball around `middle` that contains the voxels
  double depth = 0.0;  ///< smallest distance of the region from the outside of the body
};

/**
 * The voxels of a labelled image that belong to a body, each with the number of its tissue. All
 * other voxels are empty. The object stores only the bounding box of the tissues with a margin of
 * two empty voxels. The margin closes the body where the image ends. Voxels are connected through
 * faces.
 */
class SegmentedVoxels
{
public:
  /// Takes the voxels of the tissues. Returns "", or an error message that names a label that is
  /// not in the image.
  std::string take(vtkImageData* image, vtkDataArray* values, const std::vector<Tissue>& tissues);

  /// Empties the voxels that are not connected to the largest region of tissue. Returns the emptied
  /// fraction of the voxels of tissue.
  double keepLargestRegion();
  /// Fills empty regions inside the body that are smaller than `volume` (mm³) with the tissues
  /// around them. Returns the number of filled regions.
  std::size_t fillCavities(double volume);

  /// Returns the volume of the tissues, mm³.
  double volume() const;
  /// Returns the area of the outer surface of the tissues, mm², corrected for the steps of the
  /// voxels. It is two thirds of the area of the voxels' faces, because two thirds is the mean
  /// ratio over all orientations of a plane.
  double area() const;
  /// Returns the smallest side length of a voxel, mm.
  double smallestSide() const;

  /// Returns the regions of at least eight voxels that are enclosed by other tissues, the largest
  /// first.
  std::vector<EnclosedRegion> findEnclosedRegions() const;

  /// Returns a mask that is 1 in tissue and 0 in empty voxels.
  SkinScan mask() const;
  /// Returns the box as an image. Its point scalars (short) are the numbers of the tissues. Empty
  /// voxels get the number of the nearest tissue.
  vtkSmartPointer<vtkImageData> spreadTissues() const;

private:
  static constexpr std::int16_t Empty = -1;

  template <class Use>
  void visitNeighbours(std::size_t voxel, const Use& use) const;
  template <class Belongs>
  std::vector<std::size_t> takeRegion(
    std::size_t seed, std::vector<char>& isTaken, const Belongs& belongs) const;
  bool touchesEmpty(std::size_t voxel) const;
  std::vector<std::int16_t> nearestTissues() const;
  Eigen::Vector3d placeOf(std::size_t voxel) const;

  vtkSmartPointer<vtkImageData> Box; ///< position and extent of the voxels, without arrays
  std::array<std::size_t, 3> Size{};
  std::array<double, 3> Spacing{};
  std::vector<std::int16_t> Numbers; ///< empty, or the number of the tissue; x varies fastest
};
} // namespace palpate

#endif

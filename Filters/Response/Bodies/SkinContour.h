// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SkinContour_h
#define palpate_SkinContour_h

#include "Response/Bodies/SkinScan.h"
#include "Response/FilterStage.h"
#include "palpateResponseModule.h" // For export macro

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

class vtkImageData;

namespace palpate
{
/// Settings of the contour and of its smoothing.
struct SkinContour
{
  float value = 0.0F;  ///< grey level of the contour
  float tissue = 0.0F; ///< a typical grey level of tissue, above `value`
  /// Spacing of the contoured lattice, mm. 0 selects the spacing of the scan.
  double resolution = 0.0;
  /// Number of iterations of the smoothing that removes the traces of voxels; 0 disables the
  /// smoothing.
  int iterations = 20;
  bool isLargest = true; ///< whether only the largest region is kept
};

/// Returns the contour with outward normals, in the coordinates of `placed`. The extent of `placed`
/// has the size of the scan. Grey values of the scan that are close to the value of the contour are
/// moved away from this value. Returns a surface without cells if there is no contour, and null if
/// the stage was aborted.
PALPATERESPONSE_EXPORT vtkSmartPointer<vtkPolyData> contourSkin(
  SkinScan& scan, const SkinContour& wanted, vtkImageData* placed, const FilterStage& stage);
} // namespace palpate

#endif

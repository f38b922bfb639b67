// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLayerThickness
 * @brief thickness of the soft tissue over the bone at each point, from a scan
 *
 * Port 0: the body, a vtkPolyData of triangles in mm, such as the output of vtkSkinSurface. The
 * active point normals of the body must point outward. If it has none, angle-weighted normals are
 * computed. Port 1: the scan, a three-dimensional vtkImageData in the same coordinates, with
 * one-component scalars that are bright in soft tissue and dark in the base. Input array 0 to
 * process selects the scalars; the default is the active scalars.
 *
 * Output: the body with two point arrays. All other data pass through.
 * - `LayerThickness` (float, mm): 0 where no base was found. Use it as the array to process 1 of
 *   vtkToolContactResponse, where 0 means a half-space.
 * - `LayerThicknessError` (float, 1/mm, > 0): the error of 1/LayerThickness, where 1/LayerThickness
 *   of a half-space is 0. vtkToolContactResponse finds the array by its name, and adds the change
 *   of the force due to this error to the stated error of the force.
 *
 * The steps: (1) From each point a ray goes inward along the normal to MaximumDepth. The scan is
 * sampled along the ray at intervals of a quarter of the smallest spacing, with trilinear
 * interpolation. (2) The base is the first run of values below BaseValue that is at least a voxel
 * long and whose darkest value is at most half as bright as the tissue above it. The base begins
 * where the grey level falls through the mean of the brightest and the darkest value within
 * EdgeWidth. (3) A base is rejected if the surface within EdgeWidth of the base has the opposite
 * orientation, because the ray has then left the body, for example through an ear. (4) The median
 * is taken over the points within SmoothingRadius whose normals differ by less than 60° from that
 * of the point. A point without base counts as infinitely deep. Therefore specks and holes that
 * cover less than half of this area disappear. (5) The inverses of the medians are averaged over
 * the same points, with a weight that falls to 0 at SmoothingRadius. This average is used because
 * the base around a contact stiffens it, and to first order the force depends on this average. If
 * the average is less than 1/MaximumDepth, the point has no base. A ray ends where the scan ends or
 * is not finite. Points of the body that are not finite are an error.
 *
 * The error of 1/thickness is the sum of three parts: the standard deviation of the medians that
 * enter the mean, the difference of this mean from the mean without the medians, and half of the
 * largest spacing divided by the square of the thickness. A point without base has an error of at
 * least 1/MaximumDepth, because a base may be just below MaximumDepth.
 *
 * The accuracy at sharp edges that are blurred by voxels is a tenth of a voxel. On a head, the scan
 * limits the accuracy, because fat is shifted relative to water along the read-out axis, typically
 * by up to a voxel.
 *
 * @warning The thickness is measured along the normal, and every dark region counts as base.
 *   Therefore air behind thin tissue (sinuses, nostrils, mouth) looks like bone. In the T1 scan of
 *   Colin 27, cortical bone has grey values of 10 to 25, the eyes 38, and muscle 60 and more.
 *
 * @warning
 * Step 3 has an effect only if the points of the body are closer together than EdgeWidth; steps 4
 * and 5 only if they are closer together than SmoothingRadius.
 *
 * Cost: Colin 27 at 0.6 mm, 426 thousand points: 10.5 s of one core, on a busy machine. A quarter
 * of it is for the rays, the rest for median and mean, whose cost grows with the number of points
 * within SmoothingRadius.
 * Threaded by vtkSMPTools; the bits do not depend on the number of threads. Abort leaves no output.
 *
 * @code{.py}
 * layer = palpate.vtkLayerThickness()
 * layer.SetInputConnection(skin.GetOutputPort())       # vtkSkinSurface of the same scan
 * layer.SetScanConnection(scan.GetOutputPort())
 * layer.SetMaximumDepth(20)                            # mm
 * response.SetInputConnection(layer.GetOutputPort())
 * response.SetInputArrayToProcess(1, 0, 0, 0, "LayerThickness")
 * @endcode
 *
 * @sa vtkSkinSurface vtkToolContactResponse
 */
#ifndef vtkLayerThickness_h
#define vtkLayerThickness_h

#include "palpateResponseModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For std::string

class vtkImageData;

class PALPATERESPONSE_EXPORT vtkLayerThickness : public vtkPolyDataAlgorithm
{
public:
  static vtkLayerThickness* New();
  vtkTypeMacro(vtkLayerThickness, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Sets the scan, input port 1. */
  void SetScanConnection(vtkAlgorithmOutput* scan) { this->SetInputConnection(1, scan); }
  void SetScanData(vtkDataObject* scan) { this->SetInputData(1, scan); }
  ///@}

  ///@{
  /**
   * Grey value below which the scan counts as base, in the unit of the scalars. Default 35,
   * suitable for the T1 scan of Colin 27.
   */
  vtkSetMacro(BaseValue, double);
  vtkGetMacro(BaseValue, double);
  ///@}

  ///@{
  /** Depth down to which the filter searches for a base, mm, > 0. Default 20. */
  vtkSetMacro(MaximumDepth, double);
  vtkGetMacro(MaximumDepth, double);
  ///@}

  ///@{
  /**
   * Width over which the scan blurs an edge, mm, > 0. The grey values of tissue and base are
   * compared within this width. The default is 3, which is three voxels of Colin 27.
   */
  vtkSetMacro(EdgeWidth, double);
  vtkGetMacro(EdgeWidth, double);
  ///@}

  ///@{
  /**
   * Radius of the neighbourhood over which median and mean are taken, mm. 0 disables both. Default
   * 3.
   */
  vtkSetMacro(SmoothingRadius, double);
  vtkGetMacro(SmoothingRadius, double);
  ///@}

protected:
  vtkLayerThickness();
  ~vtkLayerThickness() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkLayerThickness(const vtkLayerThickness&) = delete;
  void operator=(const vtkLayerThickness&) = delete;

  std::string Problem(vtkImageData* scan, vtkDataArray* grey) const;

  double BaseValue = 35.0;
  double MaximumDepth = 20.0;
  double EdgeWidth = 3.0;
  double SmoothingRadius = 3.0;
};

#endif

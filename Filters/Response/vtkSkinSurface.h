// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkinSurface
 * @brief   the outer skin of a head scan, as a body that can be touched
 *
 * Input (port 0): a three-dimensional vtkImageData in millimetres with one-component point scalars
 * that are low in air and high in tissue. Input array 0 to process selects the scalars; the default
 * is the active scalars. NaN and infinite values count as air.
 *
 * Output: a vtkPolyData of triangles with consistent winding and unit outward point normals (float
 * array "Normals", active); no other arrays. The output is one connected surface of the skin,
 * without inner cavities and islands. Where the tissue extends beyond the field of view (the neck,
 * sometimes the ears), the surface has an open border, which is not capped.
 *
 * The steps: (1) Grey-level closing of the scan with a ball of ClosingRadius, at the scan's own
 * spacing. The closing shuts nostrils, ear canals and deep folds. It keeps the grey levels at the
 * skin, and therefore the sub-voxel position of the skin. (2) The air is the largest 6-connected
 * region below ContourValue that reaches the border of the scan. All other regions below
 * ContourValue are filled. (3) Resampling to Resolution by a windowed sinc, anti-aliased. (4)
 * Contour at ContourValue by flying edges (Schroeder, Maynard, Geveci 2015, Flying Edges: a
 * high-performance scalable isocontouring algorithm, LDAV); only the largest region is kept. (5)
 * Windowed-sinc smoothing (Taubin, Zhang, Golub 1996, Optimal surface smoothing as filter design,
 * ECCV), always with Hamming's window, independent of VTK's default. Border points do not move. The
 * amplitude of waves with a length of 8 spacings of the scan falls to 3 %, and with 10 spacings to
 * a quarter. Waves of 20 and more spacings remain. (6) Point normals.
 *
 * Axes: the points are in the physical coordinates of the image, origin + direction * (index *
 * spacing). vtkBodyFileReader gives a NIfTI scan the coordinates of its header: +x points to the
 * right of the head, +y to the nose, +z up. vtkNIFTIImageReader ignores sform, qform, unit,
 * scl_slope and scl_inter.
 *
 * Cost: Colin 27 (181 x 217 x 181 voxels of 1 mm) gives 153 thousand points in 1.6 s at a
 * Resolution of 1 mm, and 426 thousand points in 4 s at 0.6 mm, on two cores. Time and memory
 * (about 30 bytes per voxel of the lattice) grow with Resolution^-3. The cost of closing grows with
 * the square of ClosingRadius in voxels.
 *
 * The output does not depend on the number of threads. It is the same on every run, and with VTK
 * 9.1 and every later version.
 *
 * @warning Openings wider than twice the ClosingRadius stay open, and the cavity behind them is
 *   then part of the surface. Much larger radii close folds that should stay open, such as the fold
 *   between ear and head. Noise above ContourValue in the air that touches the skin becomes part of
 *   the surface.
 *
 * @warning If tissue and the field of view separate the air into two parts, only the larger part
 *   counts as air.
 *
 * @code{.py}
 * reader = palpate.vtkBodyFileReader()
 * reader.SetFileName("head.nii.gz")
 * skin = palpate.vtkSkinSurface()
 * skin.SetInputConnection(reader.GetOutputPort())
 * skin.SetContourValue(30)                             # grey value of the skin
 * skin.SetResolution(1.0)                              # mm
 * skin.Update()
 * @endcode
 *
 * @sa
 * vtkBodyFileReader vtkFlyingEdges3D vtkWindowedSincPolyDataFilter
 */

#ifndef vtkSkinSurface_h
#define vtkSkinSurface_h

#include "palpateResponseModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class PALPATERESPONSE_EXPORT vtkSkinSurface : public vtkPolyDataAlgorithm
{
public:
  static vtkSkinSurface* New();
  vtkTypeMacro(vtkSkinSurface, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The grey level of the skin, in the unit of the scalars, strictly inside the range of the
   * scalars. With the default 0, the level is chosen from the scan. Integers with at most 64
   * different values are labels of tissues. The skin is then the border of the smallest label, in
   * the middle between voxels. For any other scan, the level is at 12 % of the range, for example
   * 31 for grey values from 0 to 255. For the T1 scan of Colin 27, 30 is suitable. For a level of
   * exactly 0, set a number close to 0.
   */
  vtkSetMacro(ContourValue, double);
  vtkGetMacro(ContourValue, double);
  ///@}

  /**
   * The grey level that the last run used, given or chosen. For labels, it is the middle of their
   * range.
   */
  vtkGetMacro(UsedContourValue, double);

  ///@{
  /**
   * Radius of the ball that closes nostrils and ears, mm. The ball closes openings with a width of
   * up to twice the radius. 0 disables the closing. Default 6. Up to a radius of 5 the ear canals
   * of Colin 27 stay open, 20 mm deep. Apart from the ear canals, the result changes little between
   * 3 and 6.
   */
  vtkSetMacro(ClosingRadius, double);
  vtkGetMacro(ClosingRadius, double);
  ///@}

  ///@{
  /**
   * Spacing of the contoured lattice, mm. It is about the edge length of the triangles. The default
   * 0 selects the spacing of the scan. A lattice finer than the scan makes the surface rounder but
   * adds no detail.
   */
  vtkSetMacro(Resolution, double);
  vtkGetMacro(Resolution, double);
  ///@}

  ///@{
  /**
   * Number of iterations of the windowed-sinc smoothing of the triangles after the contour. Its
   * pass band removes the steps of the voxels, for any Resolution. 0 disables the smoothing.
   * Default 30.
   */
  vtkSetMacro(NumberOfSmoothingIterations, int);
  vtkGetMacro(NumberOfSmoothingIterations, int);
  ///@}

protected:
  vtkSkinSurface();
  ~vtkSkinSurface() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  double ContourValue = 0.0;
  double UsedContourValue = 0.0;
  double ClosingRadius = 6.0;
  double Resolution = 0.0;
  int NumberOfSmoothingIterations = 30;

private:
  vtkSkinSurface(const vtkSkinSurface&) = delete;
  void operator=(const vtkSkinSurface&) = delete;
};

#endif

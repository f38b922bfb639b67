// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPressPath
 * @brief a tool path that presses into a body, slides over it, and lifts off
 *
 * Input: a body of triangles, mm. Output: a polyline of tool tips with point arrays `Time` (double,
 * s) and `Inward` (double 3, the direction of pressing), for vtkHapticDevice::SetPath or
 * vtkToolContactProbe.
 *
 * The points to visit are given by directions from Center. A ray from outside the body towards
 * Center gives the first surface along each direction. With several directions, the path goes from
 * each direction to the next through intermediate directions. At the first point the tip moves at
 * PressSpeed along the direction of pressing, from the height Approach above the surface to Depth
 * below the surface, and rests. Then it slides at SlideSpeed at the constant depth Depth. At the
 * last point it rests and lifts off. With a single direction it presses, rests and lifts off.
 *
 * The direction of pressing is the surface normal, averaged over SmoothingLength of the path, like
 * the direction in which a hand holds the tool. On a rough surface, the depth along this direction
 * is therefore only approximately the deflection.
 *
 * The filter fails if a direction meets no surface, or if neighbouring points of the path are more
 * than 10 mm apart because the path crosses a gap or a silhouette.
 *
 * @code{.py}
 * path = palpate.vtkPressPath()
 * path.SetInputConnection(surface.GetOutputPort())
 * path.AddDirection(0, 0, 1)                           # from Center; slides from place to place
 * path.AddDirection(1, 0, 1)
 * path.SetDepth(1.0)                                   # mm
 * path.Update()
 * @endcode
 */
#ifndef vtkPressPath_h
#define vtkPressPath_h

#include "palpateInteractionModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <array>  // For std::array
#include <vector> // For std::vector

class PALPATEINTERACTION_EXPORT vtkPressPath : public vtkPolyDataAlgorithm
{
public:
  static vtkPressPath* New();
  vtkTypeMacro(vtkPressPath, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Origin of the directions, mm, inside the body. Default 0, 0, 0. */
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{
  /** The directions to visit. They may have any length except zero. Consecutive directions must not
   * be opposite. */
  void AddDirection(double x, double y, double z);
  void RemoveAllDirections();
  ///@}

  ///@{
  /** Depth of the tip below the surface, mm. Default 1. */
  vtkSetMacro(Depth, double);
  vtkGetMacro(Depth, double);
  ///@}

  ///@{
  /** Height above the surface at which the path begins and ends, mm. Default 5. */
  vtkSetMacro(Approach, double);
  vtkGetMacro(Approach, double);
  ///@}

  ///@{
  /** Speed of pressing and lifting, mm/s, > 0. Default 5. */
  vtkSetMacro(PressSpeed, double);
  vtkGetMacro(PressSpeed, double);
  ///@}

  ///@{
  /** Speed of sliding, mm/s, > 0. Default 40. */
  vtkSetMacro(SlideSpeed, double);
  vtkGetMacro(SlideSpeed, double);
  ///@}

  ///@{
  /** Length of the path over which normals are averaged, mm, >= 0. Default 8. */
  vtkSetMacro(SmoothingLength, double);
  vtkGetMacro(SmoothingLength, double);
  ///@}

protected:
  vtkPressPath() = default;
  ~vtkPressPath() override = default;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkPressPath(const vtkPressPath&) = delete;
  void operator=(const vtkPressPath&) = delete;

  struct Footprint;
  bool FindFootprints(vtkPolyData* body, std::vector<Footprint>& footprints);
  void SmoothNormals(std::vector<Footprint>& footprints) const;
  void WritePath(const std::vector<Footprint>& footprints, vtkPolyData* output) const;

  double Center[3] = { 0.0, 0.0, 0.0 };
  std::vector<std::array<double, 3>> Directions;
  double Depth = 1.0;
  double Approach = 5.0;
  double PressSpeed = 5.0;
  double SlideSpeed = 40.0;
  double SmoothingLength = 8.0;
};

#endif

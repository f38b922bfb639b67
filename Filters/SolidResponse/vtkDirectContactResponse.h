// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkDirectContactResponse
 * @brief presses a tool directly on a body at points where the stored response has too large an
 *   error
 *
 * Input: a surface of triangles, in mm, with response arrays `<name>Force` and so on, and with the
 * array `<name>Error` (StoreError). An example is the output of vtkElasticContactResponse with a
 * Surface. A point is pressed if its stored error at MaximumDeflection is above ErrorTolerance, or
 * if its curve ends earlier. The tool is then pressed on a part of the body that is cut out around
 * the point and filled with cells that are fine under the tool. If there is a point array
 * `Pressed`, only points where it is not 0 are pressed. Points that are held or have no normal are
 * never pressed.
 *
 * Output: the same surface. A point gets the curve of direct contact up to MaximumDeflection if the
 * error of this curve is smaller than the former error, or smaller than the difference of the two
 * curves. Its `Force`, `Stiffness`, `Range`, `Status`, `Error`, `Validity` and `Limit` are then as
 * in vtkElasticContactResponse. The values of the other points stay bit-identical. The point array
 * `<name>Direct` (uint8) contains the result at each point: 0 not pressed; 1 replaced; 2 pressed,
 * but the former curve has the smaller error; 3 failed (the part could not be cut out or filled,
 * the tool reaches held points, or no contact converged). A warning gives the first reason of a
 * failure.
 *
 * **Method.** The part extends five contact radii from the point. The nodes on its cut have the
 * motion of the body with coarse cells under the same resultant force (palpate::RestOfBody).
 * Contacts are unilateral and without friction. Each press is computed twice, the second time with
 * cells 1.5 times as long on the coarser body. The difference of the two forces is part of the
 * error. If this difference exceeds the tolerance, or if the tool extends beyond the part, a part
 * of eight contact radii is cut out.
 * - With Neo-Hooke and a tool without a flat end, finite strain is solved
 *   (palpate::pressAtFiniteStrain). The pressures act along the normal of the tool's surface. The
 *   computation starts where the tool first touches, for example at the rim of a hollow that is too
 *   narrow for the tool. The rest of the body is at small strain. If the motion of the rest rotates
 *   the pressed place, the square of the angle of rotation is part of the error. Contact of the
 *   body with itself is not modelled.
 * - Otherwise small strain is solved, with pressures that are linear on the facets
 *   (palpate::DirectContact). Finite strain multiplies the local part, as in
 *   vtkElasticContactResponse. The force is computed with pressures along the mean normal, and with
 *   pressures along the normal of each facet. Half of the difference of the two forces is part of
 *   the error. This difference is large in a crease, or where the tool touches several sides,
 *   because the theory of small displacements cannot decide between the two directions. If the tool
 *   touches another place before it reaches the point, and the distance that remains to the point
 *   exceeds the depth, the press fails.
 *
 * **Cost.** 4 to 10 s per point on one thread, 20 s at finite strain, a minute in hollows. Points
 * are distributed among all threads, and each thread needs 100 to 300 MB. Each of the two bodies is
 * factorised once. Abort is checked between points. The result is bit-identical for any number of
 * threads. The filter needs CGAL's mesher, as vtkGradedBody does. In a build without CGAL
 * (PALPATE_USE_CGAL), running the filter is an error.
 *
 * Errors: the response is missing or stores no error; a body has no cells or no array `Fixed`; a
 * property is out of range; the Shape cannot be closed.
 *
 * @code{.py}
 * direct = palpate.vtkDirectContactResponse()
 * direct.SetInputConnection(felt.GetOutputPort())      # vtkElasticContactResponse of the solid
 * direct.SetBodyConnection(solid.GetOutputPort())
 * direct.SetCoarserConnection(coarser.GetOutputPort()) # the same solid, cells 1.5 times as long
 * direct.SetTool(tool)
 * direct.SetMaximumDeflection(1.0)                     # mm
 * direct.SetErrorTolerance(0.05)                       # 5 % of the force
 * direct.Update()
 * @endcode
 *
 * @sa vtkElasticContactResponse vtkGradedBody
 */
#ifndef vtkDirectContactResponse_h
#define vtkDirectContactResponse_h

#include "palpateSolidResponseModule.h" // For export macro
#include "vtkTissueFilter.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <memory> // For std::unique_ptr
#include <string> // For std::string
#include <vector> // For std::vector

class vtkAlgorithmOutput;
class vtkUnstructuredGrid;

namespace palpate
{
class RestOfBody;
class StrainCorrection;
struct PreparedSurface;
} // namespace palpate

class PALPATESOLIDRESPONSE_EXPORT vtkDirectContactResponse : public vtkTissueFilter
{
public:
  static vtkDirectContactResponse* New();
  vtkTypeMacro(vtkDirectContactResponse, vtkTissueFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The solid body, as for vtkElasticContactResponse: a vtkUnstructuredGrid of one material with
   * the point array `Fixed`. The coarser body is the same body with cells 1.5 to 2 times as long.
   * Both are required.
   */
  void SetBodyConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetBodyData(vtkUnstructuredGrid* body);
  void SetCoarserConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(2, output); }
  void SetCoarserData(vtkUnstructuredGrid* coarser);
  ///@}

  ///@{
  /**
   * The closed surface from which parts are cut out, as for vtkGradedBody. Its facets are used
   * unchanged. If the facets of the input are longer than the width of a contact, set a smoothly
   * refined surface here. By default, the input is used.
   */
  void SetShapeConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(3, output); }
  void SetShapeData(vtkPolyData* shape);
  ///@}

  ///@{
  /**
   * Sides of the bounding box at which the Shape is held, as in vtkGradedBody. They must match the
   * sides of the two solids. With a depth, as in "z-:1", the held part of the Shape and of both
   * solids is the same. Without a depth, the held part depends on the length of the cells. Default
   * "z-".
   */
  vtkSetMacro(FixedFaces, std::string);
  vtkGetMacro(FixedFaces, std::string);
  ///@}

  ///@{
  /** Number of pressed points and number of replaced curves in the last run. */
  vtkGetMacro(NumberOfPresses, vtkIdType);
  vtkGetMacro(NumberOfReplaced, vtkIdType);
  ///@}

protected:
  vtkDirectContactResponse();
  ~vtkDirectContactResponse() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkDirectContactResponse(const vtkDirectContactResponse&) = delete;
  void operator=(const vtkDirectContactResponse&) = delete;

  struct Bodies;

  std::string CheckProperties();
  std::string CheckResponse(
    vtkPolyData* surface, vtkUnstructuredGrid* body, vtkUnstructuredGrid* coarser) const;
  std::vector<vtkIdType> FindPoints(vtkPolyData* surface) const;
  std::string Prepare(vtkPolyData* shape, vtkUnstructuredGrid* body, vtkUnstructuredGrid* coarser,
    Bodies& bodies, bool& ended);
  std::string Press(
    const std::vector<vtkIdType>& points, const Bodies& bodies, vtkPolyData* output);

  std::string FixedFaces = "z-";
  vtkIdType NumberOfPresses = 0;
  vtkIdType NumberOfReplaced = 0;
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkDirectContactResponse
 * @brief presses a tool directly on a body where the response by a law has too large an error
 *
 * Input: a surface of triangles, in mm, with response arrays `<name>Force` and so on and with
 * `<name>Error` (StoreError), such as the output of vtkElasticContactResponse with Surface. A point
 * is pressed if its stored error at MaximumDeflection is above ErrorTolerance, or if its curve ends
 * earlier. The tool is then pressed on a part of the body that is cut out around the point and
 * filled with cells that are fine under the tool. If there is a point array `Pressed`, only points
 * where it is not 0 are pressed. Points that are held or have no normal are never pressed.
 *
 * Output: the same surface. A point gets the curve of direct contact, to MaximumDeflection, if the
 * error of that curve is smaller than the former error, or smaller than the difference of the two
 * curves. Its `Force`, `Stiffness`, `Range`, `Status`, `Error`, `Validity` and `Limit` are then as
 * in vtkElasticContactResponse. The values of the other points stay bit-identical. The point array
 * `<name>Direct` (uint8) holds the outcome: 0 not pressed; 1 replaced; 2 pressed, but the former
 * curve has the smaller error; 3 failed (the part could not be cut out or filled, the tool reaches
 * held points, or no contact converged). A warning gives the first reason of a failure.
 *
 * **Method.** The part extends five contact radii from the point. The nodes on its cut move as the
 * body in its coarse cells does under the same resultant (palpate::RestOfBody). Contacts are
 * unilateral and without friction. Each press is computed twice, the second time with cells 1.5
 * times as long on the coarser body; the difference of the two is part of the error. If this
 * difference exceeds the tolerance, or the tool extends beyond the part, a part of eight contact
 * radii is cut out.
 * - With Neo-Hooke and a tool without a flat end: finite strain (palpate::pressAtFiniteStrain),
 *   with pressures along the tool's own normal. The computation starts where the tool first
 *   touches, for example at the rim of a hollow that is too narrow for it. The rest of the body is
 *   at small strain; if its motion rotates the place, the square of the angle of rotation is part
 *   of the error. Contact of the body with itself is not modelled.
 * - Otherwise: small strain with pressures that are linear on the facets (palpate::DirectContact);
 *   finite strain multiplies the local part, as in vtkElasticContactResponse. Pressures along the
 *   mean normal and pressures along each normal give two forces; half of their difference is part
 *   of the error. This difference is large in a crease, or where the tool touches several sides,
 *   because the theory of small displacements cannot decide between the two directions. A contact
 *   that touches elsewhere by more than the depth before it reaches the point fails.
 *
 * **Cost.** 4 to 10 s per point on one thread, 20 s at finite strain, a minute in hollows. Points
 * are shared among all threads, and each thread needs 100 to 300 MB. Each of the two bodies is
 * factorised once. Abort is checked between points. The result is bit-identical for any number of
 * threads. The mesher is CGAL's, as in vtkGradedBody: without it (PALPATE_USE_CGAL) running the
 * filter is an error.
 *
 * Error messages name the fault: the response is missing or stores no error; a body without cells
 * or without `Fixed`; a property out of range; a Shape that cannot be closed.
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
  /** The solid as in vtkElasticContactResponse, a vtkUnstructuredGrid of one material with the
   * point array `Fixed`; and the same body in cells 1.5 to 2 times as long. Both are required. */
  void SetBodyConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetBodyData(vtkUnstructuredGrid* body);
  void SetCoarserConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(2, output); }
  void SetCoarserData(vtkUnstructuredGrid* coarser);
  ///@}

  ///@{
  /** The closed surface from which parts are cut out, as in vtkGradedBody. Its facets are used
   * unchanged: if the facets of the input are longer than a contact is wide, set a smoothly refined
   * surface. Optional; by default the input. */
  void SetShapeConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(3, output); }
  void SetShapeData(vtkPolyData* shape);
  ///@}

  ///@{
  /** Sides of the bounding box at which the Shape is held, as in vtkGradedBody. They must match
   * those of the two solids. With a depth, as in "z-:1", the held part of the Shape and of both
   * solids is the same; without a depth it depends on the length of the cells. Default "z-". */
  vtkSetMacro(FixedFaces, std::string);
  vtkGetMacro(FixedFaces, std::string);
  ///@}

  ///@{
  /** Number of pressed points and of replaced curves in the last run. */
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

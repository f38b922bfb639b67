// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkDirectContactResponse
 * @brief presses a tool directly where no law of contact is known well enough
 *
 * Input: a surface of triangles with response arrays `<name>Force` and so on, with `<name>Error`
 * (StoreError), as of vtkElasticContactResponse with Surface; mm. Wherever its stated error at
 * MaximumDeflection is above ErrorTolerance, or the curve ends before, the tool is pressed on a
 * part of the body of its own, which is cut out around the point and filled with cells that are
 * fine under the tool. Only where a point array `Pressed` is not 0, if there is one; never where a
 * point is held or has no normal.
 *
 * Output: the same surface. A point whose error by direct contact is less, or less than what both
 * differ by, has that curve, to MaximumDeflection: `Force`, `Stiffness`, `Range`, `Status`,
 * `Error`, `Validity` and `Limit` are as of vtkElasticContactResponse; the others stay, bit by bit.
 * The point array `<name>Direct` (uint8) tells what became of each: 0 not pressed, 1 replaced, 2
 * pressed, but the law is better known, 3 failed (it could not be cut out or filled, the tool comes
 * upon what is held, or no contact settled); there is a warning with the first reason.
 *
 * **Method.** The part reaches five contact radii; on its cut it moves as the body in its coarse
 * cells does under the same resultant (palpate::RestOfBody). Contacts are unilateral and without
 * friction. All is done twice, the second time with one and a half times longer cells on the
 * coarser body: what they differ by is part of the error. Where that is more than the
 * tolerance, or the tool reaches farther, a part of eight contact radii is cut out.
 * - With Neo-Hooke and a tool without a flat end: finite strain (palpate::pressAtFiniteStrain),
 *   pressures along the tool's own normal, from where it first touches on, as in a hollow too
 * narrow for it. The rest of the body is at small strain, and where it turns the place, the square
 * of that angle is part of the error. The body does not touch itself.
 * - Otherwise: small strain, pressures linear on the facets
 *   (palpate::DirectContact), and finite strain multiplies what is local, as of
 *   vtkElasticContactResponse. Half of what pressures along the mean normal and each along its own
 *   differ by is part of the error: in a crease, or where the tool touches several sides, that is
 *   what small displacements leave open. A contact that touches elsewhere by more than the depth
 *   before it comes to the point is none.
 *
 * **Cost.** 4 to 10 s a point of one thread, at finite strain 20 s, in hollows a minute, on all
 * threads, and 100 to 300 MB each: offline work. One factorisation each of the two bodies. Abort is
 * seen between points. The same bits for any number of threads. The mesher is CGAL's, as of
 * vtkGradedBody: without it (PALPATE_USE_CGAL) running the filter is an error.
 *
 * Errors, which name what is wrong: no such response, or without errors; an input without cells or
 * `Fixed`; a property out of range; a Shape that cannot be closed.
 *
 * @sa vtkElasticContactResponse vtkGradedBody
 */
#ifndef vtkDirectContactResponse_h
#define vtkDirectContactResponse_h

#include "palpateSolidResponseModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <memory> // For std::unique_ptr
#include <string> // For std::string
#include <vector> // For std::vector

class vtkAlgorithmOutput;
class vtkContactTool;
class vtkUnstructuredGrid;

namespace palpate
{
class RestOfBody;
class StrainCorrection;
struct PreparedSurface;
} // namespace palpate

class PALPATESOLIDRESPONSE_EXPORT vtkDirectContactResponse : public vtkPolyDataAlgorithm
{
public:
  static vtkDirectContactResponse* New();
  vtkTypeMacro(vtkDirectContactResponse, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The solid as of vtkElasticContactResponse, a vtkUnstructuredGrid of one material with the
   * point array `Fixed`; and the same in cells one and a half to twice as long. Both are required.
   */
  void SetBodyConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetBodyData(vtkUnstructuredGrid* body);
  void SetCoarserConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(2, output); }
  void SetCoarserData(vtkUnstructuredGrid* coarser);
  ///@}

  ///@{
  /** The closed surface that parts are cut out of, as of vtkGradedBody. Facets are taken as they
   * are: where those of the input are longer than a contact, give it refined smoothly. Optional; by
   * default the input. */
  void SetShapeConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(3, output); }
  void SetShapeData(vtkPolyData* shape);
  ///@}

  ///@{
  /** The tool that the response is of; required. Its changes count in this filter's modification
   * time. */
  virtual void SetTool(vtkContactTool* tool);
  vtkContactTool* GetTool();
  ///@}

  ///@{
  /** E, MPa, > 0; ν, 0 to 0.499. Default 0.1 and 0.45. */
  vtkSetMacro(YoungsModulus, double);
  vtkGetMacro(YoungsModulus, double);
  vtkSetMacro(PoissonRatio, double);
  vtkGetMacro(PoissonRatio, double);
  ///@}

  ///@{
  /** The depth to which curves are to be known, mm, > 0: commonly that of the response. Default 2.
   */
  vtkSetMacro(MaximumDeflection, double);
  vtkGetMacro(MaximumDeflection, double);
  ///@}

  ///@{
  /** The error of the force that is let pass, relative, > 0. Default 0.05. */
  vtkSetMacro(ErrorTolerance, double);
  vtkGetMacro(ErrorTolerance, double);
  ///@}

  ///@{
  /** Of which sides of its box the Shape is held, as of vtkGradedBody, and as the solids are: with
   * a depth, "z-:1", it is the same of all three, without it depends on the length of their cells.
   * Default "z-". */
  vtkSetMacro(FixedFaces, std::string);
  vtkGetMacro(FixedFaces, std::string);
  ///@}

  ///@{
  /** Prefix of the response arrays. Default "Response". */
  vtkSetMacro(ResponseName, std::string);
  vtkGetMacro(ResponseName, std::string);
  ///@}

  /// Values of StrainModel.
  enum StrainModelType
  {
    SmallStrain = 0,
    NeoHooke = 1,
    Ogden = 2,
    Demiray = 3
  };

  ///@{
  /** As of vtkElasticContactResponse, and as the response was made with. Default SmallStrain. */
  vtkSetClampMacro(StrainModel, int, SmallStrain, Demiray);
  vtkGetMacro(StrainModel, int);
  vtkSetMacro(OgdenExponent, double);
  vtkGetMacro(OgdenExponent, double);
  vtkSetMacro(DemirayExponent, double);
  vtkGetMacro(DemirayExponent, double);
  ///@}

  ///@{
  /** Of the last run: how many points were pressed on, and how many have that curve. */
  vtkGetMacro(NumberOfPresses, vtkIdType);
  vtkGetMacro(NumberOfReplaced, vtkIdType);
  ///@}

  vtkMTimeType GetMTime() override;

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

  vtkSmartPointer<vtkContactTool> Tool;
  double YoungsModulus = 0.1;
  double PoissonRatio = 0.45;
  double MaximumDeflection = 2.0;
  double ErrorTolerance = 0.05;
  std::string FixedFaces = "z-";
  std::string ResponseName = "Response";
  int StrainModel = SmallStrain;
  double OgdenExponent = 2.0;
  double DemirayExponent = 1.0;
  vtkIdType NumberOfPresses = 0;
  vtkIdType NumberOfReplaced = 0;
};

#endif

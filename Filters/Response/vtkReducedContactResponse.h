// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkReducedContactResponse
 * @brief a response in the fewest numbers that keep its forces within a tolerance
 *
 * Input: a body with response arrays (vtkToolContactResponse, vtkMeasuredContactResponse), in
 * either form. Output: the same body, with its response `ResponseName` in the first of these forms
 * that suffices:
 * - one law for the body: the same curve at every point;
 * - one law, times one number per point;
 * - a basis of up to MaximumNumberOfLaws laws, with as many coefficients per point;
 * - a separate curve per point, with fewer samples;
 * - the response unchanged.
 *
 * Laws are stored as the field array `<name>Basis` and coefficients as the point array
 * `<name>Coefficient`. They replace `<name>Force` and `<name>Stiffness`. Every reader of a response
 * accepts both forms. The servo tick evaluates the laws directly. Its record of a point shrinks
 * from 80 bytes to 16 bytes plus 4 bytes per coefficient; with one law there are no coefficients.
 * All other arrays pass through.
 *
 * The error of a point is the largest difference of the force at any depth up to the Range of the
 * point, divided by the force at that depth. At depths before the first sample, the difference is
 * divided by the force at the first sample. The error is computed at every point from the stored
 * numbers, at four depths per interval between samples. Between these depths the error may be a
 * tenth larger. Curves of different Range (measured curves that end where their data end) need more
 * laws.
 *
 * The Get... functions below and the field arrays `<name>Reduction` (text) and
 * `<name>ReductionError` (double, relative) report the number of dropped values and the resulting
 * error.
 *
 * Source: proper orthogonal decomposition (Sirovich 1987), with columns weighted for the relative
 * error; details in ResponseReduction.h. Cost: a few µs per point and core. The bits do not depend
 * on the number of threads.
 *
 * Errors: the body has no such response; Tolerance is not above 0; MaximumNumberOfLaws is not from
 * 1 to 16.
 *
 * @code{.py}
 * reduced = palpate.vtkReducedContactResponse()
 * reduced.SetInputData(body)
 * reduced.SetTolerance(0.01)                           # 1 % of the force
 * reduced.Update()
 * print(reduced.GetReport())                           # form, numbers per point, error
 * @endcode
 */
#ifndef vtkReducedContactResponse_h
#define vtkReducedContactResponse_h

#include "palpateResponseModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For std::string

class PALPATERESPONSE_EXPORT vtkReducedContactResponse : public vtkPolyDataAlgorithm
{
public:
  static vtkReducedContactResponse* New();
  vtkTypeMacro(vtkReducedContactResponse, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The forms of a stored response, in ascending order of the amount of stored numbers.
  enum FormType
  {
    OneLaw = 0,
    Scale = 1,
    Basis = 2,
    Samples = 3,
    Unchanged = 4
  };

  ///@{
  /**
   * Largest relative error of the force, > 0. Below about 1e-6, the rounding of floats limits the
   * accuracy. Default 0.01, which is a tenth of the difference that a hand can notice.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /** Largest number of laws of a basis, 1 to 16. Default 8. */
  vtkSetMacro(MaximumNumberOfLaws, int);
  vtkGetMacro(MaximumNumberOfLaws, int);
  ///@}

  ///@{
  /** Prefix of the response arrays. Default "Response". */
  vtkSetMacro(ResponseName, std::string);
  vtkGetMacro(ResponseName, std::string);
  ///@}

  ///@{
  /**
   * Results of the last execution: the form; the numbers stored per point (except normal, range and
   * status), after and before the reduction; the largest relative error of the force over all
   * points and depths; the point with this error (-1 if no point has a response); and the largest
   * error of dF/dδ relative to the largest slope of the curve.
   */
  vtkGetMacro(Form, int);
  vtkGetMacro(NumbersPerPoint, int);
  vtkGetMacro(NumbersPerPointBefore, int);
  vtkGetMacro(LargestError, double);
  vtkGetMacro(WorstPoint, vtkIdType);
  vtkGetMacro(LargestStiffnessError, double);
  ///@}
  /** Returns these results as a sentence. */
  vtkGetMacro(Report, std::string);

protected:
  vtkReducedContactResponse();
  ~vtkReducedContactResponse() override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkReducedContactResponse(const vtkReducedContactResponse&) = delete;
  void operator=(const vtkReducedContactResponse&) = delete;

  double Tolerance = 0.01;
  int MaximumNumberOfLaws = 8;
  std::string ResponseName = "Response";

  int Form = Unchanged;
  int NumbersPerPoint = 0;
  int NumbersPerPointBefore = 0;
  double LargestError = 0.0;
  vtkIdType WorstPoint = -1;
  double LargestStiffnessError = 0.0;
  std::string Report;
};

#endif

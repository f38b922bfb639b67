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
 * accepts both forms. The servo tick evaluates the laws directly: its record of a point shrinks
 * from 80 bytes to 16, plus 4 per coefficient (none for one law). All other arrays pass through.
 *
 * The error of a point is the largest difference of the force at any depth up to its Range, divided
 * by the force at that depth (before the first sample: by the force at the first sample). It is
 * computed at every point, four times per interval between samples, from the stored numbers.
 * Between these depths it may be a tenth larger. Curves of different Range (measured curves that
 * end where their data end) need more laws.
 *
 * The Get... functions below and the field arrays `<name>Reduction` (text) and
 * `<name>ReductionError` (double, relative) report the dropped numbers and the resulting error.
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

  /// The forms of a stored response, in ascending number of stored numbers.
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
   * Largest relative error of the force, > 0. Below about 1e-6 the rounding of floats limits the
   * accuracy. Default 0.01: a tenth of the difference that a hand can notice.
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
   * Results of the last execution: form; numbers stored per point (except normal, range, status),
   * now and before; largest relative error of the force over all points and depths; the point of
   * that error (-1: no point has a response); and the largest error of dF/dδ relative to the
   * curve's steepest value.
   */
  vtkGetMacro(Form, int);
  vtkGetMacro(NumbersPerPoint, int);
  vtkGetMacro(NumbersPerPointBefore, int);
  vtkGetMacro(LargestError, double);
  vtkGetMacro(WorstPoint, vtkIdType);
  vtkGetMacro(LargestStiffnessError, double);
  ///@}
  /** These results as a sentence. */
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

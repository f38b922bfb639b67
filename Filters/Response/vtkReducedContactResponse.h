// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkReducedContactResponse
 * @brief a response in the fewest numbers that keep its forces within a tolerance
 *
 * Input: a body with response arrays (vtkToolContactResponse, vtkMeasuredContactResponse), in
 * either form. Output: the same body, whose response `ResponseName` is the first of these that
 * suffices:
 * - one law for the body: the same curve at every point;
 * - one law, times a number per point;
 * - a basis of up to MaximumNumberOfLaws laws, with as many coefficients per point;
 * - a curve of its own per point, in fewer samples;
 * - the response unchanged.
 *
 * Laws are the field array `<name>Basis` and coefficients the point array `<name>Coefficient`, in
 * place of `<name>Force` and `<name>Stiffness`; every reader of a response accepts both, and the
 * servo tick evaluates the laws directly: its record of a point shrinks from 80 bytes to 16, and 4
 * per coefficient (none for one law). All other arrays pass through.
 *
 * The error of a point is the largest difference of the force at any depth up to its Range, over
 * the force at that depth (over that of the first sample before it). It is found at every point,
 * four times per interval between samples, from the numbers as stored; between these depths it may
 * be a tenth larger. Curves of different Range (measured ones, cut where their data end) take more
 * laws.
 *
 * What was dropped, and the error by that, is told by the Get... functions below and by the field
 * arrays `<name>Reduction` (text) and `<name>ReductionError` (double, relative).
 *
 * Source: proper orthogonal decomposition (Sirovich 1987), the columns weighted for the relative
 * error; details in ResponseReduction.h. Cost: some µs per point and core. The same bits for any
 * number of threads.
 *
 * Errors: no such response; Tolerance not above 0, MaximumNumberOfLaws not from 1 to 16.
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

  /// The forms of a stored response, from the fewest numbers up.
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
   * Largest relative error of the force, > 0; below about 1e-6 the rounding of floats prevails.
   * Default 0.01: a tenth of what a hand can tell.
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
  /** Of the last execution: form; numbers stored per point (but for normal, range, status), now
   * and before; largest relative error of the force over all points and depths, the point it is at
   * (-1: no point has a response), and that of dF/dδ relative to the curve's steepest. */
  vtkGetMacro(Form, int);
  vtkGetMacro(NumbersPerPoint, int);
  vtkGetMacro(NumbersPerPointBefore, int);
  vtkGetMacro(LargestError, double);
  vtkGetMacro(WorstPoint, vtkIdType);
  vtkGetMacro(LargestStiffnessError, double);
  ///@}
  /** All that in a sentence. */
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

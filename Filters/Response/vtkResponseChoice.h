// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkResponseChoice
 * @brief chooses the simplest response a body needs: a point force, a few laws or a curve per
 * vertex
 *
 * Input: a body with response arrays (vtkToolContactResponse, vtkMeasuredContactResponse), in
 * either form, and, if a point force is to be considered, with the arrays of vtkContactRegime for
 * the same tool. Output: the body, its response in the first of these that keeps the forces:
 * - PointForce: a spring per point, F = k δ;
 * - OneLaw: the same curve at every point;
 * - ScaledLaw: one law, times a number per point;
 * - FewLaws: up to MaximumNumberOfLaws laws, combined at each point;
 * - PerVertex: a curve per point, as it was.
 *
 * **Laws** are taken when at `Share` of the points the force at every depth up to Range is off by
 * no more than `Tolerance`, relative to itself (before the first sample: to the force there). They
 * are stored as the field array `<name>Basis` and the point array `<name>Coefficient`.
 *
 * **A point force** is taken when three things hold at `Share` of the points: the shape of the tool
 * is not felt (RegimeVerdict 2), `Deflection` lies within Validity, and the spring is off by no
 * more than `Tolerance` of the force at Range. Its stiffness is the secant of the tool's curve
 * there: the local compliance in series with the global one, nearly 1/GlobalCompliance; another
 * tool would get the same to some per cent. It loses the soft start of a contact: a curve begins
 * without stiffness, a spring with all of it, so that at a tenth of Range, where the force is a
 * tenth, the relative error may be many times the Tolerance. Without the regime's arrays there is
 * no point force, nor for half-spaces and layers, whose λ is never near 1.
 *
 * **Relaxation** (vtkToolContactResponse::AddRelaxation) is left out, with its arrays, where it
 * changes the force of no press by more than `Tolerance`. Otherwise the field array
 * `<name>RelaxationElements` (int) says with how many elements (vtkContactSettings) the error stays
 * within `Tolerance` of the largest force of a press, for the worst of the motions studied
 * (palpate/RelaxationError.h), as the speed of the tool is not known.
 *
 * The choice in words, with its numbers: GetReason, and the field array `<name>Choice`. It also
 * tells where Deflection is beyond Validity: there the law's numbers are kept, but the law no
 * longer describes the body.
 *
 * All other arrays pass through; Validity and Limit stay those of the tool's law. Cost: 20 ns per
 * point where all curves are the same, else 2 to 3 us per point and core. The same bits for any
 * number of threads. See ResponseChoice.h.
 *
 * Errors: no such response; a setting out of its range; RegimeVerdict or Validity of another type;
 * a RegimeDeflection that is not Deflection.
 *
 * @sa vtkReducedContactResponse vtkContactRegime
 */
#ifndef vtkResponseChoice_h
#define vtkResponseChoice_h

#include "palpateResponseModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For std::string

class PALPATERESPONSE_EXPORT vtkResponseChoice : public vtkPolyDataAlgorithm
{
public:
  static vtkResponseChoice* New();
  vtkTypeMacro(vtkResponseChoice, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The forms that may suffice, the simplest first.
  enum VerdictType
  {
    PointForce = 0,
    OneLaw = 1,
    ScaledLaw = 2,
    FewLaws = 3,
    PerVertex = 4
  };

  ///@{
  /** Largest error of the force, > 0, in the two senses above. Default 0.01: a tenth of what a hand
   * can tell. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Fraction of the points that must keep the tolerance, above 0 to 1. Default 1: all. The error of
   * the others is not limited: see GetLargestError.
   */
  vtkSetMacro(Share, double);
  vtkGetMacro(Share, double);
  ///@}

  ///@{
  /**
   * Depth at which regime and validity are checked, mm. Default 0: that of the regime; without one,
   * half of Range at each point.
   */
  vtkSetMacro(Deflection, double);
  vtkGetMacro(Deflection, double);
  ///@}

  ///@{
  /** Largest number of laws that are combined, 1 to 16. Default 8. */
  vtkSetMacro(MaximumNumberOfLaws, int);
  vtkGetMacro(MaximumNumberOfLaws, int);
  ///@}

  ///@{
  /** Prefix of the response arrays. Default "Response". */
  vtkSetMacro(ResponseName, std::string);
  vtkGetMacro(ResponseName, std::string);
  ///@}

  ///@{
  /** Of the last execution: what was chosen (VerdictType), and why, in a sentence. */
  vtkGetMacro(Verdict, int);
  vtkGetMacro(Reason, std::string);
  ///@}
  ///@{
  /**
   * Of the last execution: numbers stored per point (but for normal, range, status), now and
   * before; largest error over all points; fraction of the points within the tolerance; fraction at
   * which the shape of the tool is not felt (0 without regime); largest error of springs (0 where
   * they were not considered); fraction at which Deflection is beyond Validity.
   */
  vtkGetMacro(NumbersPerPoint, int);
  vtkGetMacro(NumbersPerPointBefore, int);
  vtkGetMacro(LargestError, double);
  vtkGetMacro(KeptShare, double);
  vtkGetMacro(ShapelessShare, double);
  vtkGetMacro(SpringLoss, double);
  vtkGetMacro(BeyondValidityShare, double);
  ///@}
  /** Of the last execution: the elements that the body's relaxation needs (vtkContactSettings), 0,
   * 4, 8, 16 or 32; 0 also where nothing relaxes, or not enough to be felt. */
  vtkGetMacro(RelaxationElements, int);

protected:
  vtkResponseChoice();
  ~vtkResponseChoice() override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkResponseChoice(const vtkResponseChoice&) = delete;
  void operator=(const vtkResponseChoice&) = delete;

  double Tolerance = 0.01;
  double Share = 1.0;
  double Deflection = 0.0;
  int MaximumNumberOfLaws = 8;
  std::string ResponseName = "Response";

  int RelaxationElements = 0;
  int Verdict = PerVertex;
  std::string Reason;
  int NumbersPerPoint = 0;
  int NumbersPerPointBefore = 0;
  double LargestError = 0.0;
  double KeptShare = 0.0;
  double ShapelessShare = 0.0;
  double SpringLoss = 0.0;
  double BeyondValidityShare = 0.0;
};

#endif

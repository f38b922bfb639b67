// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkResponseChoice
 * @brief whether a body needs a point force, one law or a response per vertex; and takes it
 *
 * Input: a body with response arrays (vtkToolContactResponse, vtkMeasuredContactResponse), in
 * either form, and, if a point force is to be considered, with the arrays of vtkContactRegime for
 * the same tool. Output: the body, its response in the least of these that keeps the forces:
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
 * tool would get the same to some per cent. What is lost is the soft start of a contact: a curve
 * begins with no stiffness, a spring with all of it, so that the relative error at a tenth of Range
 * may be many times the Tolerance while the force there is a tenth. Without the regime, and for
 * half-spaces and layers, whose λ is never near 1, there is no point force.
 *
 * **Relaxation** (vtkToolContactResponse::AddRelaxation) is left out, its arrays taken away, where
 * no press can feel more of it than `Tolerance`. Otherwise the field array
 * `<name>RelaxationElements` (int) says with how many elements (vtkContactSettings) the force stays
 * within it, of the largest of a press, by the worst of the study's motions
 * (palpate/RelaxationError.h): how fast the tool will move is not known.
 *
 * The choice in words, with its numbers: GetReason, and the field array `<name>Choice`. It also
 * tells where Deflection is beyond Validity: there the numbers of the law are kept, but the law is
 * not the body's.
 *
 * All other arrays pass through; Validity and Limit stay those of the tool's law. Cost: 20 ns per
 * point where all curves are the same, else 2 to 3 us per point and core. Threads do not change a
 * bit. See ResponseChoice.h.
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

  /// The forms that may suffice, from the least on.
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
  /** Share of the points that must keep the tolerance, above 0 to 1. Default 1: all of them. The
   * others may be off by any amount: see GetLargestError. */
  vtkSetMacro(Share, double);
  vtkGetMacro(Share, double);
  ///@}

  ///@{
  /** How deep the tool is pressed, mm: where regime and validity are looked at. Default 0: where
   * the regime was found, without one half of Range at each point. */
  vtkSetMacro(Deflection, double);
  vtkGetMacro(Deflection, double);
  ///@}

  ///@{
  /** Most laws that are combined, 1 to 16. Default 8. */
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
  /** Of the last execution: numbers stored per point (but for normal, range, status), now and
   * before; largest error over all points; share of the points within the tolerance; share at which
   * the shape of the tool is not felt (0 without regime); largest error of springs (0 where they
   * were not considered); share at which Deflection is beyond Validity. */
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

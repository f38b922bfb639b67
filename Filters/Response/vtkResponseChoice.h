// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkResponseChoice
 * @brief chooses the simplest response that suffices for a body: a point force, a few laws or a
 *   curve per vertex
 *
 * Input: a body with response arrays (vtkToolContactResponse, vtkMeasuredContactResponse), in
 * either form. A point force is considered only if the body also has the arrays of vtkContactRegime
 * for the same tool. Output: the body with its response in the first of these forms that keeps the
 * forces:
 * - PointForce: a spring per point, F = k δ;
 * - OneLaw: the same curve at every point;
 * - ScaledLaw: one law, times one number per point;
 * - FewLaws: up to MaximumNumberOfLaws laws, combined at each point;
 * - PerVertex: a curve per point, unchanged.
 *
 * **Laws** are chosen if, at the fraction `Share` of the points, the relative error of the force is
 * at most `Tolerance` at every depth up to Range. Before the first sample, the error is relative to
 * the force at that sample. Laws are stored as the field array `<name>Basis` and the point array
 * `<name>Coefficient`.
 *
 * **A point force** is chosen if three conditions hold at the fraction `Share` of the points: the
 * shape of the tool does not matter (RegimeVerdict 2), `Deflection` is within Validity, and the
 * error of the spring is at most `Tolerance` of the force at Range. The stiffness of the spring is
 * the secant stiffness of the tool's curve at Range. It combines the local compliance in series
 * with the global compliance, and is nearly 1/GlobalCompliance. Another tool would give the same
 * stiffness to within a few per cent. The curve of a contact begins with zero stiffness, whereas a
 * spring has its full stiffness from the start. Therefore the relative error at a tenth of Range,
 * where the force is about a tenth, may be many times the Tolerance. A point force is never chosen
 * without the arrays of the regime. It is also never chosen for half-spaces and layers, because
 * their λ is never near 1.
 *
 * **Relaxation** (vtkToolContactResponse::AddRelaxation) is left out, with its arrays, if it does
 * not change the force of any press by more than `Tolerance`. Otherwise the field array
 * `<name>RelaxationElements` (int) gives the number of elements (vtkContactSettings) with which the
 * error stays within `Tolerance` of the largest force of a press. The number is that for the worst
 * of the studied motions (palpate/RelaxationError.h), because the speed of the tool is unknown.
 *
 * **Tilt and coupling** are left out, with their arrays, if they change no force by more than
 * `Tolerance`. Otherwise the reason gives the change, and for coupling the distance beyond which
 * another tool does not matter (palpate/CouplingNeed.h).
 *
 * GetReason and the field array `<name>Choice` describe the choice with its numbers. They also
 * state if Deflection is beyond Validity at some points. The numbers of the law are kept at these
 * points, but the law no longer describes the body there.
 *
 * All other arrays pass through. Validity and Limit remain those of the tool's law. Cost: 20 ns per
 * point if all curves are the same, else 2 to 3 us per point and core. The bits do not depend on
 * the number of threads. See ResponseChoice.h.
 *
 * Errors: the body has no such response; a setting is out of its range; RegimeVerdict or Validity
 * has another type; RegimeDeflection differs from Deflection.
 *
 * @code{.py}
 * choice = palpate.vtkResponseChoice()
 * choice.SetInputConnection(regime.GetOutputPort())    # vtkContactRegime at the same Deflection
 * choice.SetTolerance(0.05)                            # 5 % of the force
 * choice.SetDeflection(1.0)                            # mm
 * choice.Update()
 * print(choice.GetReason())
 * @endcode
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

  /// The possible forms of the response, simplest first.
  enum VerdictType
  {
    PointForce = 0,
    OneLaw = 1,
    ScaledLaw = 2,
    FewLaws = 3,
    PerVertex = 4
  };

  ///@{
  /**
   * Largest error of the force, > 0, as defined above for laws and for a point force. Default 0.01,
   * which is a tenth of the difference that a hand can notice.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Fraction of the points that must keep the tolerance, > 0 to 1. The default 1 means all points.
   * The error of the other points is not limited; GetLargestError returns it.
   */
  vtkSetMacro(Share, double);
  vtkGetMacro(Share, double);
  ///@}

  ///@{
  /**
   * Depth at which regime and validity are checked, mm. The default 0 selects the depth of the
   * regime or, without a regime, half of Range at each point.
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
  /** Results of the last execution: the choice (VerdictType), and its reason as a sentence. */
  vtkGetMacro(Verdict, int);
  vtkGetMacro(Reason, std::string);
  ///@}
  ///@{
  /**
   * Results of the last execution: numbers stored per point (except normal, range and status),
   * after and before the choice; largest error over all points; fraction of the points within the
   * tolerance; fraction of the points at which the shape of the tool does not matter (0 without a
   * regime); largest error of springs (0 if springs were not considered); fraction of the points at
   * which Deflection is beyond Validity.
   */
  vtkGetMacro(NumbersPerPoint, int);
  vtkGetMacro(NumbersPerPointBefore, int);
  vtkGetMacro(LargestError, double);
  vtkGetMacro(KeptShare, double);
  vtkGetMacro(ShapelessShare, double);
  vtkGetMacro(SpringLoss, double);
  vtkGetMacro(BeyondValidityShare, double);
  ///@}
  /**
   * Result of the last execution: the number of elements that the body's relaxation needs
   * (vtkContactSettings): 0, 4, 8, 16 or 32. It is also 0 if the body does not relax, or if the
   * relaxation has a negligible effect.
   */
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

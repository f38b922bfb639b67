// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkResponseFilter
 * @brief base of the filters that attach a response to a body of given material
 *
 * Abstract. It has the settings that vtkToolContactResponse and vtkElasticContactResponse share.
 *
 * @code{.py}
 * response = palpate.vtkElasticContactResponse()       # is a vtkResponseFilter
 * response.SetMaximumTilt(20)                          # degrees
 * response.AddRelaxation(0.5, 0.1)                     # strength, seconds
 * @endcode
 *
 * @sa vtkToolContactResponse vtkElasticContactResponse
 */
#ifndef vtkResponseFilter_h
#define vtkResponseFilter_h

#include "Response/Curves/RelaxationList.h" // For palpate::RelaxationList
#include "palpateResponseModule.h"          // For export macro
#include "vtkTissueFilter.h"

namespace palpate
{
struct LawRequest;
}

class PALPATERESPONSE_EXPORT vtkResponseFilter : public vtkTissueFilter
{
public:
  vtkTypeMacro(vtkResponseFilter, vtkTissueFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Samples per curve n, 2 to 256. Default 8. */
  vtkSetMacro(NumberOfSamples, int);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /** Whether the error at each sample is stored in the array `Error`, for displays. Default on; no
   * effect if ErrorTolerance is 0. */
  vtkSetMacro(StoreError, bool);
  vtkGetMacro(StoreError, bool);
  vtkBooleanMacro(StoreError, bool);
  ///@}

  ///@{
  /** Thickness h of an elastic layer on a rigid base, mm, >= 0, used where no array gives the
   * thickness. Default 0: a half-space. For a body of true shape, AutomaticTerms compares the
   * response with that of this layer. */
  vtkSetMacro(LayerThickness, double);
  vtkGetMacro(LayerThickness, double);
  ///@}

  ///@{
  /**
   * Whether sharp convex edges have an effect: a contact near an edge is softer and is pushed off
   * the body, and its force falls to zero as it leaves over the edge (palpate/BodyEdges.h; Hetényi
   * 1970). The curves of a law remain those far from edges; those of true shape include the
   * softening. A field array `<name>Edges` (double 5: exponent m, contact radius at 1 mm in mm,
   * Poisson's ratio, extent in mm, 1 if the curves include the edges) lets probe, touch and servo
   * loop apply them; the error includes the rest of their effect. Default on. Off: the force
   * drops where a contact passes an edge.
   */
  vtkSetMacro(EdgeCorrection, bool);
  vtkGetMacro(EdgeCorrection, bool);
  vtkBooleanMacro(EdgeCorrection, bool);
  ///@}

  ///@{
  /**
   * Largest tilt of the tool against the body's normal, degrees, >= 0. Default 0: the tool counts
   * as upright, whatever its axis.
   *
   * Above 0 the output has the field arrays `<name>Tilt`, `<name>TiltDrop`, `<name>TiltNode`
   * (double) and, if points differ in more than their modulus, the point array `<name>TiltWeight`
   * (float): how a tilt changes the work of the upright tool (palpate/TiltTable.h). A probe or
   * session that knows the tool's axis then applies its tilt, and a torque. The law is exact for a
   * sphere and, on a half-space, for a flat end. Its error is 0.5 % for cones, 1 % for other tools,
   * and 3 % for flat-ended tools beyond a tenth of their size. On layers it uses the axisymmetric
   * tool of equal contact radius, within Validity; on a body of true shape it is that of a
   * half-space. An angle within 4 degrees of that at which a flank of the tool is parallel to the
   * surface, or beyond, is an error. Cost: a few seconds for each tool without closed form.
   */
  vtkSetMacro(MaximumTilt, double);
  vtkGetMacro(MaximumTilt, double);
  ///@}

  ///@{
  /**
   * How the body relaxes: E(t)/E∞ = 1 + Σ p exp(-t/τ). Each branch has a strength p >= 0, relative
   * to the slow modulus E∞, and a time τ > 0 in seconds; up to four. Default none.
   *
   * Poisson's ratio does not change. Curves, YoungsModulus and Error are those of the slow
   * response; the force in time is larger, up to 1 + Σ p times (palpate/ToolContact.h). A fraction
   * g of the instantaneous modulus, as in the literature, is p = g/(1 - Σ g). A modulus measured in
   * a press at constant speed is above the slow one (palpate/PronySeries.h, rampFactor). The output
   * has the field arrays `<name>RelaxationStrength` and `<name>RelaxationTime` (double, a tuple
   * each, s).
   */
  void AddRelaxation(double strength, double seconds);
  void ClearRelaxations();
  int GetNumberOfRelaxations() { return this->Relaxations.count(); }
  double GetRelaxationStrength(int relaxation) { return this->Relaxations.strength(relaxation); }
  double GetRelaxationTime(int relaxation) { return this->Relaxations.seconds(relaxation); }
  ///@}

  ///@{
  /** AutomaticTerms: whether to choose the terms of the law by their effect. Default off.
   * TermTolerance: relative change of the force by terms that may be left out, >= 0. Default
   * 0.01. */
  vtkSetMacro(AutomaticTerms, bool);
  vtkGetMacro(AutomaticTerms, bool);
  vtkBooleanMacro(AutomaticTerms, bool);
  vtkSetMacro(TermTolerance, double);
  vtkGetMacro(TermTolerance, double);
  ///@}

  /// Result of the last execution: the choice of AutomaticTerms as text; "" if AutomaticTerms is
  /// off. The field array `<name>Terms` stores the text.
  vtkGetMacro(TermReason, std::string);

protected:
  vtkResponseFilter() = default;
  ~vtkResponseFilter() override = default;

  /// Fills the parts of a request that all of these filters have. Returns "" or an error message.
  std::string FillRequest(palpate::LawRequest& request);

  int NumberOfSamples = 8;
  bool StoreError = true;
  double LayerThickness = 0.0;
  bool EdgeCorrection = true;
  double MaximumTilt = 0.0;
  palpate::RelaxationList Relaxations;
  bool AutomaticTerms = false;
  double TermTolerance = 0.01;
  std::string TermReason;

private:
  vtkResponseFilter(const vtkResponseFilter&) = delete;
  void operator=(const vtkResponseFilter&) = delete;
};

#endif

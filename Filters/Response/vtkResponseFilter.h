// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkResponseFilter
 * @brief base class of the filters that attach a response to a body of given material
 *
 * This abstract class has the settings that vtkToolContactResponse and vtkElasticContactResponse
 * share.
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
  /** Number n of samples per curve, 2 to 256. Default 8. */
  vtkSetMacro(NumberOfSamples, int);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /**
   * Whether the error at each sample is stored in the array `Error`, for displays. Default on. The
   * setting has no effect if ErrorTolerance is 0.
   */
  vtkSetMacro(StoreError, bool);
  vtkGetMacro(StoreError, bool);
  vtkBooleanMacro(StoreError, bool);
  ///@}

  ///@{
  /**
   * Thickness h of an elastic layer on a rigid base, mm, >= 0. It is used where no array gives the
   * thickness. Default 0, which means a half-space. For a response of the true shape of a body,
   * AutomaticTerms compares the response with that of this layer.
   */
  vtkSetMacro(LayerThickness, double);
  vtkGetMacro(LayerThickness, double);
  ///@}

  ///@{
  /**
   * Whether sharp convex edges have an effect. A contact near an edge is softer and is pushed off
   * the body, and its force falls to zero when the contact moves over the edge
   * (palpate/BodyEdges.h; Hetényi 1970). The curves of a law remain those far from edges. Curves
   * for the true shape of a body include the softening. A field array `<name>Edges` (double 5:
   * exponent m, contact radius at 1 mm in mm, Poisson's ratio, extent in mm, 1 if the curves
   * include the edges) allows probe, touch and servo loop to apply the effect of edges. The error
   * includes the part of the effect that is not applied. Default off. If it is off, the force drops
   * where a contact passes an edge.
   */
  vtkSetMacro(EdgeCorrection, bool);
  vtkGetMacro(EdgeCorrection, bool);
  vtkBooleanMacro(EdgeCorrection, bool);
  ///@}

  ///@{
  /**
   * Largest tilt of the tool against the body's normal, degrees, >= 0. With the default 0, the tool
   * counts as upright for any direction of its axis.
   *
   * If it is above 0, the output has the field arrays `<name>Tilt`, `<name>TiltDrop`,
   * `<name>TiltNode` (double). If the points differ in more than their modulus, the output also has
   * the point array `<name>TiltWeight` (float). These arrays describe the change of the work of the
   * upright tool by a tilt (palpate/TiltTable.h). A probe or session that knows the tool's axis
   * then includes the tilt in the force and computes a torque. The law is exact for a sphere and,
   * on a half-space, for a flat end. The error is 0.5 % for cones, 1 % for other tools, and 3 % for
   * flat-ended tools at depths beyond a tenth of their size. On layers, within Validity, the law
   * uses the axisymmetric tool of equal contact radius. For a response of the true shape, the law
   * is that of a half-space. At a certain tilt, a flank of the tool is parallel to the surface. A
   * MaximumTilt above this tilt minus 4 degrees is an error. Cost: a few seconds for each tool
   * without closed form.
   */
  vtkSetMacro(MaximumTilt, double);
  vtkGetMacro(MaximumTilt, double);
  ///@}

  ///@{
  /**
   * Relaxation of the body: E(t)/E∞ = 1 + Σ p exp(-t/τ). Each branch has a strength p >= 0,
   * relative to the slow modulus E∞, and a time τ > 0 in seconds. At most four branches are
   * allowed. By default there are none.
   *
   * Poisson's ratio does not change. Curves, YoungsModulus and Error refer to the slow response.
   * The force as a function of time is larger by a factor of up to 1 + Σ p (palpate/ToolContact.h).
   * If the literature gives a fraction g of the instantaneous modulus, use p = g/(1 - Σ g). A
   * modulus that was measured in a press at constant speed is above the slow modulus
   * (palpate/PronySeries.h, rampFactor). The output has the field arrays `<name>RelaxationStrength`
   * and `<name>RelaxationTime` (double, one tuple per branch, s).
   */
  void AddRelaxation(double strength, double seconds);
  void ClearRelaxations();
  int GetNumberOfRelaxations() { return this->Relaxations.count(); }
  double GetRelaxationStrength(int relaxation) { return this->Relaxations.strength(relaxation); }
  double GetRelaxationTime(int relaxation) { return this->Relaxations.seconds(relaxation); }
  ///@}

  ///@{
  /**
   * AutomaticTerms: whether the filter chooses the terms of the law by their effect. Default off.
   * TermTolerance: largest relative change of the force by the omitted terms, >= 0. Default 0.01.
   */
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

  /// Fills the parts of a request that all of these filters have in common. Returns "" or an error
  /// message.
  std::string FillRequest(palpate::LawRequest& request);

  int NumberOfSamples = 8;
  bool StoreError = true;
  double LayerThickness = 0.0;
  bool EdgeCorrection = false;
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

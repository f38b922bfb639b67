// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkToolContactProbe
 * @brief the contact force at given tool tips, by the kernel of the servo tick
 *
 * Port 0: a body with response arrays (vtkToolContactResponse). Port 1: tool tips, the points of a
 * vtkPolyData in the body's frame, mm. A point that belongs to no polyline is an independent query
 * of the whole body; each polyline is one history, in which the contact is followed from point to
 * point as a tool that moves along it would feel it. A point in several polylines holds the value
 * of the last.
 *
 * Output: the tips, in input order, with their arrays and
 * - `Force` (double 3, N): total force on the tool, pointing out of the body;
 * - `NormalForce` (double, N), `FrictionForce` (double 3, N; zero: contacts are frictionless here);
 * - `Deflection` (double, mm): distance from the tip to its contact point on the undeformed body;
 * - `Normal` (double 3): the blended unit normal used;
 * - `ContactPoint` (double 3, mm), `ContactCell` (vtkIdType: cell of the body, -1 for none);
 * - `ContactState` (uint8): 0 none, 2 slide, 3 beyond range, 4 lost at an open border, 5 invalid
 *   (a tip that is not finite, or a vertex without response).
 * Without contact: zeros, -1, 0.
 *
 * The force blends the curves of the triangle's three vertices by area coordinates (Mahvash and
 * Hayward 2002, eqs. 3 and 4), in one of two forms (ForceForm).
 *
 * Cost: building the kernel's copy of the body once per change of the body, O(n log n); then about
 * 1 µs per tip. Independent tips are threaded by vtkSMPTools; same bits for any number of threads.
 */
#ifndef vtkToolContactProbe_h
#define vtkToolContactProbe_h

#include "palpateResponseModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For std::shared_ptr
#include <string> // For std::string

namespace palpate
{
struct ContactBody;
}

class PALPATERESPONSE_EXPORT vtkToolContactProbe : public vtkPolyDataAlgorithm
{
public:
  static vtkToolContactProbe* New();
  vtkTypeMacro(vtkToolContactProbe, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ForceFormType
  {
    Paper = 0,
    NormalizedDirection = 1
  };

  ///@{
  /**
   * Paper: Σ n_i f_i U_i as printed; since the blended normal is shorter than 1, the force loses up
   * to h²/(6R²) inside a facet of size h. NormalizedDirection (default): Σ n_i f_i along the
   * normalised Σ n_i U_i.
   */
  vtkSetMacro(ForceForm, int);
  vtkGetMacro(ForceForm, int);
  void SetForceFormToPaper() { this->SetForceForm(Paper); }
  void SetForceFormToNormalizedDirection() { this->SetForceForm(NormalizedDirection); }
  ///@}

  ///@{
  /**
   * Each tip is first moved inward by this much along the normal at its closest point, mm: lets
   * points picked on the surface press. Default 0.
   */
  vtkSetMacro(Indentation, double);
  vtkGetMacro(Indentation, double);
  ///@}

  ///@{
  /** Prefix of the response arrays. Default "Response". */
  vtkSetMacro(ResponseName, std::string);
  vtkGetMacro(ResponseName, std::string);
  ///@}

  /** The tips, port 1. */
  void SetTipConnection(vtkAlgorithmOutput* tips) { this->SetInputConnection(1, tips); }
  void SetTipData(vtkDataObject* tips) { this->SetInputData(1, tips); }

protected:
  vtkToolContactProbe();
  ~vtkToolContactProbe() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkToolContactProbe(const vtkToolContactProbe&) = delete;
  void operator=(const vtkToolContactProbe&) = delete;

  bool PrepareBody(vtkPolyData* body);

  int ForceForm = NormalizedDirection;
  double Indentation = 0.0;
  std::string ResponseName = "Response";

  // The kernel's copy of the body, and of which state of which body it is.
  std::shared_ptr<const palpate::ContactBody> Body;
  vtkPolyData* BodySource = nullptr;
  vtkMTimeType BodyTime = 0;
  std::string BodyResponse;
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkToolContactProbe
 * @brief computes the contact force at given tool tips with the kernel of the servo tick
 *
 * Port 0: a body with response arrays (vtkToolContactResponse). Port 1: tool tips, the points of a
 * vtkPolyData in the body's frame, mm. A point that belongs to no polyline is an independent query
 * of the whole body, without friction. Each polyline is one history. The contact is tracked from
 * point to point, with friction, as for a moving tool. A point that belongs to several polylines
 * has the values of the last of them.
 *
 * An optional point array `ToolAxis` gives the orientation of the tool. It contains a vector of 3
 * numbers that points from the tip up the shaft and has any length above zero. The array has an
 * effect if the response contains tilts (`<name>Tilt...`). Otherwise the tool is assumed to be
 * along the normal. A vector that is zero or not finite is an error.
 *
 * With **Coupled**, tips that press at the same time interact (palpate/CoupledContacts.h). Points
 * of polylines press at the same time if they have exactly the same `Time` or, without Time, the
 * same index in their polylines. Single points press at the same time if they have the same Time;
 * without Time, all of them do. Single points and polylines do not interact. At most 64 tips press
 * at the same time. Between its first and its last point, a polyline must have exactly one point at
 * each Time of the other polylines. Before its first and after its last point, its tool is absent.
 * Each time is solved to convergence, whereas a servo loop computes two iterations per tick. A
 * response without coupling (vtkToolContactResponse::CouplingOn) is an error. Deflection is then
 * the deflection of the tool's own dent, without the amount by which the other tools lower the
 * surface. With EnergyConsistent the force that pulls tools towards each other's dents is part of
 * Force, not of NormalForce.
 *
 * An optional point array `Time` (s, one number per point) gives the time of each position. The
 * force of a body that relaxes (vtkToolContactResponse::AddRelaxation) depends on the time. Each
 * polyline starts at its first point without memory, and the tip moves at constant speed from point
 * to point. Without Time, and for single points, the force is the slow force after a long press. No
 * other result depends on the speed; friction depends on the displacement only. The array Time
 * passes through. A Time that is not finite or that decreases along a polyline is an error.
 *
 * Output: the tips, in input order, with their arrays and
 * - `Force` (double 3, N): total force on the tool. It is the sum of NormalForce along Normal,
 *   FrictionForce and, with EnergyConsistent, a small tangential part if the response differs from
 *   point to point;
 * - `NormalForce` (double, N): the component of the force along Normal, out of the body;
 * - `FrictionForce` (double 3, N): the tangential force against the sliding; zero for single
 *   points;
 * - `Deflection` (double, mm): distance from the tip to its contact point on the undeformed body;
 * - `Normal` (double 3): the blended unit normal used;
 * - `ContactPoint` (double 3, mm), `ContactCell` (vtkIdType; cell of the body, -1 without contact);
 * - `ContactState` (uint8): 0 no contact, 1 stick (friction below Coulomb's limit), 2 slide, 3
 *   beyond range (sticking or sliding), 4 lost at an open border, 5 invalid (a tip that is not
 *   finite, or a vertex without response; this state ends the history). Without contact,
 *   ContactCell is -1 and all other values are 0. A contact without friction slides;
 * - `MemoryForce` (double, N), if the body relaxes: NormalForce minus the slow response at this
 *   depth. It is negative while the tool moves out, and 0 for single points and without Time;
 * - `Torque` (double 3, N mm), the torque about the tip, and `Tilt` (double, degrees), the angle
 *   between the axis and Normal, if the tips have a ToolAxis;
 * - `CoupledStiffness` (double k, N/mm), with Coupled: the derivative of NormalForce, without
 *   memory, with respect to the depth of each of the k tips that press at the same time, including
 *   the tip itself, in the order of their polylines or of the points. It is zero for tips without
 *   force. It is available on one process only;
 * - `RelativeError` (double), if the response stores its error: the estimated relative error of
 *   Force, blended like the force. It is 0 without contact and NaN beyond range. It is available on
 *   one process only.
 *
 * The force blends the curves of the triangle's three vertices by area coordinates (Mahvash and
 * Hayward 2002, eqs. 3 and 4). vtkContactSettings selects the form of the blend, the surface and
 * the friction. A setting out of its range is an error, even if the selected model does not use the
 * setting. vtkHapticSession and the C interface (palpate.h) have the same settings and give bitwise
 * equal results for the same tips.
 *
 * One warning for each state of the body lists the defects of the mesh: triangles that wound inward
 * or against their neighbours and were reversed; triangles that are ignored because they occur
 * twice, have no area or have a coordinate that is not finite; edges of more than two triangles,
 * which count as border. Open borders are allowed. Points of open borders that coincide are joined.
 * A surface that is not a body, such as a sheet with two sides, is an error.
 *
 * Times: TIME_STEPS contains the steps of body and tips. DATA_TIME_STEP is that of the tips.
 *
 * **Several processes** (Controller): each process may have a piece of the body and tips. The
 * contacts are those with the whole body, also along a polyline across seams. Every tip is returned
 * on the process that has it as input. ContactCell is then the cell of the piece (without its ghost
 * cells) on the process that the additional array `ContactRank` (int, -1 without contact) names.
 * Each process gathers the part of the body around its own tips. The result equals that of one
 * process except for the last bits, because normals of several triangles are summed in another
 * order. The warnings about the mesh, and the reversal of triangles, refer to these parts of the
 * body. An error on one process is an error on all. All processes must update the filter. With
 * Coupled all tips must be on one process; otherwise it is an error.
 *
 * Input other than vtkPolyData (a volume, composite data) is an error that names vtkBodySurface.
 *
 * Cost: the kernel's copy of the body is built once per change of the body, O(n log n), with
 * progress. Each of many tips then takes 0.5 to 1 µs. Independent tips are sorted so that
 * neighbours follow one another, and are computed in parallel by vtkSMPTools. The bits do not
 * depend on the order of the tips or on the number of threads. Each thread temporarily needs about
 * 220 bytes for each of up to 262144 tips.
 *
 * @code{.py}
 * probe = palpate.vtkToolContactProbe()
 * probe.SetInputData(0, body)                          # with a response
 * probe.SetTipConnection(tips.GetOutputPort())         # points, mm
 * probe.SetFrictionCoefficient(0.3)                    # for polylines
 * probe.Update()
 * forces = probe.GetOutput().GetPointData().GetArray("Force")  # N, 3 numbers per tip
 * @endcode
 */
#ifndef vtkToolContactProbe_h
#define vtkToolContactProbe_h

#include "palpateResponseModule.h" // For export macro
#include "vtkContactSettings.h"    // For its enumerations
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <memory> // For std::shared_ptr
#include <string> // For std::string

class vtkMultiProcessController;

namespace palpate
{
class BodyPiece;
class Ranks;
struct ContactBody;
} // namespace palpate

class PALPATERESPONSE_EXPORT vtkToolContactProbe : public vtkPolyDataAlgorithm
{
public:
  static vtkToolContactProbe* New();
  vtkTypeMacro(vtkToolContactProbe, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The values of ForceForm, ContactSurface and FrictionModel are those of vtkContactSettings. */
  enum ForceFormType
  {
    Paper = vtkContactSettings::Paper,
    NormalizedDirection = vtkContactSettings::NormalizedDirection,
    EnergyConsistent = vtkContactSettings::EnergyConsistent
  };
  enum ContactSurfaceType
  {
    Facets = vtkContactSettings::Facets,
    Smooth = vtkContactSettings::Smooth
  };
  enum FrictionModelType
  {
    ElastoPlastic = vtkContactSettings::ElastoPlastic,
    Dahl = vtkContactSettings::Dahl,
    ShapeDerived = vtkContactSettings::ShapeDerived
  };
  ///@}

  ///@{
  /**
   * The settings of the contact; see vtkContactSettings. Other objects may share the settings. Null
   * sets a separate object, which is also the default.
   */
  virtual void SetSettings(vtkContactSettings* settings)
  {
    if (this->Settings != settings)
    {
      this->Settings = settings;
      if (!settings)
      {
        this->Settings = vtkSmartPointer<vtkContactSettings>::New();
      }
      this->Modified();
    }
  }
  vtkContactSettings* GetSettings() { return this->Settings; }
  void SetForceForm(int form) { this->Settings->SetForceForm(form); }
  int GetForceForm() { return this->Settings->GetForceForm(); }
  void SetContactSurface(int surface) { this->Settings->SetContactSurface(surface); }
  int GetContactSurface() { return this->Settings->GetContactSurface(); }
  void SetFrictionCoefficient(double value) { this->Settings->SetFrictionCoefficient(value); }
  double GetFrictionCoefficient() { return this->Settings->GetFrictionCoefficient(); }
  void SetFrictionModel(int model) { this->Settings->SetFrictionModel(model); }
  int GetFrictionModel() { return this->Settings->GetFrictionModel(); }
  void SetTangentialStiffness(double value) { this->Settings->SetTangentialStiffness(value); }
  double GetTangentialStiffness() { return this->Settings->GetTangentialStiffness(); }
  void SetFrictionBreakaway(double share) { this->Settings->SetFrictionBreakaway(share); }
  double GetFrictionBreakaway() { return this->Settings->GetFrictionBreakaway(); }
  void SetFrictionStickRadius(double share) { this->Settings->SetFrictionStickRadius(share); }
  double GetFrictionStickRadius() { return this->Settings->GetFrictionStickRadius(); }
  void SetPoissonRatio(double ratio) { this->Settings->SetPoissonRatio(ratio); }
  double GetPoissonRatio() { return this->Settings->GetPoissonRatio(); }
  void SetRelaxationElements(int elements) { this->Settings->SetRelaxationElements(elements); }
  int GetRelaxationElements() { return this->Settings->GetRelaxationElements(); }
  void SetForceFormToPaper() { this->SetForceForm(Paper); }
  void SetForceFormToNormalizedDirection() { this->SetForceForm(NormalizedDirection); }
  void SetForceFormToEnergyConsistent() { this->SetForceForm(EnergyConsistent); }
  void SetContactSurfaceToFacets() { this->SetContactSurface(Facets); }
  void SetContactSurfaceToSmooth() { this->SetContactSurface(Smooth); }
  void SetFrictionModelToElastoPlastic() { this->SetFrictionModel(ElastoPlastic); }
  void SetFrictionModelToDahl() { this->SetFrictionModel(Dahl); }
  void SetFrictionModelToShapeDerived() { this->SetFrictionModel(ShapeDerived); }
  ///@}

  ///@{
  /**
   * Distance by which each tip is first moved inward along the normal at its closest point, mm. It
   * allows points that were picked on the surface to press. Default 0.
   */
  vtkSetMacro(Indentation, double);
  vtkGetMacro(Indentation, double);
  ///@}

  ///@{
  /** Whether tips that press at the same time interact (see the description of the class). Default
   * off. */
  vtkSetMacro(Coupled, bool);
  vtkGetMacro(Coupled, bool);
  vtkBooleanMacro(Coupled, bool);
  ///@}

  ///@{
  /** Prefix of the response arrays. Default "Response". */
  vtkSetMacro(ResponseName, std::string);
  vtkGetMacro(ResponseName, std::string);
  ///@}

  ///@{
  /**
   * The processes that each have a piece of the body. The default is the global controller at the
   * time when the filter is created. Without a controller, or with one process, the input is the
   * whole body.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  /** Sets the tips, input port 1. */
  void SetTipConnection(vtkAlgorithmOutput* tips) { this->SetInputConnection(1, tips); }
  void SetTipData(vtkDataObject* tips) { this->SetInputData(1, tips); }

  /** Returns the modification time of the filter, including that of the settings. */
  vtkMTimeType GetMTime() override;

protected:
  vtkToolContactProbe();
  ~vtkToolContactProbe() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkToolContactProbe(const vtkToolContactProbe&) = delete;
  void operator=(const vtkToolContactProbe&) = delete;

  bool PrepareBody(vtkPolyData* body);
  bool TouchPieces(const palpate::Ranks& ranks, vtkPolyData* body, vtkPolyData* tips,
    const palpate::ContactSettings& settings, vtkPolyData* output);

  vtkSmartPointer<vtkMultiProcessController> Controller;
  vtkSmartPointer<vtkContactSettings> Settings;
  bool Coupled = false;
  double Indentation = 0.0;
  std::string ResponseName = "Response";

  // The kernel's copy of the body, or of the piece of this process, and the state of the body from
  // which the copy was made.
  std::shared_ptr<const palpate::ContactBody> Body;
  std::shared_ptr<const palpate::BodyPiece> Piece;
  vtkPolyData* BodySource = nullptr;
  vtkMTimeType BodyTime = 0;
  std::string BodyResponse;
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkContactSettings
 * @brief how a contact feels: form of the force, surface, friction
 *
 * vtkToolContactProbe, vtkToolTouch and vtkHapticSession give the same force at the same tip if
 * these settings are equal. Each starts with its own; give one object to several (SetSettings), and
 * later changes reach them all. Their properties of these names, as SetFrictionCoefficient, are
 * those of the object they hold:
 *
 *     session.SetSettings(probe.GetSettings())
 *     session.SetFrictionCoefficient(0.3)        # the probe's too
 *
 * | Property | what | range | default |
 * | --- | --- | --- | --- |
 * | ForceForm | how three curves become one force | 0 to 2 | NormalizedDirection |
 * | ContactSurface | the surface that tips are projected on | 0 to 1 | Facets |
 * | FrictionModel | what a contact does before it slides | 0 to 2 | ElastoPlastic |
 * | FrictionCoefficient | Coulomb's μ; 0: no friction | finite, >= 0 | 0 |
 * | TangentialStiffness | of the stuck contact, N/mm | finite, > 0 | 1 |
 * | FrictionBreakaway | fraction of the limit below which it sticks | 0 to 1 | 0.8 |
 * | FrictionStickRadius | fraction at which half of a step is creep | > 0, >= breakaway | 0.9 |
 * | PoissonRatio | of the body, for ShapeDerived friction | 0 to 0.5 | 0.5 |
 * | RelaxationElements | how finely a body that relaxes is felt | 0 to 32 | 16 |
 *
 * Set... accepts any value, as one may make sense only with the next: GetFault tells, in words,
 * what is out of its range, even if the chosen model does not use it. A filter or session with such
 * settings reports those words as its error and does nothing. A filter reads them when it updates,
 * a session at Start and ApplyChanges.
 *
 * GetTable gives all of this as numbers and words, for a user interface.
 */
#ifndef vtkContactSettings_h
#define vtkContactSettings_h

#include "Contact/ContactSettings.h"
#include "palpateResponseModule.h" // For export macro
#include "vtkObject.h"

#include <string> // For std::string

class vtkTable;

class PALPATERESPONSE_EXPORT vtkContactSettings : public vtkObject
{
public:
  static vtkContactSettings* New();
  vtkTypeMacro(vtkContactSettings, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Values of ForceForm: how the curves f_i of a triangle's vertices, with normals U_i and area
   * coordinates n_i, become one force.
   */
  enum ForceFormType
  {
    /// Σ n_i f_i U_i as printed (Mahvash and Hayward 2002, eq. 3); since the blended normal is
    /// shorter than 1, the force loses up to h²/(6R²) inside a facet of size h.
    Paper = 0,
    /// Σ n_i f_i along the normalised Σ n_i U_i.
    NormalizedDirection = 1,
    /// The gradient of the energy Σ n_i e_i, e_i = ∫ f_i dδ, along the normal of the surface: a
    /// closed path within one contact neither gains nor loses energy.
    EnergyConsistent = 2
  };

  /// Values of ContactSurface.
  enum ContactSurfaceType
  {
    Facets = 0, ///< the triangles
    /// One patch per triangle through its vertices and the response's normals there, with
    /// continuous normals across edges; for bodies that are round where the mesh has facets.
    Smooth = 1
  };

  /// Values of FrictionModel: what a contact does before it slides at μ times the normal force.
  enum FrictionModelType
  {
    /// It sticks elastically with TangentialStiffness, creeps as it nears the limit, and does not
    /// creep below FrictionBreakaway of it (Hayward and Armstrong 2000).
    ElastoPlastic = 0,
    Dahl = 1, ///< creeps from the first displacement on, and so drifts under any changing load
              /// From the stored response f(δ) itself, Q(u) = μ [f(δ) - f(δ - u/(μc))], c =
              /// (2-ν)/(2(1-ν)), slides at u = μcδ (Jaeger 1998; Ciavarella 1998); only μ and
              /// PoissonRatio.
    ShapeDerived = 2
  };

  ///@{
  /** How three curves become one force. Default NormalizedDirection. */
  void SetForceForm(int form)
  {
    this->Assign(this->Values.form, static_cast<palpate::ForceForm>(form));
  }
  int GetForceForm() { return static_cast<int>(this->Values.form); }
  ///@}

  ///@{
  /** The surface that tips are projected on. Default Facets. */
  void SetContactSurface(int surface)
  {
    this->Assign(this->Values.surface, static_cast<palpate::ContactSurface>(surface));
  }
  int GetContactSurface() { return static_cast<int>(this->Values.surface); }
  ///@}

  ///@{
  /** What a contact does before it slides. Default ElastoPlastic. */
  void SetFrictionModel(int model)
  {
    this->Assign(this->Values.friction.model, static_cast<palpate::FrictionModel>(model));
  }
  int GetFrictionModel() { return static_cast<int>(this->Values.friction.model); }
  ///@}

  ///@{
  /** Coulomb's μ, finite and >= 0. Default 0: no friction. */
  void SetFrictionCoefficient(double coefficient)
  {
    this->Assign(this->Values.friction.coefficient, coefficient);
  }
  double GetFrictionCoefficient() { return this->Values.friction.coefficient; }
  ///@}

  ///@{
  /**
   * Stiffness of the stuck contact, N/mm, finite and > 0. Default 1. In a servo loop of period T at
   * a device of damping b it should not exceed 2b/T. Not used by ShapeDerived.
   */
  void SetTangentialStiffness(double stiffness)
  {
    this->Assign(this->Values.friction.tangentialStiffness, stiffness);
  }
  double GetTangentialStiffness() { return this->Values.friction.tangentialStiffness; }
  ///@}

  ///@{
  /**
   * ElastoPlastic only. Breakaway: fraction of the sliding limit up to which the contact is
   * elastic, 0 to 1, default 0.8; at 0 it creeps under any load. StickRadius: fraction at which
   * half of a further displacement is creep, positive and no less than the breakaway, default 0.9.
   */
  void SetFrictionBreakaway(double share) { this->Assign(this->Values.friction.breakaway, share); }
  double GetFrictionBreakaway() { return this->Values.friction.breakaway; }
  void SetFrictionStickRadius(double share)
  {
    this->Assign(this->Values.friction.stickRadius, share);
  }
  double GetFrictionStickRadius() { return this->Values.friction.stickRadius; }
  ///@}

  ///@{
  /** Poisson's ratio of the body, 0 to 0.5. Default 0.5. Only used by ShapeDerived friction. */
  void SetPoissonRatio(double ratio) { this->Assign(this->Values.friction.poissonRatio, ratio); }
  double GetPoissonRatio() { return this->Values.friction.poissonRatio; }
  ///@}

  ///@{
  /**
   * Number of parallel elements of a relaxing contact, each of which touches and separates by
   * itself, 0 to 32. Default 16: within 0.9 % of the largest force, whatever the tool and its path;
   * 8: 3 %; 0: 12 %, a single element, the quasi-linear law. vtkResponseChoice says how many a
   * tolerance needs. No effect where nothing relaxes.
   */
  void SetRelaxationElements(int elements)
  {
    this->Assign(this->Values.relaxationElements, elements);
  }
  int GetRelaxationElements() { return this->Values.relaxationElements; }
  ///@}

  /** What is out of its range, "FrictionCoefficient must be finite and not negative, but is -1"; ""
   * if nothing is. */
  std::string GetFault();

  /**
   * A row per setting: Name, Unit, Minimum (excluded where IncludesMinimum is 0), IncludesMinimum,
   * Maximum (infinite where there is none), Default, Values (the names of an enumeration, with
   * spaces between them, from 0 on) and Help.
   */
  static void GetTable(vtkTable* table);

#ifndef __VTK_WRAP__
  ///@{
  /** All at once, for C++. */
  void SetKernel(const palpate::ContactSettings& settings);
  const palpate::ContactSettings& GetKernel() const
  {
    return this->Values;
  }
  ///@}
#endif

protected:
  vtkContactSettings();
  ~vtkContactSettings() override;

private:
  vtkContactSettings(const vtkContactSettings&) = delete;
  void operator=(const vtkContactSettings&) = delete;

  template <class Value>
  void Assign(Value& held, Value value)
  {
    if (held != value)
    {
      held = value;
      this->Modified();
    }
  }

  palpate::ContactSettings Values;
};

#endif

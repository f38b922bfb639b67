// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkContactSettings
 * @brief settings of a contact: form of the force, surface, friction
 *
 * vtkToolContactProbe, vtkToolTouch and vtkHapticSession give the same force at the same tip if
 * these settings are equal. Each of these classes starts with its own settings object. If several
 * of them share one object (SetSettings), later changes apply to all. vtkToolContactProbe also has
 * the properties below, such as SetFrictionCoefficient. Its functions change its settings object.
 *
 * | Property | meaning | range | default |
 * | --- | --- | --- | --- |
 * | ForceForm | how three curves are combined into one force | 0 to 2 | NormalizedDirection |
 * | ContactSurface | the surface on which tips are projected | 0 to 1 | Facets |
 * | FrictionModel | behaviour of a contact before it slides | 0 to 2 | ElastoPlastic |
 * | FrictionCoefficient | Coulomb's μ; 0 disables friction | finite, >= 0 | 0 |
 * | TangentialStiffness | stiffness of the sticking contact, N/mm | finite, > 0 | 1 |
 * | FrictionBreakaway | fraction of the limit below which the contact sticks | 0 to 1 | 0.8 |
 * | FrictionStickRadius | fraction at which half of a step is creep | > 0, >= breakaway | 0.9 |
 * | PoissonRatio | Poisson's ratio of the body, for ShapeDerived friction | 0 to 0.5 | 0.5 |
 * | RelaxationElements | number of elements of a contact on a body that relaxes | 0 to 32 | 16 |
 *
 * The Set functions accept any value, because a value may be valid only together with another value
 * that is set later. GetFault describes a value that is out of its range, even if the selected
 * model does not use the value. A filter or session with invalid settings reports this description
 * as its error and does nothing. A filter reads the settings when it updates. A session reads them
 * at Start and ApplyChanges.
 *
 * GetTable returns this table as numbers and text, for a user interface.
 *
 * @code{.py}
 * settings = palpate.vtkContactSettings()
 * settings.SetForceForm(palpate.vtkContactSettings.EnergyConsistent)
 * probe.SetSettings(settings)
 * session.SetSettings(settings)
 * settings.SetFrictionCoefficient(0.3)                 # changes probe and session
 * print(settings.GetFault())                           # "" if all values are valid
 * @endcode
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
   * Values of ForceForm. The curves f_i of a triangle's vertices, with normals U_i and area
   * coordinates n_i, are combined into one force.
   */
  enum ForceFormType
  {
    /// Σ n_i f_i U_i as printed (Mahvash and Hayward 2002, eq. 3). The blended normal is shorter
    /// than 1. Therefore the force inside a facet is too small, by a relative amount of up to
    /// h²/(6R²), where h is the size of the facet and R the radius of curvature.
    Paper = 0,
    /// Σ n_i f_i along the direction of Σ n_i U_i, normalised.
    NormalizedDirection = 1,
    /// The gradient of the energy Σ n_i e_i, with e_i = ∫ f_i dδ, along the normal of the surface.
    /// A closed path within one contact neither gains nor loses energy.
    EnergyConsistent = 2
  };

  /// Values of ContactSurface.
  enum ContactSurfaceType
  {
    Facets = 0, ///< the flat triangles of the mesh
    /// One patch per triangle. The patch passes through the vertices and has the normals of the
    /// response there. The normals are continuous across edges. Use this surface for round bodies
    /// with a faceted mesh.
    Smooth = 1
  };

  /// Values of FrictionModel, which is the behaviour of a contact before it slides. It slides at μ
  /// times the normal force.
  enum FrictionModelType
  {
    /// The contact sticks elastically with TangentialStiffness, and creeps near the limit. It does
    /// not creep below the fraction FrictionBreakaway of the limit (Hayward and Armstrong 2000).
    ElastoPlastic = 0,
    /// The contact creeps at any displacement. Therefore it drifts under any changing load.
    Dahl = 1,
    /// The friction is derived from the stored response f(δ): Q(u) = μ [f(δ) - f(δ - u/(μc))], c =
    /// (2-ν)/(2(1-ν)). The contact slides at u = μcδ (Jaeger 1998; Ciavarella 1998). The model uses
    /// only μ and PoissonRatio.
    ShapeDerived = 2
  };

  ///@{
  /** How three curves are combined into one force. Default NormalizedDirection. */
  void SetForceForm(int form)
  {
    this->Assign(this->Values.form, static_cast<palpate::ForceForm>(form));
  }
  int GetForceForm() { return static_cast<int>(this->Values.form); }
  ///@}

  ///@{
  /** The surface on which tips are projected. Default Facets. */
  void SetContactSurface(int surface)
  {
    this->Assign(this->Values.surface, static_cast<palpate::ContactSurface>(surface));
  }
  int GetContactSurface() { return static_cast<int>(this->Values.surface); }
  ///@}

  ///@{
  /** Behaviour of a contact before it slides. Default ElastoPlastic. */
  void SetFrictionModel(int model)
  {
    this->Assign(this->Values.friction.model, static_cast<palpate::FrictionModel>(model));
  }
  int GetFrictionModel() { return static_cast<int>(this->Values.friction.model); }
  ///@}

  ///@{
  /** Coulomb's μ, finite and >= 0. Default 0, which means no friction. */
  void SetFrictionCoefficient(double coefficient)
  {
    this->Assign(this->Values.friction.coefficient, coefficient);
  }
  double GetFrictionCoefficient() { return this->Values.friction.coefficient; }
  ///@}

  ///@{
  /**
   * Stiffness of the sticking contact, N/mm, finite and > 0. Default 1. In a servo loop of period
   * T, with a device of damping b, it should not exceed 2b/T. ShapeDerived does not use it.
   */
  void SetTangentialStiffness(double stiffness)
  {
    this->Assign(this->Values.friction.tangentialStiffness, stiffness);
  }
  double GetTangentialStiffness() { return this->Values.friction.tangentialStiffness; }
  ///@}

  ///@{
  /**
   * Parameters of ElastoPlastic; other models do not use them. FrictionBreakaway is the fraction of
   * the sliding limit up to which the contact is elastic, 0 to 1, default 0.8. At 0 the contact
   * creeps under any load. FrictionStickRadius is the fraction of the sliding limit at which half
   * of a further displacement is creep. It is positive and not below FrictionBreakaway, default
   * 0.9.
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
  /** Poisson's ratio of the body, 0 to 0.5. Default 0.5. Only ShapeDerived friction uses it. */
  void SetPoissonRatio(double ratio) { this->Assign(this->Values.friction.poissonRatio, ratio); }
  double GetPoissonRatio() { return this->Values.friction.poissonRatio; }
  ///@}

  ///@{
  /**
   * Number of parallel elements of a relaxing contact, 0 to 32. Each element touches and separates
   * independently. With 16 elements (default), the error is within 0.9 % of the largest force, for
   * any tool and path. With 8 elements it is within 3 %. 0 means a single element, which is the
   * quasi-linear law, with an error within 12 %. vtkResponseChoice computes the number that a
   * tolerance requires. The setting has no effect if the body does not relax.
   */
  void SetRelaxationElements(int elements)
  {
    this->Assign(this->Values.relaxationElements, elements);
  }
  int GetRelaxationElements() { return this->Values.relaxationElements; }
  ///@}

  /**
   * Returns a description of a setting that is out of its range, for example "Friction Coefficient
   * must be finite and not negative, but is -1". Returns "" if all settings are valid.
   */
  std::string GetFault();

  /**
   * Fills a table with a row per setting. The columns are Name; Unit; Minimum; IncludesMinimum,
   * which is 0 if the minimum itself is excluded; Maximum, which is infinite if there is no limit;
   * Default; Values, the names of an enumeration, separated by spaces and starting at 0; and Help.
   */
  static void GetTable(vtkTable* table);

#ifndef __VTK_WRAP__
  ///@{
  /** Sets or gets all settings at once, for C++. */
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

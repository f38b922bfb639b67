// SPDX-License-Identifier: BSD-3-Clause
// clang-format off
/**
 * @class vtkContactTool
 * @brief a rigid tool of revolution, and its law of contact with an elastic half-space
 *
 * The tool is pressed `deflection` mm deep, along its axis and without friction, into a half-space
 * of reduced modulus E* = E/(1-ν²). The units are mm, N and MPa. Half angles are in degrees from
 * the axis.
 *
 * | Shape         | parameters    | profile f(r)            | radius a or depth δ       | force F                                              |
 * |---------------|---------------|-------------------------|---------------------------|------------------------------------------------------|
 * | Flat          | Radius a      | 0, wall at a            | a                         | 2 a E* δ                                             |
 * | Paraboloid    | Radius R      | r²/2R                   | a = √(Rδ)                 | 4/3 E* √R δ^1.5                                      |
 * | Sphere, exact | Radius R      | R - √(R²-r²), wall at R | δ = (a/2) ln((R+a)/(R-a)) | E* [(a²+R²)/2 ln((R+a)/(R-a)) - aR]                  |
 * | Cone          | HalfAngle α   | r cot α                 | a = (2/π) tan α δ         | (2/π) E* tan α δ²                                    |
 * | TruncatedCone | Radius b, α   | (r-b) cot α beyond b    | δ = a A cot α             | E* cot α [a²A + bq]                                  |
 * | BluntedCone   | Radius R, α   | sphere to b = R cos α   | δ = a [L + A cot α]       | 2E* (aδ - ½ [(a²-R²) L + Ra - qR/sin α + a²A cot α]) |
 * | RoundedFlat   | Radius b, R_e | (r-b)²/2R_e beyond b    | δ = (a/R_e) (q - bA)      | E* [(4a²-b²) q - 3a²bA]/(3R_e)                       |
 * | PowerLaw      | Exponent n, B | B r^n                   | δ = κ B a^n               | 2n/(n+1) E* a δ                                      |
 * | Profile       | points (r, f) | straight, then a wall   | δ = Σ m_i a A_i           | 2E* (aδ - ½ Σ m_i [a²A_i - r_i q_i])                 |
 *
 * Radius is the radius of the flat end (a or b), the tip (R) or the sphere (R). R_e is EdgeRadius,
 * B the Coefficient, α the HalfAngle. Beyond b, BluntedCone continues along the sphere's tangent. A
 * = arccos(b/a), q = √(a²-b²), L = ln[(R+a)/(R sin α+q)], κ = (√π/2) n Γ(n/2)/Γ((n+1)/2). In the
 * row Profile, m_i is the change of slope at r_i. (Hertz 1882; Sneddon 1965; Popov and Hess 2015.)
 * For every shape dF/dδ = 2 E* a. The strain is measured by a/R if the tip has a radius R
 * (Paraboloid, Sphere, BluntedCone), otherwise by δ/a.
 *
 * **Profiles.** For points taken from a smooth tool, the error of the law falls with the square of
 * their spacing. The formulas hold for one full circle of contact. Beyond a certain depth
 * (GetDepthLimit), a tool that is not convex (a shoulder, a groove, a second ring) would touch
 * outside this circle. If it is pressed deeper, every Get function reports an error that names the
 * deflection and the radius, and returns NaN. A ring that is lower than the tip is an error at any
 * depth.
 *
 * **The sphere in Mahvash and Hayward (2002), Table 1.** The table prints the force as 4/3 √(R E*)
 * δ^1.5, with E* under the root. The correct form is that of Paraboloid, 4/3 E* √R δ^1.5, because
 * the force on a linear elastic body is linear in its modulus. Only this form has the unit N (MPa ·
 * mm^½ · mm^1.5). Paraboloid is Hertz's approximation of a sphere, which is accurate if a << R. At
 * a/R = 0.4 it is 1.7 % too stiff at equal depth. For the 3.2 mm sphere of that paper at 12 N, it
 * gives a/R = 1. Sphere is exact at every depth within linear elasticity.
 *
 * A deflection <= 0 gives 0, and NaN gives NaN. An invalid tool or argument (a radius that is not
 * positive, a half angle outside 0..90, an exponent outside 1..100, E* <= 0, ν outside 0..0.5)
 * reports an error and gives NaN. Small strain is assumed: see vtkToolContactResponse, Validity.
 *
 * Cost: force, stiffness and contact radius take less than a microsecond; for Profile, less than a
 * microsecond per ten points. For shapes without a closed form (all except Flat, Paraboloid and
 * Cone), pressure and outer displacement are integrals with about 100 nodes. They take 3 µs; for
 * Profile, 3 µs per point. Get functions of one object must not run concurrently with its Set
 * functions.
 *
 * @code{.py}
 * tool = palpate.vtkContactTool()
 * tool.SetSpecification("sphere:6.35")                 # radius in mm
 * reduced = 0.05 / (1 - 0.45**2)                       # E*, MPa, of E = 0.05 MPa and ν = 0.45
 * force = tool.GetForce(1.0, reduced)                  # N, 1 mm deep
 * radius = tool.GetContactRadius(1.0)                  # mm
 * @endcode
 */
// clang-format on
#ifndef vtkContactTool_h
#define vtkContactTool_h

#include "palpateResponseModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <memory> // For std::unique_ptr
#include <string> // For std::string

namespace palpate
{
class AxisymmetricTool;
struct ToolSpecification;
} // namespace palpate

class vtkPoints;

class PALPATERESPONSE_EXPORT vtkContactTool : public vtkObject
{
public:
  static vtkContactTool* New();
  vtkTypeMacro(vtkContactTool, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Values of Shape.
  enum ShapeType
  {
    Flat = 0,
    Paraboloid = 1,
    Sphere = 2,
    Cone = 3,
    TruncatedCone = 4,
    BluntedCone = 5,
    RoundedFlat = 6,
    PowerLaw = 7,
    Profile = 8
  };

  ///@{
  /** Shape of the tool. Default Sphere. */
  vtkSetMacro(Shape, int);
  vtkGetMacro(Shape, int);
  void SetShapeToFlat() { this->SetShape(Flat); }
  void SetShapeToParaboloid() { this->SetShape(Paraboloid); }
  void SetShapeToSphere() { this->SetShape(Sphere); }
  void SetShapeToCone() { this->SetShape(Cone); }
  void SetShapeToTruncatedCone() { this->SetShape(TruncatedCone); }
  void SetShapeToBluntedCone() { this->SetShape(BluntedCone); }
  void SetShapeToRoundedFlat() { this->SetShape(RoundedFlat); }
  void SetShapeToPowerLaw() { this->SetShape(PowerLaw); }
  void SetShapeToProfile() { this->SetShape(Profile); }
  ///@}

  ///@{
  /**
   * Radius of Flat, radius of the tip of Sphere, Paraboloid and BluntedCone, or radius of the flat
   * part of TruncatedCone and RoundedFlat, mm, > 0. Default 5.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Half angle of any cone (Cone, TruncatedCone, BluntedCone), degrees from the axis, between 0 and
   * 90. Default 60.
   */
  vtkSetMacro(HalfAngle, double);
  vtkGetMacro(HalfAngle, double);
  ///@}

  ///@{
  /** Radius of the rounded edge of RoundedFlat, mm, > 0. Default 1. */
  vtkSetMacro(EdgeRadius, double);
  vtkGetMacro(EdgeRadius, double);
  ///@}

  ///@{
  /**
   * Exponent n of PowerLaw, 1 to 100. Default 2. Below 1 the tip would be a cusp of infinite slope.
   * Above 100 the tool is nearly a flat punch.
   */
  vtkSetMacro(Exponent, double);
  vtkGetMacro(Exponent, double);
  ///@}

  ///@{
  /**
   * Coefficient B of PowerLaw, mm^(1-n), > 0. The default 0.1 gives, with n = 2, a paraboloid with
   * a radius of 5 mm.
   */
  vtkSetMacro(Coefficient, double);
  vtkGetMacro(Coefficient, double);
  ///@}

  ///@{
  /**
   * The most important dimension of the tool: the half angle of a Cone (degrees), otherwise the
   * radius (mm). If HasSize is false (PowerLaw, Profile), SetSize has no effect and GetSize returns
   * 0.
   */
  void SetSize(double size);
  double GetSize();
  bool HasSize();
  bool IsSizeAngle();
  ///@}

  ///@{
  /**
   * Points of Profile, mm. x = r is the distance from the axis, increasing. y = f(r) >= 0 is the
   * height above the tip. The first point is (0, 0). z is ignored. The points are not copied. Call
   * Modified() of the points after changing them.
   */
  virtual void SetProfile(vtkPoints* points);
  vtkPoints* GetProfilePoints();
  ///@}

  ///@{
  /** Sets the profile point by point. Does not change the points given to SetProfile. */
  void AddProfilePoint(double r, double f);
  void RemoveAllProfilePoints();
  ///@}

  /**
   * The tool as text: "flat:R", "paraboloid:R", "sphere:R", "cone:DEGREES", "truncated:R,DEGREES",
   * "blunted:R,DEGREES", "rounded:R,EDGE", "power:EXPONENT,COEFFICIENT", "profile:FILE.csv" or
   * "profile:r1,f1;r2,f2;…" (mm). A file has a line r_mm,f_mm per point. GetSpecification returns a
   * profile in the last form, so that a stored response does not depend on a file. If the text or
   * the file is invalid, SetSpecification reports an error, returns false and changes nothing. If
   * the tool is invalid, GetSpecification reports an error and returns "".
   */
  bool SetSpecification(const std::string& specification);
  std::string GetSpecification();

  /**
   * Returns a description of the tool for captions, for example "sphere, radius 6.35 mm". Returns
   * "" if the tool is invalid.
   */
  std::string GetDescription();

  /** Returns the force, N, at a deflection (mm) into a half-space of reduced modulus E* (MPa). */
  double GetForce(double deflection, double reducedModulus);
  /** Returns the stiffness dF/dδ = 2 E* a, N/mm. */
  double GetStiffness(double deflection, double reducedModulus);
  /** Returns the contact radius a, mm. */
  double GetContactRadius(double deflection);
  /**
   * Returns the contact pressure at distance r (mm) from the axis, MPa. It is 0 outside the
   * contact. It is +inf at the rim of Flat, the apex of Cone and the edge of TruncatedCone. For
   * Profile, it is +inf at each convex corner in contact, -inf at each concave corner in contact,
   * and +inf at the wall of the tool.
   */
  double GetPressure(double r, double deflection, double reducedModulus);
  /**
   * Computes the displacement of the surface at distance r (mm) from the axis, inside and outside
   * the contact, mm. u[0] is the radial component, > 0 outward. u[1] is the normal component, > 0
   * into the body. In Python, `u` is a list of two numbers that is filled in place.
   */
  void GetSurfaceDisplacement(double r, double deflection, double poissonRatio, double u[2]);

  /**
   * Returns the depth (mm) beyond which the tool would touch the body outside the circle of
   * contact, so that no force is defined. It is +inf for all shapes except a Profile that is not
   * convex.
   */
  double GetDepthLimit();

  /**
   * Returns the height of the tool's surface above its tip at distance r from the axis, mm. The
   * height is +inf beyond the wall of the tool.
   */
  double GetProfile(double r);

  /**
   * Returns the tool for the kernels. If a parameter is invalid, reports an error and returns null.
   * This object owns the returned tool, which is valid until this object changes.
   */
  const palpate::AxisymmetricTool* GetKernel();
  /** Returns the reason why the kernel is missing, or "". Does not report an error. */
  std::string FindFault();

  /** Returns the modification time of this object, including that of the profile's points. */
  vtkMTimeType GetMTime() override;

protected:
  vtkContactTool();
  ~vtkContactTool() override;

private:
  vtkContactTool(const vtkContactTool&) = delete;
  void operator=(const vtkContactTool&) = delete;

  palpate::ToolSpecification MakeSpecification();
  const palpate::AxisymmetricTool* GetKernelFor(double deflection);
  bool CheckModulus(double reducedModulus);

  int Shape = Sphere;
  double Radius = 5.0;
  double HalfAngle = 60.0;
  double EdgeRadius = 1.0;
  double Exponent = 2.0;
  double Coefficient = 0.1;
  vtkSmartPointer<vtkPoints> ProfilePoints;
  std::unique_ptr<palpate::AxisymmetricTool> Kernel;
  vtkMTimeType KernelTime = 0;
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkContactTool
 * @brief a rigid tool of revolution, and what it feels on an elastic half-space
 *
 * The tool is pressed `deflection` mm deep, along its axis, without friction, into a half-space of
 * reduced modulus E* = E/(1-ν²). Units mm, N, MPa; half angles in degrees from the axis.
 *
 * | Shape | parameters | contact radius a | force F |
 * |---|---|---|---|
 * | Flat | Radius a | a | 2 a E* δ |
 * | Paraboloid | Radius R, f = r²/2R | √(Rδ) | 4/3 E* √R δ^1.5 |
 * | Sphere | Radius R, exact | δ = (a/2) ln((R+a)/(R-a)) | E* [(a²+R²)/2 ln((R+a)/(R-a)) - aR] |
 * | Cone | HalfAngle α | (2/π) tan α δ | (2/π) E* tan α δ² |
 *
 * (Hertz 1882; Sneddon 1965; Popov and Hess 2015.) For every shape dF/dδ = 2 E* a.
 *
 * **On the sphere of Mahvash and Hayward (2002), Table 1.** It stands there as 4/3 √(R E*) δ^1.5,
 * with E* under the root. The right form is 4/3 E* √R δ^1.5: a force is linear in the modulus of a
 * linear elastic body, and only then are the units N (MPa · mm^½ · mm^1.5). That form is the
 * Paraboloid here. It is Hertz's approximation of a sphere, good while a << R: at a/R = 0.4 it is
 * 1.7 % too stiff at equal depth, and the paper's own 3.2 mm sphere at 12 N has a/R = 1 by it.
 * Sphere is exact at every depth of linear elasticity.
 *
 * A deflection <= 0 gives 0, NaN gives NaN. An invalid tool or argument (a radius that is not
 * positive, a half angle outside 0..90, E* <= 0, ν outside 0..0.5) reports an error and gives NaN.
 * Small strain is assumed: see vtkToolContactResponse, Validity.
 *
 * Cost: below a microsecond for closed forms; pressure and outer displacement of Sphere integrate
 * with 64 points (about 2 µs). Get... functions of one object must not run concurrently with Set...
 */
#ifndef vtkContactTool_h
#define vtkContactTool_h

#include "palpateResponseModule.h" // For export macro
#include "vtkObject.h"

#include <memory> // For std::unique_ptr
#include <string> // For std::string

namespace palpate
{
class AxisymmetricTool;
}

class PALPATERESPONSE_EXPORT vtkContactTool : public vtkObject
{
public:
  static vtkContactTool* New();
  vtkTypeMacro(vtkContactTool, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ShapeType
  {
    Flat = 0,
    Paraboloid = 1,
    Sphere = 2,
    Cone = 3
  };

  ///@{
  /** The shape. Default Sphere. */
  vtkSetMacro(Shape, int);
  vtkGetMacro(Shape, int);
  void SetShapeToFlat() { this->SetShape(Flat); }
  void SetShapeToParaboloid() { this->SetShape(Paraboloid); }
  void SetShapeToSphere() { this->SetShape(Sphere); }
  void SetShapeToCone() { this->SetShape(Cone); }
  ///@}

  ///@{
  /** Radius of the flat, sphere or paraboloid, mm, > 0. Default 5. */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /** Half angle of the cone, degrees from its axis, between 0 and 90. Default 60. */
  vtkSetMacro(HalfAngle, double);
  vtkGetMacro(HalfAngle, double);
  ///@}

  /**
   * The tool in writing: "flat:R", "paraboloid:R", "sphere:R" (mm), "cone:DEGREES". Setting reports
   * an error, returns false and changes nothing when the text is wrong. Getting an invalid tool's
   * specification reports an error and returns "".
   */
  bool SetSpecification(const std::string& specification);
  std::string GetSpecification();

  /** The tool in words, for captions: "sphere, radius 6.35 mm". Of an invalid tool "". */
  std::string GetDescription();

  /** Force, N, at a deflection (mm) into a half-space of reduced modulus E* (MPa). */
  double GetForce(double deflection, double reducedModulus);
  /** dF/dδ = 2 E* a, N/mm. */
  double GetStiffness(double deflection, double reducedModulus);
  /** Contact radius a, mm. */
  double GetContactRadius(double deflection);
  /**
   * Contact pressure at distance r (mm) from the axis, MPa: 0 outside the contact, +inf at the rim
   * of Flat and the apex of Cone.
   */
  double GetPressure(double r, double deflection, double reducedModulus);
  /**
   * Displacement of the surface at distance r (mm) from the axis, inside and outside the contact:
   * u[0] radial, > 0 outward, u[1] normal, > 0 into the body, mm. In Python `u` is a list of two,
   * filled in place.
   */
  void GetSurfaceDisplacement(double r, double deflection, double poissonRatio, double u[2]);

  /** Height of the tool's surface above its tip at distance r from the axis, mm. */
  double GetProfile(double r);

  /**
   * The tool for the kernels; null, after an error, if a parameter is invalid. Owned by this
   * object, valid until it is changed.
   */
  const palpate::AxisymmetricTool* GetKernel();

protected:
  vtkContactTool();
  ~vtkContactTool() override;

private:
  vtkContactTool(const vtkContactTool&) = delete;
  void operator=(const vtkContactTool&) = delete;

  bool CheckModulus(double reducedModulus);

  int Shape = Sphere;
  double Radius = 5.0;
  double HalfAngle = 60.0;
  std::unique_ptr<palpate::AxisymmetricTool> Kernel;
  vtkMTimeType KernelTime = 0;
};

#endif

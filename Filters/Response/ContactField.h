// SPDX-License-Identifier: BSD-3-Clause
#ifndef ContactField_h
#define ContactField_h

#include "palpateResponseModule.h" // For export macro

#include "Mechanics/Tools/AxisymmetricTool.h" // For palpate::SurfaceDisplacement
#include "Contact/TriangleProjection.h"       // For palpate::Vector3
#include "vtkType.h"                          // For vtkIdType

#include <functional> // For std::function
#include <memory>     // For std::shared_ptr
#include <string>     // For std::string
#include <vector>     // For std::vector

class vtkDataArray;
class vtkPolyData;

namespace palpate
{
class LayerKernel;

/// One contact, as its field needs it. Body frame, mm, N.
struct FieldContact
{
  vtkIdType cell = -1;     ///< of the body; -1: no contact
  double deflection = 0.0; ///< the whole of it, local and global
  double force = 0.0;      ///< along the normal, > 0 out of the body; only bends global modes
  Vector3 point = Vector3::Zero();
  Vector3 normal = Vector3::Zero(); ///< outward, unit
};

/// What is the same for all contacts.
struct FieldSettings
{
  std::string responseName = "Response";
  double poissonRatio = 0.45;
  double reach = 0.0; ///< mm; 0: no end but that of the normals
};

/**
 * How the surface of a body moves around one contact: what vtkContactDeflection gives each point
 * and the vertex shader of the display evaluates per vertex.
 *
 *   u(x) = fade [u_r(r) t - u_z(r) n] + Σ_k w_k φ_k(x)
 *
 * Local part: u_r, u_z of the tool on a half-space, or on the layer that is under the contact
 * (LayerSurface), at the local deflection; n is the contact normal, r the distance along the
 * surface and t the tangent away from the contact at x (SurfacePatch.h).
 *
 * Global part, on bodies whose response has a global compliance and that carry its modes (point
 * arrays `GlobalMode0`... φ_k, field array `GlobalModeSign` s_k, see vtkElasticCompliance):
 * w_k = -F s_k (n·φ_k(X)), X the contact. The local deflection is what the modes leave of the
 * whole, δ - F Σ s_k (n·φ_k(X))², so that the surface meets the tool. Without modes the local part
 * is drawn at the whole deflection.
 *
 * Fade: 1 where reach is 0. Otherwise exactly 1 within 3/4 of the reach and 50° of the contact
 * normal, and smoothly down to 0 at the reach and at 60°: no edge is seen where the field ends.
 *
 * Cost: some µs on a half-space, 1 to 2 ms on a layer.
 */
class PALPATERESPONSE_EXPORT ContactField
{
public:
  static constexpr double CosineOfEnd = 0.5;          ///< 60°: beyond, the body is no half-space
  static constexpr double CosineOfFade = 0.642787610; ///< 50°
  static constexpr double FadeBegin = 0.75;           ///< of the reach

  ContactField() = default; ///< of no contact: zero
  /// `body` has triangles alone; the cell of the contact is one of them. `tool` must outlive the
  /// field. `kernel` is that of the last layer, kept by the caller since it is costly to make.
  ContactField(vtkPolyData* body, const AxisymmetricTool& tool, const FieldContact& contact,
    const FieldSettings& settings, std::shared_ptr<const LayerKernel>& kernel);

  /// u_r and u_z at r >= 0, not faded.
  SurfaceDisplacement local(double r) const;
  /// `cosine`: of the angle between the point's normal and the contact's.
  double fade(double r, double cosine) const;
  /// One per mode of globalModeArrays(); none without a global part.
  const std::vector<double>& modeWeights() const { return this->Weights; }

  bool isEmpty() const { return !this->Law; }
  double localDeflection() const { return this->Deflection; }
  double contactRadius() const { return this->Radius; } ///< mm; 0 if empty
  double reach() const { return this->Reach; }
  /// Where the tool has an edge within the contact, so that u_z has a kink there, mm; 0: nowhere.
  double kinkRadius() const { return this->Kink; }
  /// Why there is no local part though there is contact; "" if there is one.
  const std::string& fault() const { return this->Fault; }

private:
  void bend(vtkPolyData* body, const FieldContact& contact, const std::string& responseName);
  void press(const AxisymmetricTool& tool, double thickness, int base, double poissonRatio,
    std::shared_ptr<const LayerKernel>& kernel);

  std::function<SurfaceDisplacement(double)> Law;
  std::vector<double> Weights;
  double Deflection = 0.0;
  double Radius = 0.0;
  double Reach = 0.0;
  double Kink = 0.0;
  std::string Fault;
};

/// The modes that bend with the response `name` of a body: none unless it has a global compliance.
PALPATERESPONSE_EXPORT std::vector<vtkDataArray*> globalModeArrays(
  vtkPolyData* body, const std::string& name);

/// Which of the point arrays that bend a body or tell the layer under it has not a value per point,
/// naming it, or "". Where this is not asked, such an array is taken for none.
PALPATERESPONSE_EXPORT std::string checkFieldArrays(vtkPolyData* body, const std::string& name);
} // namespace palpate

#endif

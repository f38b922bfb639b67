// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactField_h
#define palpate_ContactField_h

#include "Laws/SurfacePatch.h"
#include "Mechanics/Layers/LayerKernel.h"
#include "Mechanics/Layers/LayerStack.h"
#include "Mechanics/PalpateExport.h"
#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Laws/NearField.h"

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace palpate
{
/// One contact for its field. Body frame, mm, N.
struct FieldContact
{
  std::int64_t cell = -1;  ///< of the body; -1: no contact
  double deflection = 0.0; ///< local and global together
  double force = 0.0;      ///< along the normal, > 0 out of the body: for modes and near field
  Vector3 point = Vector3::Zero();
  Vector3 normal = Vector3::Zero(); ///< outward, unit
  /// Depth of the tip, mm, where another tool holds the body against this one, so that its dent is
  /// less than the deflection.
  double depth = std::numeric_limits<double>::infinity();
};

/// The triangle of a contact, with the data of its corners.
struct FieldTriangle
{
  /// A global mode of the body at the corners.
  struct Mode
  {
    double sign = 0.0; ///< s_k
    std::array<Vector3, 3> vectors = { Vector3::Zero(), Vector3::Zero(), Vector3::Zero() };
  };
  /// mm
  std::array<Vector3, 3> corners = { Vector3::Zero(), Vector3::Zero(), Vector3::Zero() };
  std::array<double, 3> thickness{}; ///< of the layer, mm; 0 on a half-space
  LayerBase base = LayerBase::Bonded;
  LayerStack stack;               ///< if the layer is the first of one; otherwise without layers
  std::array<double, 3> second{}; ///< thickness of its second layer, mm; 0: that of `stack`
  std::vector<Mode> modes;        ///< none if the response has no global motion
  std::array<NearField, 3> near;  ///< of radius 0 if the response is not of true shape
};

/// Settings common to all contacts.
struct FieldSettings
{
  double poissonRatio = 0.45; ///< 0 to 0.5
  double reach = 0.0;         ///< mm; 0: limited by the normals alone
};

/**
 * The displacement of a body's surface around one contact:
 *
 *   u(x) = fade [u_r(r) t - (u_z(r) + v(d)) n] + Σ_k w_k φ_k(x)
 *
 * Local part: u_r, u_z of the tool on a half-space, or on the layer that is under the contact
 * (LayerSurface), at the local deflection; n is the contact normal, r the distance along the
 * surface and t the tangent away from the contact at x (SurfacePatch.h).
 *
 * Near part, on a body of true shape, where the response has R (NearField.h): the effect of an
 * edge, a base or an inclusion near the contact on a half-space's dent. d is the vector from the
 * contact in its tangent plane, of length r,
 *     v = (1 - m) v₀ + m F R(d), m = 1 - (2/π) (asin(a/r) - (a/r) √(1 - (a/r)²)) beyond a, else 0:
 * within the contact the surface is that of the tool; outside, it is what a flat punch that cannot
 * tilt leaves of a tilt (Johnson 1985, § 5.4 (f)). The local deflection is then that of the same
 * force on a half-space of the E* at the contact, and v₀ the rest of δ without that and the modes.
 *
 * Global part, by the modes φ_k of the body (GlobalModes.h) with their signs s_k: w_k = -F s_k
 * (n·φ_k(X)), X the contact. The local deflection is what the modes leave of the whole, δ - F Σ s_k
 * (n·φ_k(X))², so that the surface meets the tool. Without modes and R the local part is that at
 * the whole deflection, or at the depth of the tip.
 *
 * Fade: 1 where reach is 0. Otherwise exactly 1 within 3/4 of the reach and 50° of the contact
 * normal, and smoothly down to 0 at the reach and at 60°, so that the field has no visible edge.
 *
 * Cost: some µs on a half-space, 1 to 2 ms on a layer.
 */
class PALPATE_EXPORT ContactField
{
public:
  static constexpr double CosineOfEnd = 0.5;          ///< 60°: beyond, the body is no half-space
  static constexpr double CosineOfFade = 0.642787610; ///< 50°
  static constexpr double FadeBegin = 0.75;           ///< of the reach

  ContactField() = default; ///< of no contact: zero
  /// `tool` must outlive the field. `kernel` is that of the last layer, kept by the caller since
  /// making one is expensive.
  ContactField(const FieldTriangle& triangle, const AxisymmetricTool& tool,
    const FieldContact& contact, const FieldSettings& settings,
    std::shared_ptr<const LayerKernel>& kernel);

  /// u_r and u_z at r >= 0, not faded.
  SurfaceDisplacement local(double r) const;
  /// `cosine`: of the angle between the point's normal and the contact's.
  double fade(double r, double cosine) const;
  /// v: the further inward displacement of the surface, mm, at `away` from the contact in its
  /// tangent plane.
  double near(const Vector3& away) const;
  /// F R, mm, and v₀; of radius 0 where there is none.
  const NearField& nearField() const { return this->Near; }
  double nearDepth() const { return this->NearDepth; }
  /// One per mode of the triangle; none without a global part.
  const std::vector<double>& modeWeights() const { return this->Weights; }

  bool isEmpty() const { return !this->Law; }
  double localDeflection() const { return this->Deflection; }
  double contactRadius() const { return this->Radius; } ///< mm; 0 if empty
  double reach() const { return this->Reach; }
  /// Radius of an edge of the tool within the contact, where u_z has a kink, mm; 0: none.
  double kinkRadius() const { return this->Kink; }
  /// Why there is no local part though there is contact; "" if there is one.
  const std::string& fault() const { return this->Fault; }

private:
  void bend(const FieldTriangle& triangle, const Vector3& weights, const FieldContact& contact);
  void surround(const AxisymmetricTool& tool, const FieldTriangle& triangle, const Vector3& weights,
    double force);
  void press(const AxisymmetricTool& tool, const FieldTriangle& triangle, const Vector3& weights,
    double poissonRatio, std::shared_ptr<const LayerKernel>& kernel);

  std::function<SurfaceDisplacement(double)> Law;
  NearField Near;
  double NearDepth = 0.0;
  std::vector<double> Weights;
  double Deflection = 0.0;
  double Radius = 0.0;
  double Reach = 0.0;
  double Kink = 0.0;
  std::string Fault;
};

/// View of a mode's vectors, 3 numbers per point.
using ModeSpan = std::variant<const float*, const double*>;

/// Continues a patch across the seams of pieces: enters the points reached on other pieces. False
/// when nothing is left to visit on any.
using SeamCrossing = std::function<bool(SurfacePatch&)>;

/**
 * Adds the displacement by a field to `displacement`, 3 floats (mm) per point of the patch's mesh:
 * the modes at every point, the local part at those of the patch, whose start points have been
 * entered. `modes`: at least as many as the field has weights. False if a mode's displacement is
 * not finite. The same bits for any number of threads.
 */
PALPATE_EXPORT bool contactField(const ContactField& field, const Vector3& normal,
  const std::vector<ModeSpan>& modes, SurfacePatch& patch, std::size_t points, float* displacement,
  const SeamCrossing& cross = {});
} // namespace palpate

#endif

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
/// Input of the displacement field of one contact, in the body's frame, mm and N.
struct FieldContact
{
  std::int64_t cell = -1; ///< cell of the body that contains the contact; -1 if there is no contact
  double deflection = 0.0; ///< sum of the local and the global deflection
  /// Force along the normal, N, positive out of the body. Used for the modes and the near field.
  double force = 0.0;
  Vector3 point = Vector3::Zero();
  Vector3 normal = Vector3::Zero(); ///< unit vector, outward
  /// Depth of the tip, mm, if another tool also lowers or supports the surface; otherwise infinite.
  /// In that case the depth of the dent differs from the deflection.
  double depth = std::numeric_limits<double>::infinity();
};

/// The triangle of a contact, and the data at its corners.
struct FieldTriangle
{
  /// The displacement by a global mode of the body at the corners of the triangle.
  struct Mode
  {
    double sign = 0.0; ///< sign s_k of the mode (GlobalModes.h)
    std::array<Vector3, 3> vectors = { Vector3::Zero(), Vector3::Zero(), Vector3::Zero() };
  };
  /// Positions of the corners, mm.
  std::array<Vector3, 3> corners = { Vector3::Zero(), Vector3::Zero(), Vector3::Zero() };
  std::array<double, 3> thickness{}; ///< thickness of the layer, mm; 0 on a half-space
  LayerBase base = LayerBase::Bonded;
  /// The stack that contains the first layer; it has no layers if the body is not a stack.
  LayerStack stack;
  /// Thickness of the second layer, mm. If 0, the thickness in `stack` is used.
  std::array<double, 3> second{};
  std::vector<Mode> modes;       ///< empty if the response has no global motion
  std::array<NearField, 3> near; ///< its radius is 0 if the response has no near field
};

/// Settings common to all contacts.
struct FieldSettings
{
  double poissonRatio = 0.45; ///< 0 to 0.5
  /// Radius of the field, mm; with 0, the field is limited only by the angle between normals.
  double reach = 0.0;
};

/**
 * The displacement of a body's surface around one contact:
 *
 *   u(x) = fade [u_r(r) t - (u_z(r) + v(d)) n] + Σ_k w_k φ_k(x)
 *
 * Local part: u_r and u_z are the radial and the normal displacement by the tool on a half-space,
 * or on the layer under the contact (LayerSurface), at the local deflection. n is the contact
 * normal, r the distance along the surface, and t the tangent at x that points away from the
 * contact (SurfacePatch.h).
 *
 * Near part: used on a body of true shape if the response has a near field R (NearField.h). It is
 * the effect of an edge, a base or an inclusion near the contact on the dent in a half-space. d is
 * the vector of length r from the contact in its tangent plane, and
 *     v = (1 - m) v₀ + m F R(d), m = 1 - (2/π) (asin(a/r) - (a/r) √(1 - (a/r)²)) for r > a, else 0.
 * Within the contact radius a the surface has the shape of the tool. Outside, m is the fraction of
 * a surface tilt that remains at the distance r from a flat punch that cannot tilt (Johnson 1985, §
 * 5.4 (f)). The local deflection is that of a half-space with the E* at the contact under the same
 * force. v₀ is δ minus the local deflection and minus the deflection of the modes.
 *
 * Global part: the modes φ_k of the body with their signs s_k (GlobalModes.h) have the weights w_k
 * = -F s_k (n·φ_k(X)), where X is the contact point. The local deflection is δ - F Σ s_k
 * (n·φ_k(X))², so that the deformed surface touches the tool. Without modes and without R, the
 * local part is evaluated at the whole deflection, or at the depth of the tip if that depth is
 * smaller.
 *
 * Fade: 1 if the reach is 0. Otherwise it is exactly 1 within 3/4 of the reach and within 50° of
 * the contact normal. It decreases smoothly to 0 at the reach and at 60°, so that the field has no
 * visible edge.
 *
 * Cost: a few µs on a half-space, 1 to 2 ms on a layer.
 */
class PALPATE_EXPORT ContactField
{
public:
  /// Cosine of 60°. At larger angles between the normals the body does not behave like a
  /// half-space.
  static constexpr double CosineOfEnd = 0.5;
  static constexpr double CosineOfFade = 0.642787610; ///< cosine of 50°
  static constexpr double FadeBegin = 0.75; ///< fraction of the reach at which the fade begins

  ContactField() = default; ///< creates an empty field, which is zero everywhere
  /// `tool` must outlive the field. `kernel` receives the kernel of the most recent layer. The
  /// caller should keep it from one field to the next, because the construction of a kernel is
  /// expensive.
  ContactField(const FieldTriangle& triangle, const AxisymmetricTool& tool,
    const FieldContact& contact, const FieldSettings& settings,
    std::shared_ptr<const LayerKernel>& kernel);

  /// Returns u_r and u_z at the distance r >= 0, without the fade.
  SurfaceDisplacement local(double r) const;
  /// Returns the factor `fade`. `cosine` is the cosine of the angle between the normal at the point
  /// and the contact normal.
  double fade(double r, double cosine) const;
  /// Returns v, the additional inward displacement of the surface, mm. `away` is the vector from
  /// the contact to the point, in the tangent plane of the contact.
  double near(const Vector3& away) const;
  /// Returns the near field multiplied by the force (F R, mm). Its radius is 0 if the body has no
  /// near field. nearDepth() returns v₀, mm.
  const NearField& nearField() const { return this->Near; }
  double nearDepth() const { return this->NearDepth; }
  /// Returns one weight per mode of the triangle; empty if there is no global part.
  const std::vector<double>& modeWeights() const { return this->Weights; }

  bool isEmpty() const { return !this->Law; }
  double localDeflection() const { return this->Deflection; }
  double contactRadius() const { return this->Radius; } ///< mm; 0 for an empty field
  double reach() const { return this->Reach; }
  /// Radius of an edge of the tool within the contact, mm; 0 if there is no such edge. At this
  /// radius the slope of u_z is discontinuous.
  double kinkRadius() const { return this->Kink; }
  /// Returns the reason why a contact has no local part; "" if it has one.
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

/// View of the displacement vectors of a mode, 3 numbers per point.
using ModeSpan = std::variant<const float*, const double*>;

/// Continues a patch across the seams between pieces: adds the points that were reached on other
/// pieces. Returns false if no piece has points left to visit.
using SeamCrossing = std::function<bool(SurfacePatch&)>;

/**
 * Adds the displacement of a field to `displacement`, 3 floats (mm) per point of the patch's mesh.
 * The modes act at every point; the local part acts at the points of the patch. The caller must
 * first add the start points to the patch. `modes` must have at least as many modes as the field
 * has weights. Returns false if the displacement by a mode is not finite. The result is bit for bit
 * the same for any number of threads.
 */
PALPATE_EXPORT bool contactField(const ContactField& field, const Vector3& normal,
  const std::vector<ModeSpan>& modes, SurfacePatch& patch, std::size_t points, float* displacement,
  const SeamCrossing& cross = {});
} // namespace palpate

#endif

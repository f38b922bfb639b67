// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactSettings_h
#define palpate_ContactSettings_h

namespace palpate
{
/// The combination of the curves of a triangle's three vertices into one force.
enum class ForceForm : int
{
  /// Σ n_i f_i U_i (Mahvash and Hayward 2002, eq. 3). The sum of unit normals is shorter than 1, so
  /// the force loses about h²/(6 R²) in the middle of a facet of size h on a body of radius R.
  Paper,
  /// (Σ n_i f_i) along the normalised Σ n_i U_i: magnitude and direction are blended separately. On
  /// the smooth surface the force acts along the normal of that surface, so that equal responses
  /// have an energy.
  NormalizedDirection,
  /// -∇ of the energy Σ n_i e_i, e_i = ∫f_i: Σ n_i f_i n - Σ e_i ∇n_i, where n is the normal of the
  /// surface. Closed loops within one contact neither gain nor lose energy for any responses.
  /// An exception are facets with different responses: the energy itself jumps from facet to facet.
  EnergyConsistent
};

/// The surface on which the tip is projected.
enum class ContactSurface : int
{
  Facets, ///< the triangles as they are
  Smooth  ///< one patch per triangle through its vertices and their normals, G1 across edges
};

/// The friction model; see Friction.h.
enum class FrictionModel : int
{
  ElastoPlastic, ///< Hayward and Armstrong 2000: stick, creep, slide; no drift below breakaway
  Dahl, ///< as ElastoPlastic, but every displacement causes creep, so that the contact drifts
  ShapeDerived ///< computed from the stored response (Jaeger; Ciavarella); parameters: only μ and ν
};

/// The friction model and its parameters.
struct FrictionSettings
{
  FrictionModel model = FrictionModel::ElastoPlastic;
  /// Coulomb's μ, >= 0; 0: frictionless.
  double coefficient = 0.0;
  /// Stiffness of the stuck contact, σ₀, N/mm, > 0. A servo loop of period T at a device of damping
  /// b is stable only for σ₀ <= 2b/T. Not used by ShapeDerived.
  double tangentialStiffness = 1.0;
  /// Fraction of the sliding limit below which a stuck contact is elastic and does not creep, 0 to
  /// 1. With 0, Hayward and Armstrong's z⁸ applies, which creeps a little under any load. Only used
  /// by ElastoPlastic.
  double breakaway = 0.8;
  /// Fraction of the limit at which half of a further displacement is creep, z_st/z_max, >=
  /// breakaway. Only used by ElastoPlastic.
  double stickRadius = 0.9;
  /// Poisson's ratio of the body, 0 to 0.5. Only used by ShapeDerived.
  double poissonRatio = 0.5;
};

/// Settings of a ToolContact. Ranges, names and texts are in SettingTable.h. Values from outside,
/// also enumerations, may be out of range until faultOfContact() has checked them.
struct ContactSettings
{
  ForceForm form = ForceForm::EnergyConsistent;
  ContactSurface surface = ContactSurface::Smooth;
  FrictionSettings friction = {};
  /// Number of parallel elements for a body that relaxes, 0 to MostRelaxationElements; 0: the
  /// quasi-linear law. More elements are more accurate when the tool moves out again: within 0.9 %
  /// of the largest force with 16, 3 % with 8, 12 % with 0.
  int relaxationElements = 16;
  static constexpr int MostRelaxationElements = 32;
};
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactSettings_h
#define palpate_ContactSettings_h

namespace palpate
{
/// Formula that combines the curves of a triangle's three vertices into one force. n_i are the area
/// coordinates, f_i the forces of the curves, U_i the unit normals at the vertices.
enum class ForceForm : int
{
  /// Σ n_i f_i U_i (Mahvash and Hayward 2002, eq. 3). The sum of the unit normals is shorter
  /// than 1. In the middle of a facet of size h on a body of radius R, the force is therefore too
  /// small by the fraction h²/(6 R²).
  Paper,
  /// Σ n_i f_i along the normalised Σ n_i U_i: magnitude and direction are interpolated separately.
  /// On the smooth surface the force acts along the normal of that surface. Then the force has an
  /// energy if the responses are equal.
  NormalizedDirection,
  /// The negative gradient of the energy Σ n_i e_i, e_i = ∫f_i: Σ n_i f_i n - Σ e_i ∇n_i, where n
  /// is the normal of the surface. On closed paths within one contact the force neither gains nor
  /// loses energy, whatever the responses. The exception are facets with different responses,
  /// because the energy jumps from facet to facet.
  EnergyConsistent
};

/// The surface on which the tip is projected to find the contact point.
enum class ContactSurface : int
{
  Facets, ///< the plane triangles
  Smooth  ///< one curved patch per triangle through its vertices and their normals, G1 across edges
};

/// The friction model; see Friction.h.
enum class FrictionModel : int
{
  ElastoPlastic, ///< Hayward and Armstrong 2000: stick, creep, slide; no drift below `breakaway`
  Dahl, ///< as ElastoPlastic, but every displacement causes creep, so that a stuck contact drifts
  /// Computed from the stored response (Jaeger; Ciavarella); uses only `coefficient` and
  /// `poissonRatio`.
  ShapeDerived
};

/// The friction model and its parameters.
struct FrictionSettings
{
  FrictionModel model = FrictionModel::ElastoPlastic;
  /// Coulomb's friction coefficient μ, >= 0; 0 for a frictionless contact.
  double coefficient = 0.0;
  /// Tangential stiffness of the stuck contact, σ₀, N/mm, > 0. A servo loop of period T with a
  /// device of damping b is stable only for σ₀ <= 2b/T. Not used by ShapeDerived.
  double tangentialStiffness = 1.0;
  /// Fraction of Coulomb's limit below which a stuck contact is elastic and does not creep, 0 to 1.
  /// With 0, the z⁸ law of Hayward and Armstrong applies, which creeps slightly under any load.
  /// Only used by ElastoPlastic.
  double breakaway = 0.8;
  /// Fraction of Coulomb's limit at which half of any further displacement is creep (z_st/z_max),
  /// >= breakaway. Only used by ElastoPlastic.
  double stickRadius = 0.9;
  /// Poisson's ratio of the body, 0 to 0.5. Only used by ShapeDerived.
  double poissonRatio = 0.5;
};

/// Settings of a ToolContact. Their ranges, names and texts are in SettingTable.h. Values given by
/// a user, including enumerations, may be out of range until faultOfContact() has checked them.
struct ContactSettings
{
  ForceForm form = ForceForm::NormalizedDirection;
  ContactSurface surface = ContactSurface::Facets;
  FrictionSettings friction = {};
  /// Number of parallel elements for a body that relaxes, 0 to MostRelaxationElements. With 0, the
  /// quasi-linear law applies. More elements are more accurate while the tool moves out: the error
  /// is at most 0.9 % of the largest force with 16 elements, 3 % with 8 and 12 % with 0.
  int relaxationElements = 16;
  static constexpr int MostRelaxationElements = 32;
};
} // namespace palpate

#endif

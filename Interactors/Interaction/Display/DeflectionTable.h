// SPDX-License-Identifier: BSD-3-Clause
#ifndef DeflectionTable_h
#define DeflectionTable_h

#include <array>

namespace palpate
{
class ContactField;

/**
 * The local part of a ContactField, sampled for a shader. The table contains u_r, u_z and their
 * slopes, for linear interpolation. The values do not include the fade of the field.
 *
 * The parameter is q = r/(a + √(a²-r²)) within the contact and q = a/(r + √(r²-a²)) outside. These
 * are the half-angle forms of r = a sin φ and r = a/sin φ. As functions of r, u_r and u_z have
 * vertical tangents at r = a; as functions of q they are smooth on both sides of the kink and of r
 * = a. There are three segments: the tip, up to the kink of the tool (q = 1/2 if the tool has no
 * kink); the rest of the contact; and the outside, from the reach (q = far) to a (q = 1).
 *
 * The slopes du/dr are differences over two edge lengths of the mesh, as are the normals of a
 * displaced mesh. Therefore a step at the rim of a flat punch does not flicker.
 *
 * The error is 1e-3 of the deflection, and 1e-4 for a half-space under a tool without edges.
 */
struct DeflectionTable
{
  static constexpr int Intervals = 48;
  static constexpr int Segments = 3;
  static constexpr int Nodes = Segments * (Intervals + 1);
  using Node = std::array<float, 4>; ///< u_r and u_z, mm, followed by the derivative of each

  /// Samples the field. All values are zero if the field is empty. `reach` and `edge` (edge length
  /// of the mesh) are in mm.
  DeflectionTable(const ContactField& field, double reach, double edge);

  float radius = 0.0F; ///< contact radius a, mm
  float kink = 0.5F;   ///< q at the end of the first segment, the kink of the tool
  float far = 0.0F;    ///< q at the reach of the field
  std::array<Node, Nodes> nodes{};

private:
  std::array<double, 2> at(double r) const;
  double distanceOf(int node) const;
};
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_ContinuityMeasures_h
#define palpate_testing_ContinuityMeasures_h

#include "Contact/ContactBody.h"
#include "Contact/ContactSettings.h"
#include "SampleBodies.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

/**
 * Continuity, energy conservation and accuracy of the force of a meshed body, compared with the
 * smooth body from which it was meshed. Lengths in mm, forces in N.
 */
namespace palpate::testing
{
/// A body without facets: its surface as a function of the direction.
struct SmoothBody
{
  std::string name;
  std::function<Vector3(const Vector3& direction)> point;
  std::function<Vector3(const Vector3& direction)> normal; ///< outward, unit
  double smallestRadius; ///< smallest radius of convex curvature; tips stay above this depth
  double meanRadius;     ///< mean distance from the centre, which converts lengths into angles
};
SmoothBody smoothSphere(double radius);
SmoothBody smoothEllipsoid(const Vector3& axes);
SmoothBody smoothBumpySphere(); ///< the body of BumpySphere.h, radius 100 mm

/// F = 10 δ^1.5; a Stiffening multiplies it by a factor at each place.
double responseForce(double depth);
using Stiffening = std::function<double(const Vector3& direction)>;
double uniform(const Vector3& direction);
/// A factor between 0.5 and 1.5 that varies over lengths of about the radius of the body.
double varied(const Vector3& direction);

enum class MeshNormals
{
  Exact,        ///< normals of the smooth body
  AngleWeighted ///< computed from the mesh, as if no better normals were known
};

/// The grid of an octahedron with 8 cuts² triangles, projected onto the body. The triangles differ
/// in size and shape.
struct MeshedBody
{
  MeshedBody(const SmoothBody& body, int cuts, const Stiffening& stiffening,
    MeshNormals normals = MeshNormals::Exact, const EdgeTerms& edges = {});

  const SmoothBody shape;
  const Stiffening factor;
  double meanEdge;
  double longestEdge;
  std::unique_ptr<ContactBody> contact;
};

/// Largest |ΔF|/f between two tips 1e-9 mm apart. Includes all changes of triangle of a tip at
/// `depth` below the smooth body on a path of `length` mm around it. Each change is located by
/// bisection.
double forceJump(
  const MeshedBody& body, const ContactSettings& settings, double depth, double length);

/// Largest |∮F·dx| / ∮|F||dx| of `loops` closed paths: down at one place, about 6 mm sideways with
/// changing depth, up at another place, back outside. `reaching` is the largest depth.
double loopEnergy(
  const MeshedBody& body, const ContactSettings& settings, double reaching, int loops);

/// Largest error of the force at `tips` places at `depth` below the smooth body, each the first
/// tick of a contact: the relative error of the magnitude, and the error of the direction, rad.
struct ForceError
{
  double size = 0.0;
  double direction = 0.0;
};
ForceError forceError(
  const MeshedBody& body, const ContactSettings& settings, double depth, int tips);
} // namespace palpate::testing

#endif

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
/// A body without facets: its surface over the unit sphere.
struct SmoothBody
{
  std::string name;
  std::function<Vector3(const Vector3& direction)> point;
  std::function<Vector3(const Vector3& direction)> normal; ///< outward, unit
  double smallestRadius; ///< of convex curvature; tips do not reach this depth
  double meanRadius;     ///< from the centre, to convert lengths into angles
};
SmoothBody smoothSphere(double radius);
SmoothBody smoothEllipsoid(const Vector3& axes);
SmoothBody smoothBumpySphere(); ///< of BumpySphere.h, radius 100 mm

/// F = 10 δ^1.5 times a factor at each place.
double responseForce(double depth);
using Stiffening = std::function<double(const Vector3& direction)>;
double uniform(const Vector3& direction);
/// A factor between 0.5 and 1.5 that varies over about the radius of the body.
double varied(const Vector3& direction);

enum class MeshNormals
{
  Exact,        ///< of the smooth body
  AngleWeighted ///< of the mesh, as without better normals
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

/// The largest |ΔF|/f between two tips 1e-9 mm apart. It includes all changes of triangle of a tip
/// `depth` under the smooth body on `length` mm of a path around it; each is located by bisection.
double forceJump(
  const MeshedBody& body, const ContactSettings& settings, double depth, double length);

/// The largest |∮F·dx| over ∮|F||dx| of `loops` closed paths: down at one place, about 6 mm
/// sideways with changing depth, up at another, back outside. `reaching` is their greatest depth.
double loopEnergy(
  const MeshedBody& body, const ContactSettings& settings, double reaching, int loops);

/// The largest error of the force at `tips` places `depth` under the smooth body, each the first
/// tick of its contact: the relative error of its magnitude, and the error of its direction, rad.
struct ForceError
{
  double size = 0.0;
  double direction = 0.0;
};
ForceError forceError(
  const MeshedBody& body, const ContactSettings& settings, double depth, int tips);
} // namespace palpate::testing

#endif

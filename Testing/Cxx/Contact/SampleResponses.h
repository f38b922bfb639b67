// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_SampleResponses_h
#define palpate_testing_SampleResponses_h

#include "ContractCurve.h"
#include "Contact/ContactSettings.h"
#include "Contact/ResponseField.h"
#include "SampleBodies.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace palpate
{
struct ContactBody;
}

namespace palpate::testing
{
/**
 * Response arrays of a body with 8 samples and the exponent 1.5; this object owns them. Initially
 * every point has the law F = 10 δ^1.5 (N, mm) up to 2 mm and the normal +z.
 */
struct ResponseStore
{
  explicit ResponseStore(std::size_t points);
  /// Sets radial normals, for spheres around the origin.
  void normalsFromPoints(const Surface& body);
  /// Sets a random monotone curve, range (1 … 2 mm) and normal for each point.
  void randomize(unsigned seed);
  /// As randomize(), but keeps the normals.
  void randomizeCurves(unsigned seed);

  ResponseArrays arrays() const;
  ContractCurve curveOf(std::size_t point) const;
  Vector3 normalOf(std::size_t point) const;

  std::vector<float> force;
  std::vector<float> stiffness;
  std::vector<float> normal;
  std::vector<float> range;
  std::vector<std::uint8_t> status;
  EdgeTerms edges; ///< no edge law by default
};

std::unique_ptr<ContactBody> contactBody(const Surface& surface, const ResponseArrays& responses);
std::unique_ptr<ContactBody> contactBody(const Surface& surface, const ResponseStore& store);

/// Settings with every combination of force form and contact surface, without friction.
std::vector<ContactSettings> allFormsAndSurfaces();

/// Edge law for a sphere of 5 mm, which has the curve of a ResponseStore, at ν = 0.45.
EdgeTerms sphereOverEdges();

/// A body with F = 10 δ^1.5 everywhere and the point normals of the surface's mesh.
std::unique_ptr<ContactBody> uniformBody(const Surface& surface, const EdgeTerms& edges = {});

/// Copies the point normals of the surface's mesh to the store.
void takeMeshNormals(ResponseStore& store, const Surface& surface);
} // namespace palpate::testing

#endif

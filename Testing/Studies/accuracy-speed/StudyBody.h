// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Contact/ContactBody.h"
#include "SampleBodies.h"
#include "StudyLaw.h"

#include <memory>
#include <string>
#include <vector>

namespace palpate::testing
{
/// A meshed body with a Spot at each of its points.
class StudyBody
{
public:
  StudyBody(Surface surface, std::vector<Spot> spots);

  const Surface& surface() const { return this->Mesh; }
  const std::vector<Spot>& spots() const { return this->Spots; }
  /// The Spot at a place between the points of a triangle of packed().
  Spot spotAt(const TriangleCorners& corners, const Vector3& weights) const;
  std::size_t pointCount() const { return this->Mesh.points.size(); }
  double meanEdge() const { return this->MeanEdge; }

  /// Surface and index as the kernel packs them. The responses in it are placeholders.
  const ContactBody& contact() const { return *this->Contact; }
  const PackedMesh& packed() const { return this->Contact->surface; }
  /// Bytes that every method reads: surface and index.
  std::size_t meshBytes() const { return this->packed().memory() + this->Contact->tree.memory(); }

  /// The body with these curves at its points and the normals of its mesh. `tilts`: the tilt data
  /// of a tool that may be tilted.
  std::unique_ptr<ContactBody> respond(
    const SampledCurves& curves, const TiltViews& tilts = {}) const;
  /// As respond(), in the compact form with the fewest numbers that keep every curve within
  /// `tolerance`.
  std::unique_ptr<ContactBody> respondReduced(const SampledCurves& curves, double tolerance) const;

  /// Values of the points in the order of packed().
  template <class Number>
  std::vector<Number> inPackedOrder(const std::vector<double>& values) const
  {
    std::vector<Number> ordered;
    ordered.reserve(values.size());
    for (std::size_t p = 0; p < values.size(); ++p)
    {
      const auto input = this->packed().inputPoint(static_cast<std::int32_t>(p));
      ordered.push_back(static_cast<Number>(values[static_cast<std::size_t>(input)]));
    }
    return ordered;
  }

private:
  /// The arrays of a response while a body is made.
  struct Store;
  Store store(const SampledCurves& curves) const;

  Surface Mesh;
  std::vector<Spot> Spots;
  double MeanEdge = 0.0;
  std::vector<float> Normals;
  std::vector<std::uint8_t> Valid;
  std::unique_ptr<ContactBody> Contact;
};

/// The square |x|, |y| <= half of the plane z = 0, normal +z, in squares of `edge`, each cut into
/// two triangles.
Surface flatTop(double half, double edge);

/**
 * Reads a body that a script has prepared: the line "palpate-study POINTS TRIANGLES\n", then in the
 * byte order of the machine x, y, z of each point (double, mm), 1/thickness of the layer there
 * (double, 1/mm; 0 without a layer) and three indices of each triangle (int32). Throws
 * std::runtime_error with the file's name.
 */
std::unique_ptr<StudyBody> readStudyBody(const std::string& file);
} // namespace palpate::testing

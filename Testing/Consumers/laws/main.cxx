// SPDX-License-Identifier: BSD-3-Clause
// A body that the program makes itself, without VTK and without a file: its response, then a tick.
#include <Laws/BodyMaterial.h>
#include <Contact/ContactBody.h>
#include <Laws/ResponseFiller.h>
#include <Laws/ResponseLaw.h>
#include <Contact/ToolContact.h>
#include <Mechanics/Tools/ToolSpecification.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

int main()
{
  // A flat square of 200 mm that faces up, of 0.06 MPa.
  const std::vector<double> points = { -100, -100, 0, 100, -100, 0, 100, 100, 0, -100, 100, 0 };
  const std::vector<std::int32_t> triangles = { 0, 1, 2, 0, 2, 3 };
  const std::vector<float> normals = { 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1 };
  constexpr std::size_t count = 4;
  palpate::BodyMaterial material({ 0.06, 0.45, 0.0, palpate::LayerBase::Bonded, false });
  const std::string fault = material.take({}, count);
  if (!fault.empty())
  {
    std::fprintf(stderr, "%s\n", fault.c_str());
    return 1;
  }

  constexpr int samples = 8;
  constexpr double range = 2.0;
  const auto tool = palpate::makeTool({ palpate::ToolShape::Paraboloid, 4.0 });
  const palpate::ResponseLaw law(*tool, range, samples);
  std::vector<float> force(count * samples);
  std::vector<float> stiffness(count * samples);
  std::vector<float> depth(count);
  std::vector<float> validity(count);
  std::vector<unsigned char> status(count, 0);
  std::vector<unsigned char> limit(count);
  const palpate::ResponseFiller filler(*tool, law, range, 200.0,
    { samples, force.data(), stiffness.data(), depth.data(), validity.data(), status.data(),
      limit.data() });
  for (std::size_t i = 0; i < count; ++i)
  {
    filler.fill(i, material.spots().at(i), 0.0);
  }

  palpate::ResponseArrays response;
  response.points = count;
  response.samples = samples;
  response.exponent = material.bestExponent(*tool, law);
  response.force = force.data();
  response.stiffness = stiffness.data();
  response.normal = normals.data();
  response.range = depth.data();
  response.status = status.data();
  const palpate::ContactBody body(points.data(), count, triangles.data(), 2, response);
  palpate::ToolContact contact(body);
  contact.update({ 10.0, 20.0, 1.0 });
  const double felt = contact.update({ 10.0, 20.0, -1.0 }).normalForce;
  const double hertz = 4.0 / 3.0 * 0.06 / (1.0 - 0.45 * 0.45) * 2.0; // 4/3 E* √R δ^1.5
  std::printf("force %.6g N, by Hertz %.6g N\n", felt, hertz);
  return std::abs(felt - hertz) < 1e-6 * hertz ? 0 : 1; // tolerance for floats
}

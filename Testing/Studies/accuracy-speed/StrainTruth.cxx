// SPDX-License-Identifier: BSD-3-Clause
#include "StrainTruth.h"

#include "Laws/BodyMaterial.h"
#include "Laws/ResponseFiller.h"
#include "Mechanics/FiniteStrain/StrainCorrection.h"
#include "Mechanics/Files/CsvReader.h"
#include "Identification/CurvesFile.h"
#include "Mechanics/ReducedModulus.h"
#include "StoredMethods.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace palpate::testing
{
namespace
{
constexpr int StoredSamples = 8;
constexpr double PressedHalf = 10.0; // half side of the meshed face, mm
constexpr double PressedEdge = 1.0;  // mm

/// F/E* over depth, from a code with finite strain.
struct Truth
{
  std::string code;
  std::string tool;
  double thickness; ///< mm, 0: a half-space
  double ball;      ///< radius of the body, mm, 0: flat
  double ratio;     ///< Poisson's
  std::vector<double> depths;
  std::vector<double> forces;
};

/// The usable Neo-Hooke curves of the solver. Excluded are curves of another mesh or fillet, and of
/// Poisson's ratios for which a response uses the correction of another ratio.
std::vector<Truth> solved(const std::string& folder)
{
  CsvReader csv(folder + "/finite-strain/curves.csv");
  csv.header(
    { "tool", "thickness_mm", "nu", "model", "fillet_mm", "depth_mm", "force_over_modulus_mm2" },
    7);
  std::vector<Truth> found;
  while (csv.next())
  {
    const std::string tool(csv.text(0));
    const double thickness = csv.number(1);
    const double ratio = csv.number(2);
    const bool isUsual = tool == "sphere:1" || tool == "cone:60";
    if (!isUsual || csv.text(3) != "neohooke" || ratio > 0.495)
    {
      continue;
    }
    if (found.empty() || found.back().tool != tool || found.back().thickness != thickness ||
      found.back().ratio != ratio)
    {
      found.push_back({ "solver", tool, thickness, 0.0, ratio, {}, {} });
    }
    found.back().depths.push_back(csv.number(5));
    found.back().forces.push_back(csv.number(6));
  }
  if (!csv.fault().empty())
  {
    throw std::runtime_error(csv.fault());
  }
  return found;
}

Truth fromCalculix(const std::string& file, double thickness, double ball, double ratio)
{
  MeasuredCurves read;
  const std::string fault = readCurves(file, read);
  if (!fault.empty())
  {
    throw std::runtime_error(fault);
  }
  Truth truth{ "CalculiX", read.toolText, thickness, ball, ratio, {}, {} };
  const MeasuredCurve& curve = read.curves.front();
  for (std::size_t i = 0; i < curve.deflection.size(); ++i)
  {
    if (curve.deflection[i] >=
      0.04 * read.tool.Radius) // at smaller depths the contact has few nodes
    {
      truth.depths.push_back(curve.deflection[i]);
      truth.forces.push_back(curve.force[i] / reducedModulus(0.1, ratio));
    }
  }
  return truth;
}

/// Spheres on balls to δ = 0.09 R, from another finite-element code. Cavities are excluded, and ν =
/// 0, for which the global deflection of the ball is not a constant.
std::vector<Truth> balls(const std::string& file)
{
  CsvReader csv(file);
  csv.header({ "Rb_over_R(negative: cavity)", "nu", "delta_over_R", "F_fe_over_E" }, 4);
  std::vector<Truth> found;
  while (csv.next())
  {
    const double ball = csv.number(0);
    const double ratio = csv.number(1);
    if (!(ball > 2.0) || !(ratio > 0.0))
    {
      continue;
    }
    if (found.empty() || found.back().ball != ball || found.back().ratio != ratio)
    {
      found.push_back({ "another code", "sphere:1", 0.0, ball, ratio, {}, {} });
    }
    found.back().depths.push_back(csv.number(2));
    found.back().forces.push_back(csv.number(3) * (1.0 - ratio * ratio)); // F/E*
  }
  if (!csv.fault().empty())
  {
    throw std::runtime_error(csv.fault());
  }
  return found;
}

std::vector<Truth> truths(const std::string& folder)
{
  std::vector<Truth> all = solved(folder + "/Studies");
  const std::string calculix = folder + "/Studies/calculix/";
  const std::string deep = folder + "/Reference/deep/";
  all.push_back(fromCalculix(calculix + "block-sphere6.35-neohooke-deep.csv", 0.0, 0.0, 0.45));
  all.push_back(fromCalculix(deep + "calculix_block_sphere6.35_nu0.3.csv", 0.0, 0.0, 0.3));
  all.push_back(fromCalculix(deep + "calculix_block_sphere6.35_nu0.49.csv", 0.0, 0.0, 0.49));
  all.push_back(fromCalculix(calculix + "block-flat1.6-neohooke.csv", 0.0, 0.0, 0.45));
  all.push_back(fromCalculix(calculix + "layer10-sphere6.35-neohooke-deep.csv", 10.0, 0.0, 0.45));
  all.push_back(fromCalculix(calculix + "layer10-sphere20-neohooke-deep.csv", 10.0, 0.0, 0.45));
  const std::vector<Truth> curved = balls(deep + "curvature_sphere_on_ball.csv");
  all.insert(all.end(), curved.begin(), curved.end());
  return all;
}

/// The effects that a response includes.
struct Terms
{
  const char* name;
  bool curvature;
  bool strain;
};
constexpr std::array<Terms, 3> AllTerms{ Terms{ "small strain", false, false },
  Terms{ "small strain, curvature", true, false }, Terms{ "finite strain, stored", true, true } };

/// A response of the flat mesh, from Laws, and the error that it states at its samples.
struct Stored
{
  SampledCurves curves;
  std::vector<double> errors;
};

Stored store(const Truth& truth, const StudyTool& tool, std::size_t points, const Terms& terms)
{
  BodyMaterial material(
    { 1.0 - truth.ratio * truth.ratio, truth.ratio, truth.thickness, LayerBase::Bonded, false });
  std::string fault = material.take({}, points);
  std::unique_ptr<StrainCorrection> correction;
  if (terms.strain)
  {
    fault = makeStrainCorrection(*tool.shape, { StrainModel::NeoHooke, 0.0 },
      { truth.ratio, truth.ratio, truth.thickness == 0.0, truth.thickness, truth.thickness,
        LayerBase::Bonded },
      tool.range, {}, correction);
    if (!fault.empty())
    {
      throw std::runtime_error(fault);
    }
  }
  const double curvature = truth.ball > 0.0 ? 1.0 / truth.ball : 0.0;
  SurfaceShape shape;
  shape.width = truth.ball > 0.0 ? 2.0 * truth.ball : 1e6;
  shape.bound = [curvature](std::size_t) { return curvature; };
  shape.curvature = [curvature](std::size_t) { return SpotCurvature{ curvature, curvature, 0.0 }; };
  std::vector<float> force(StoredSamples * points);
  std::vector<float> stiffness(StoredSamples * points);
  std::vector<float> error(StoredSamples * points);
  std::vector<float> range(points);
  std::vector<float> validity(points);
  std::vector<unsigned char> status(points);
  std::vector<unsigned char> limit(points);
  ResponseTerms asked;
  asked.curvature = terms.curvature;
  asked.strain = correction.get();
  asked.errorTolerance = 0.05;
  const MadeResponse made = response(*tool.shape, material, tool.range, points, shape, asked,
    { StoredSamples, force.data(), stiffness.data(), range.data(), validity.data(), status.data(),
      limit.data(), error.data() });
  if (!fault.empty() || !made.complete || made.without > 0)
  {
    throw std::runtime_error("no response of " + tool.name + " " + terms.name + fault);
  }
  Stored stored;
  stored.curves.samples = StoredSamples;
  stored.curves.range = tool.range;
  stored.curves.exponent = made.exponent;
  stored.curves.force.assign(force.begin(), force.end());
  stored.curves.stiffness.assign(stiffness.begin(), stiffness.end());
  stored.errors.assign(error.begin(), error.begin() + StoredSamples);
  return stored;
}

/// Interpolates between the samples, which are evenly spaced in √δ.
double statedError(const Stored& stored, double depth)
{
  const double place = StoredSamples * std::sqrt(depth / stored.curves.range) - 1.0;
  const auto below = static_cast<std::size_t>(std::clamp(place, 0.0, StoredSamples - 2.0));
  const double part = std::clamp(place - static_cast<double>(below), 0.0, 1.0);
  return stored.errors[below] + part * (stored.errors[below + 1] - stored.errors[below]);
}

/// Largest depth of the Neo-Hooke tables. Beyond it the solver is used.
double tableEnd(const Truth& truth, double radius)
{
  return truth.thickness > 0.0           ? 0.5 * truth.thickness
    : truth.tool.rfind("sphere", 0) == 0 ? radius
                                         : std::numeric_limits<double>::infinity();
}

void studyTruth(std::ostream& stream, Truth truth, bool deep, MethodTimer* timer)
{
  StudyTool tool = studyTool(truth.tool, 1.0);
  const double radius = tool.shape->largestContactRadius();
  const double end = deep ? HUGE_VAL : tableEnd(truth, radius) * (1.0 + 1e-9);
  while (truth.depths.back() > end)
  {
    truth.depths.pop_back();
    truth.forces.pop_back();
  }
  tool.range = truth.depths.back();
  const auto body = [&]
  {
    Surface top = flatTop(PressedHalf, PressedEdge);
    std::vector<Spot> spots(top.points.size());
    return std::make_unique<StudyBody>(std::move(top), std::move(spots));
  }();
  std::vector<Stored> stored;
  MethodList methods;
  for (const Terms& terms : AllTerms)
  {
    stored.push_back(store(truth, tool, body->pointCount(), terms));
    methods.push_back(
      { hermite(terms.name, *body, stored.back().curves), body->pointCount(), body->meshBytes() });
  }
  std::vector<MethodTimes> times(methods.size());
  if (timer != nullptr)
  {
    times = timer->run(methods, flatTips(0.4 * PressedHalf, tool.range, 500, 1000));
  }
  for (std::size_t m = 0; m < methods.size(); ++m)
  {
    const auto begin = [&](const char* part) -> std::ostream&
    {
      return stream << part << ',' << truth.code << ',' << truth.tool << ',' << truth.thickness
                    << ',' << truth.ball << ',' << truth.ratio << ',' << '"' << AllTerms[m].name
                    << '"';
    };
    ContactMethod& method = *methods[m].method;
    for (std::size_t i = 0; i < truth.depths.size(); ++i)
    {
      const double depth = truth.depths[i];
      method.forget();
      const double force = method.force({ 0.0, 0.0, -depth }).z();
      begin("force") << ',' << depth << ',' << tool.shape->contactRadius(depth) << ','
                     << truth.forces[i] << ',' << force << ',' << force / truth.forces[i] - 1.0
                     << ',' << statedError(stored[m], depth) << ",,,\n";
    }
    if (timer != nullptr)
    {
      begin("time") << ",,,,,,," << times[m].hot << ',' << times[m].onset << ',' << times[m].cold
                    << '\n';
    }
  }
  stream.flush();
}
} // namespace

void studyStrain(std::ostream& stream, const std::string& folder, bool deep, MethodTimer* timer)
{
  stream << "part,code,tool,thickness_mm,ball_mm,nu,method,depth_mm,contact_radius_mm,"
            "true_force_mm2,force_mm2,error,stated_error,hot_ns,onset_ns,cold_ns\n";
  for (Truth& truth : truths(folder))
  {
    studyTruth(stream, std::move(truth), deep, timer);
  }
}
} // namespace palpate::testing

// SPDX-License-Identifier: BSD-3-Clause
#include "RandomContact.h"

#include "Laws/BodyMaterial.h"
#include "Laws/ResponseFiller.h"
#include "Strain/FiniteIndentation.h"
#include "Mechanics/FiniteStrain/StrainCorrection.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/ReducedModulus.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>

namespace palpate::testing
{
namespace
{
constexpr int Samples = 8;
constexpr int Judged[] = { 4, 6, 8 }; // sample numbers of 1/4, 9/16 and all of the depth
constexpr double Edge = 0.12;         // length of an element's edge / contact radius
constexpr double Fillet = 0.1;        // radius of the fillet at corners / contact radius
// radius of the fillet of a cone / depth; a smaller one makes a crease
constexpr double ApexFillet = 0.4;
constexpr double Wide = 1e6; // mm: no limit of the width

class Draw
{
public:
  explicit Draw(std::mt19937& random)
    : Random(random)
  {
  }
  double even(double from, double to)
  {
    return std::uniform_real_distribution<double>(from, to)(this->Random);
  }
  double byRatio(double from, double to)
  {
    return from * std::pow(to / from, this->even(0.0, 1.0));
  }
  bool chance(double probability) { return this->even(0.0, 1.0) < probability; }

private:
  std::mt19937& Random;
};

struct Tool
{
  std::string text;
  double deepest; ///< mm
  bool hasTable;  ///< true if there is a finite-strain table for a half-space
};

Tool roundTool(Draw& draw)
{
  const double deepest = draw.byRatio(0.05, 0.9);
  const double which = draw.even(0.0, 1.0);
  return which < 0.6 ? Tool{ "sphere:1", deepest, true }
    : which < 0.8
    ? Tool{ "paraboloid:1", deepest, false }
    : Tool{ joined("blunted:", draw.even(0.3, 1.0), ",", draw.even(45.0, 75.0)), deepest, false };
}

Tool coneOrSphere(Draw& draw)
{
  const double deepest = draw.byRatio(0.05, 0.9);
  return draw.chance(0.7) ? Tool{ "sphere:1", deepest, true }
                          : Tool{ joined("cone:", draw.even(50.0, 75.0)), deepest, true };
}

Tool anyTool(Draw& draw)
{
  const double deepest = draw.byRatio(0.05, 0.9);
  switch (static_cast<int>(draw.even(0.0, 8.0)))
  {
    case 0:
      return { "sphere:1", deepest, true };
    case 1:
      return { "flat:1", 0.7 * deepest, true };
    case 2:
      return { joined("cone:", draw.even(45.0, 75.0)), deepest, true };
    case 3:
      return { "paraboloid:1", deepest, false };
    case 4:
      return { joined("truncated:", draw.even(0.3, 1.0), ",", draw.even(45.0, 75.0)), 0.7 * deepest,
        false };
    case 5:
      return { joined("blunted:", draw.even(0.3, 1.0), ",", draw.even(45.0, 75.0)), deepest,
        false };
    case 6:
      return { joined("rounded:", draw.even(0.3, 1.0), ",", draw.even(0.3, 1.0)), 0.7 * deepest,
        false };
    default:
      return { joined("power:", draw.even(1.5, 4.0), ",", draw.even(0.2, 0.6)), deepest, false };
  }
}

/// A body as the law and the solver take it.
struct Body
{
  BodyMaterial::Constants material;
  double radius = 0.0; ///< radius of its surface, mm; 0: flat; negative: a cavity
};

double anyRatio(Draw& draw)
{
  return draw.even(0.0, 0.495);
}

/// A Poisson's ratio that is most often in the range of tissue.
double layersRatio(Draw& draw)
{
  return draw.even(0.3, 0.495);
}

Body drawBody(ContactFamily family, Draw& draw)
{
  Body body{ { 1.0, anyRatio(draw), 0.0, LayerBase::Bonded, false } };
  switch (family)
  {
    case ContactFamily::HalfSpace:
      break;
    case ContactFamily::Ball:
      body.radius = draw.byRatio(2.5, 40.0);
      break;
    case ContactFamily::Cavity:
      body.radius = -draw.byRatio(4.0, 40.0);
      break;
    case ContactFamily::Layer:
      body.material.poissonRatio = layersRatio(draw);
      body.material.thickness = draw.byRatio(0.5, 4.0);
      body.material.base = draw.chance(0.8) ? LayerBase::Bonded : LayerBase::Slip;
      break;
    case ContactFamily::Stack:
      body.material.poissonRatio = layersRatio(draw);
      body.material.thickness = draw.byRatio(0.15, 2.0);
      for (int more = draw.chance(0.5) ? 1 : 2; more > 0; --more)
      {
        body.material.deeper.push_back(
          { draw.byRatio(0.4, 4.0), draw.byRatio(0.1, 10.0), layersRatio(draw), false });
      }
      if (draw.chance(0.3))
      {
        body.material.halfSpace =
          StackLayer{ 1.0, draw.byRatio(0.1, 10.0), layersRatio(draw), false };
      }
      break;
  }
  return body;
}

/// Largest depth in a layer or stack: at most half of the thickness and half of the soft part.
double deepestIn(const BodyMaterial::Constants& material, double deepest)
{
  double thickness = material.thickness;
  double soft = material.thickness; // equivalent thickness, weighted by compliance, mm
  for (const StackLayer& layer : material.deeper)
  {
    thickness += layer.thickness;
    soft += layer.thickness / std::max(1.0, layer.youngsModulus);
  }
  return material.halfSpace || thickness == 0.0
    ? deepest
    : std::min(deepest, 0.45 * std::min(soft, thickness));
}

std::string inWords(const Body& body)
{
  const BodyMaterial::Constants& given = body.material;
  std::string words = joined("nu ", given.poissonRatio);
  if (given.thickness > 0.0)
  {
    words += joined("; ", given.thickness, " mm");
  }
  for (const StackLayer& layer : given.deeper)
  {
    words +=
      joined(" / ", layer.thickness, " mm E ", layer.youngsModulus, " nu ", layer.poissonRatio);
  }
  if (given.halfSpace)
  {
    words += joined(
      " / half-space E ", given.halfSpace->youngsModulus, " nu ", given.halfSpace->poissonRatio);
  }
  if (given.base == LayerBase::Slip)
  {
    words += "; slips";
  }
  return body.radius == 0.0 ? words : words + joined("; radius ", body.radius, " mm");
}

FiniteCurve solve(const Body& body, const AxisymmetricTool& tool, StrainModel model,
  const std::vector<double>& depths)
{
  const BodyMaterial::Constants& given = body.material;
  FiniteProblem problem;
  const auto add = [&](double thickness, double modulus, double ratio) {
    problem.layers.push_back({ thickness, modulus, ratio, model, 0.0 });
  };
  constexpr double endless = std::numeric_limits<double>::infinity();
  add(given.thickness > 0.0 ? given.thickness : endless, given.youngsModulus, given.poissonRatio);
  for (const StackLayer& layer : given.deeper)
  {
    add(layer.thickness, layer.youngsModulus, layer.poissonRatio);
  }
  if (given.halfSpace)
  {
    add(endless, given.halfSpace->youngsModulus, given.halfSpace->poissonRatio);
  }
  problem.slipBase = given.base == LayerBase::Slip;
  problem.contactRadius = tool.contactRadius(depths.back());
  problem.depths = depths;
  problem.edge = Edge;
  problem.bodyRadius = body.radius;
  const bool isCone = tool.forceExponent() == 2.0;
  const double fillet = isCone ? ApexFillet * depths.back() : Fillet * problem.contactRadius;
  return pressTool(ToolOutline(tool, 3.0 * problem.contactRadius, fillet), problem);
}

/// Arrays of the product's response for one point of a body.
struct Made
{
  std::vector<float> force = std::vector<float>(Samples);
  std::vector<float> stiffness = std::vector<float>(Samples);
  std::vector<float> error = std::vector<float>(Samples);
  unsigned char status = 0;
  unsigned char limit = 0;
};

Made respond(const Body& body, const AxisymmetricTool& tool, double deepest, bool curved,
  const StrainCorrection* strain)
{
  Made made;
  float range = 0.0F;
  float validity = 0.0F;
  BodyMaterial material(body.material);
  std::string fault = material.checkConstants();
  fault = fault.empty() ? material.take({}, 1) : fault;
  if (!fault.empty())
  {
    throw std::invalid_argument(fault);
  }
  const double curvature = body.radius == 0.0 ? 0.0 : 1.0 / body.radius;
  const SurfaceShape shape{ Wide, [curvature](std::size_t) { return std::abs(curvature); },
    [curvature](std::size_t) {
      return SpotCurvature{ curvature, curvature, 0.0 };
    } };
  // The tolerance has no effect here: the error of each sample is stored in any case.
  response(tool, material, deepest, 1, shape, { curved, strain, 1e-9 },
    { Samples, made.force.data(), made.stiffness.data(), &range, &validity, &made.status,
      &made.limit, made.error.data() });
  return made;
}

/// Computes the force of the tool on the body with the product's laws and with finite elements.
RandomContact judgeContact(ContactFamily family, const Body& body, const Tool& chosen)
{
  const bool isCurved = body.radius != 0.0;
  RandomContact contact{ family, chosen.text, inWords(body), {}, {} };

  ToolSpecification specification;
  if (!parseTool(chosen.text, specification, contact.fault))
  {
    return contact;
  }
  const std::unique_ptr<AxisymmetricTool> tool = makeTool(specification);
  std::vector<double> depths;
  for (const int i : Judged)
  {
    depths.push_back(chosen.deepest * i * i / (Samples * Samples));
  }
  Body flat = body;
  flat.radius = 0.0;
  const FiniteCurve linear = solve(flat, *tool, StrainModel::Linear, depths);
  const FiniteCurve finite = solve(body, *tool, StrainModel::NeoHooke, depths);
  contact.fault = linear.fault.empty() ? finite.fault : linear.fault;

  const bool isSphereOnLayer = family == ContactFamily::Layer &&
    body.material.base == LayerBase::Bonded && specification.Shape == ToolShape::Sphere &&
    chosen.deepest <= 0.5 * body.material.thickness;
  std::unique_ptr<StrainCorrection> strain;
  if (isSphereOnLayer || (body.material.thickness == 0.0 && chosen.hasTable))
  {
    const double nu = body.material.poissonRatio;
    const double h = body.material.thickness;
    const std::string fault = makeStrainCorrection(*tool, { StrainModel::NeoHooke, 0.0 },
      { nu, nu, h == 0.0, h, h, LayerBase::Bonded }, chosen.deepest, {}, strain);
    contact.fault = contact.fault.empty() ? fault : contact.fault;
  }
  const Made plain = respond(flat, *tool, chosen.deepest, false, nullptr);
  for (std::size_t k = 0; k < finite.points.size() && k < linear.points.size(); ++k)
  {
    const auto sample = static_cast<std::size_t>(Judged[k] - 1);
    const double exact =
      static_cast<double>(plain.force[sample]) * finite.points[k].force / linear.points[k].force;
    const auto judge = [&](const std::string& law, bool curved, const StrainCorrection* corrected)
    {
      const Made made = respond(body, *tool, chosen.deepest, curved, corrected);
      if (made.status == 0)
      {
        contact.forces.push_back({ law, depths[k], tool->contactRadius(depths[k]),
          static_cast<double>(made.force[sample]), exact, static_cast<double>(made.error[sample]),
          static_cast<ResponseLimit>(made.limit) });
      }
    };
    judge("small", false, nullptr);
    if (isCurved)
    {
      judge("curved", true, nullptr);
    }
    if (strain)
    {
      judge(isCurved ? "curved finite" : "finite", isCurved, strain.get());
    }
  }
  return contact;
}
} // namespace

double JudgedForce::error() const
{
  return std::abs(this->exact / this->force - 1.0);
}

RandomContact drawContact(ContactFamily family, std::mt19937& random)
{
  Draw draw(random);
  const Body body = drawBody(family, draw);
  Tool chosen = body.radius != 0.0       ? roundTool(draw)
    : family == ContactFamily::HalfSpace ? anyTool(draw)
                                         : coneOrSphere(draw);
  chosen.deepest = deepestIn(body.material, chosen.deepest);
  return judgeContact(family, body, chosen);
}

RandomContact pressOnBall(
  const std::string& tool, double deepest, double radius, double poissonRatio, double youngsModulus)
{
  const Body body{ { youngsModulus, poissonRatio, 0.0, LayerBase::Bonded, false }, radius };
  return judgeContact(ContactFamily::Ball, body, { tool, deepest, true });
}
} // namespace palpate::testing

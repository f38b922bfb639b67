// SPDX-License-Identifier: BSD-3-Clause
#include "TiltMethods.h"

#include "Contact/ToolContact.h"
#include "Laws/BodyMaterial.h"
#include "Laws/MaterialTilts.h"
#include "Mechanics/Tilt/TiltGeometry.h"
#include "Mechanics/Tilt/TiltedContact.h"
#include "TiltCircle.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace palpate::testing
{
namespace
{
constexpr double PlateHalf = 6.0; // half side of the plate, mm
constexpr double PlateEdge = 0.5;
constexpr double Ratio = 0.45;
constexpr double Modulus = 1.0 - Ratio * Ratio; // MPa; gives E* = 1
constexpr int PlateSamples = 8;

/// A plate with the response of a tool that may be tilted.
class LeaningPlate
{
public:
  LeaningPlate(const StudyTool& tool, std::vector<Spot> spots, BodyMaterial::Values values)
    : Body(flatTop(PlateHalf, PlateEdge), std::move(spots))
  {
    const std::size_t points = this->Body.pointCount();
    BodyMaterial material({ Modulus, Ratio, 0.0, LayerBase::Bonded, false });
    std::string fault = material.take(std::move(values), points);
    MaterialTilts tilts;
    if (fault.empty())
    {
      tilts =
        tiltsOf(*tool.shape, tool.range, LargestTilt, material.range(), material.spots(), points);
      fault = tilts.fault;
    }
    if (!fault.empty())
    {
      throw std::runtime_error("no tilts of " + tool.name + ": " + fault);
    }
    TiltViews views;
    views.terms = tilts.table.terms();
    views.drops = tilts.table.drops().data();
    views.nodes = tilts.table.nodes().data();
    views.weight = tilts.weights.empty() ? nullptr : tilts.weights.data();
    const StudyLaw law(tool, { 1.0, Ratio });
    this->Response = this->Body.respond(law.sample(this->Body.spots(), PlateSamples), views);
    this->Laws = tilts.table.terms().laws;
  }

  const ContactBody& response() const { return *this->Response; }
  std::size_t bytes() const
  {
    const ContactBody& body = *this->Response;
    return body.surface.memory() + body.tree.memory() + body.response.memory();
  }
  int laws() const { return this->Laws; }

private:
  StudyBody Body;
  std::unique_ptr<ContactBody> Response;
  int Laws = 0;
};
using SharedPlate = std::shared_ptr<const LeaningPlate>;

std::size_t pointCount()
{
  return flatTop(PlateHalf, PlateEdge).points.size();
}

SharedPlate halfSpaceOf(const StudyTool& tool)
{
  return std::make_shared<LeaningPlate>(
    tool, std::vector<Spot>(pointCount()), BodyMaterial::Values{});
}

/// A plate with a thickness of 4 to 12 mm along x.
SharedPlate wedgeOf(const StudyTool& tool)
{
  std::vector<Spot> spots;
  BodyMaterial::Values values;
  values.thickness.name = "thickness";
  for (const Vector3& point : flatTop(PlateHalf, PlateEdge).points)
  {
    const double thickness = 8.0 + 4.0 * point.x() / PlateHalf;
    values.thickness.values.push_back(thickness);
    spots.push_back({ 1.0 / thickness, 0.0 });
  }
  return std::make_shared<LeaningPlate>(tool, std::move(spots), std::move(values));
}

/// Orientation of the tool that is given to the tick.
enum class Told
{
  NoAxis,
  NoAxisDeeper, ///< no axis, and the tip is as deep as the tool's deepest point
  Upright,
  Axis
};

/// The complete tick of Palpate.
class LeaningTick final : public TiltMethod
{
public:
  LeaningTick(std::string name, SharedPlate plate, const StudyTool& tool, Told told)
    : Name(std::move(name))
    , Plate(std::move(plate))
    , Tool(tool)
    , Is(told)
    , Contact(this->Plate->response())
  {
  }
  std::string name() const override { return this->Name; }
  void lean(double angle) override
  {
    this->forget();
    this->Axis = this->Is == Told::Axis ? Vector3(std::sin(angle), 0.0, std::cos(angle))
                                        : Vector3(Vector3::UnitZ());
    this->Deeper =
      this->Is == Told::NoAxisDeeper ? deepestPoint(*this->Tool.shape, angle).drop : 0.0;
  }
  Vector3 force(const Vector3& tip) override
  {
    const bool hasAxis = this->Is == Told::Upright || this->Is == Told::Axis;
    return this->Contact
      .update(hasAxis ? ToolPose(tip, this->Axis)
                      : ToolPose(tip - Vector3(this->Deeper * Vector3::UnitZ())))
      .force;
  }
  void forget() override { this->Contact.reset(); }
  std::size_t bytes() const override { return this->Plate->bytes(); }

private:
  std::string Name;
  SharedPlate Plate;
  StudyTool Tool;
  Told Is;
  ToolContact Contact;
  Vector3 Axis = Vector3::UnitZ();
  double Deeper = 0.0;
};

/// A method whose force is a function of depth and angle, computed in the tick without tables.
class LeaningLaw final : public TiltMethod
{
public:
  using Law = double (*)(const AxisymmetricTool& tool, double angle, double depth);

  LeaningLaw(std::string name, const StudyTool& tool, Law law)
    : Name(std::move(name))
    , Tool(tool)
    , Force(law)
  {
  }
  std::string name() const override { return this->Name; }
  void lean(double angle) override
  {
    this->Angle = angle;
    this->Drop = deepestPoint(*this->Tool.shape, angle).drop;
  }
  Vector3 force(const Vector3& tip) override
  {
    const double depth = this->Drop - tip.z();
    return { 0.0, 0.0, depth > 0.0 ? this->Force(*this->Tool.shape, this->Angle, depth) : 0.0 };
  }
  std::size_t bytes() const override { return sizeof(*this); }

private:
  std::string Name;
  StudyTool Tool;
  Law Force;
  double Angle = 0.0;
  double Drop = 0.0;
};
} // namespace

TiltMethodList tiltMethods(const StudyTool& tool)
{
  const SharedPlate plate = halfSpaceOf(tool);
  TiltMethodList methods;
  const auto addTick = [&](const char* name, Told told)
  { methods.push_back(std::make_unique<LeaningTick>(name, plate, tool, told)); };
  addTick("upright, tip as deep", Told::NoAxis);
  addTick("upright, deepest point as deep", Told::NoAxisDeeper);
  addTick("table in the tick", Told::Axis);
  methods.push_back(std::make_unique<LeaningLaw>("circles", tool, circleForce));
  methods.push_back(std::make_unique<LeaningLaw>("boundary elements, 64", tool,
    [](const AxisymmetricTool& shape, double angle, double depth)
    { return solveTilted(shape, angle, depth, 64).perModulus; }));
  return methods;
}

TiltMethodList tiltTicks(const StudyTool& tool)
{
  TiltMethodList methods;
  const auto add = [&](const std::string& name, const SharedPlate& plate, Told told)
  { methods.push_back(std::make_unique<LeaningTick>(name, plate, tool, told)); };
  const SharedPlate one = halfSpaceOf(tool);
  const SharedPlate several = wedgeOf(tool);
  const std::string laws = std::to_string(several->laws()) + " laws";
  for (const auto& [of, plate] : { std::pair(std::string("1 law"), one), { laws, several } })
  {
    add("tick without an axis, " + of, plate, Told::NoAxis);
    add("tick, upright, " + of, plate, Told::Upright);
    add("tick, leaning, " + of, plate, Told::Axis);
  }
  return methods;
}
} // namespace palpate::testing

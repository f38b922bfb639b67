// SPDX-License-Identifier: BSD-3-Clause
#include "ResponseModels.h"

#include "Mechanics/Layers/LayerContact.h"
#include "Mechanics/SeriesCompliance.h"
#include "Mechanics/Tools/ToolSpecification.h"
#include "RelaxingModels.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>

namespace palpate::testing
{
namespace
{
constexpr double DeepestRange = 8.0; // mm

std::shared_ptr<const AxisymmetricTool> toolOf(const std::string& text)
{
  ToolSpecification specification;
  std::string error;
  if (!parseTool(text, specification, error))
  {
    std::fprintf(stderr, "%s\n", error.c_str());
    std::abort();
  }
  return makeTool(specification);
}

ResponseModel ranging(ResponseModel model, double force)
{
  model.range = DeepestRange;
  model.range = model.depthOf(force);
  return model;
}

ResponseModel seriesModel(const std::string& tool, double modulus, double compliance)
{
  const auto local = toolOf(tool);
  const auto law = [local, modulus, compliance](double deflection)
  {
    const SeriesPoint point = seriesResponse(*local, modulus, compliance, deflection);
    return IndentationPoint{ point.force, point.stiffness, 0.0 };
  };
  return { "global", law, 1.0, DeepestRange };
}

ResponseModel layerModel(const std::string& tool, double modulus, double thickness)
{
  const auto shape = toolOf(tool);
  const auto layer = std::make_shared<const LayerContact>(
    *shape, std::make_shared<const LayerKernel>(0.5, LayerBase::Bonded), thickness);
  const auto law = [shape, layer, modulus](double deflection)
  { return layer->evaluate(deflection, modulus); };
  return { "layer", law, shape->forceExponent(), DeepestRange };
}
} // namespace

double ResponseModel::depthOf(double force) const
{
  double low = 0.0;
  double high = this->range;
  for (int i = 0; i < 60; ++i)
  {
    const double middle = 0.5 * (low + high);
    (this->law(middle).force < force ? low : high) = middle;
  }
  return high;
}

ResponseModel linearModel(const std::string& name, double stiffness, double range)
{
  const auto law = [stiffness](double deflection) {
    return IndentationPoint{ stiffness * deflection, stiffness, 0.0 };
  };
  return { name, law, 1.0, range };
}

ResponseModel toolModel(const std::string& tool, double modulus, double force)
{
  const auto shape = toolOf(tool);
  const auto law = [shape, modulus](double deflection)
  { return shape->evaluate(deflection, modulus); };
  return ranging({ tool, law, shape->forceExponent(), DeepestRange }, force);
}

std::vector<ResponseModel> allModels(double modulus, double force)
{
  const double secant = toolOf("sphere:6.35")->force(1.0, modulus);
  std::vector<ResponseModel> models{ ranging(linearModel("spring", secant, DeepestRange), force),
    ranging(seriesModel("sphere:6.35", modulus, 1.0), force) };
  for (const char* tool : { "sphere:6.35", "paraboloid:6.35", "sphere:1.6", "flat:1.6", "cone:60" })
  {
    models.push_back(toolModel(tool, modulus, force));
  }
  models.push_back(ranging(layerModel("sphere:6.35", modulus, 10.0), force));
  return models;
}

ResponseStore storedAt(const Surface& surface, const ResponseModel& model)
{
  constexpr int samples = 8;
  ResponseStore store(surface.points.size());
  std::vector<float> force;
  std::vector<float> stiffness;
  for (int i = 1; i <= samples; ++i)
  {
    const IndentationPoint at = model.law(model.range * i * i / (samples * samples));
    force.push_back(static_cast<float>(at.force));
    stiffness.push_back(static_cast<float>(at.stiffness));
  }
  for (std::size_t p = 0; p < surface.points.size(); ++p)
  {
    std::copy(force.begin(), force.end(), store.force.begin() + samples * static_cast<long>(p));
    std::copy(
      stiffness.begin(), stiffness.end(), store.stiffness.begin() + samples * static_cast<long>(p));
    store.range[p] = static_cast<float>(model.range);
  }
  return store;
}

std::shared_ptr<const ContactBody> bodyOf(
  const Surface& surface, const ResponseStore& store, const ResponseModel& model)
{
  ResponseArrays arrays = store.arrays();
  arrays.exponent = model.exponent;
  return contactBody(surface, arrays);
}

namespace
{
Surface plateAroundOrigin()
{
  Surface plate = openPlate(40.0, 2);
  for (Vector3& point : plate.points)
  {
    point -= Vector3(17.0, 19.0, 0.0);
  }
  return plate;
}
} // namespace

std::shared_ptr<const ContactBody> plateOf(const ResponseModel& model)
{
  const Surface plate = plateAroundOrigin();
  return bodyOf(plate, storedAt(plate, model), model);
}

std::shared_ptr<const ContactBody> coupledPlate(const ResponseModel& model, double modulus)
{
  const Surface plate = plateAroundOrigin();
  const ResponseStore store = storedAt(plate, model);
  ResponseArrays arrays = store.arrays();
  arrays.exponent = model.exponent;
  arrays.coupling.modulus = modulus;
  return contactBody(plate, arrays);
}

std::shared_ptr<const ContactBody> relaxingPlate(
  const ResponseModel& model, const PronySeries& series)
{
  const Surface plate = plateAroundOrigin();
  const ResponseStore store = storedAt(plate, model);
  ResponseArrays arrays = store.arrays();
  arrays.exponent = model.exponent;
  arrays.relaxation.series = series;
  arrays.relaxation.exponent = model.exponent;
  return contactBody(plate, arrays);
}
} // namespace palpate::testing

// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/MeasuredSite.h"

#include "Identification/ArrangedReadings.h"
#include "Identification/CurveSigns.h"
#include "Identification/RelaxingIdentification.h"

#include <algorithm>
#include <cstddef>
#include <map>

namespace palpate
{
std::string collectSites(const std::vector<MeasuredCurves>& files, std::vector<MeasuredSite>& sites)
{
  std::vector<MeasuredSite> collected;
  std::map<std::string, std::size_t> index;
  for (const MeasuredCurves& file : files)
  {
    const std::shared_ptr<const AxisymmetricTool> tool = makeTool(file.tool);
    if (!tool)
    {
      return file.file + ": " + checkTool(file.tool);
    }
    for (const MeasuredCurve& curve : file.curves)
    {
      const auto known = index.emplace(curve.site, collected.size());
      if (known.second)
      {
        MeasuredSite site;
        site.name = curve.site;
        site.position = curve.position;
        collected.push_back(std::move(site));
      }
      MeasuredSite& site = collected[known.first->second];
      if (site.position != curve.position)
      {
        return file.file + ": site '" + curve.site +
          "' has another position than in the files before";
      }
      site.curves.push_back({ file.toolText, tool, curve, {} });
    }
  }
  sites = std::move(collected);
  return {};
}

namespace
{
bool hasTimes(const SiteCurve& curve)
{
  const std::vector<double>& time = curve.curve.time;
  return time.size() > 1 && time.back() > time.front();
}

/// Prepares a curve after its baseline is subtracted, because the force of the baseline would
/// contribute to every energy.
std::string prepareNet(const ElasticityLimits& limits, bool findContact, SiteCurve& curve)
{
  std::string fault = prepareCurve(curve.curve, limits, curve.prepared);
  if (!findContact || curve.prepared.loads.empty())
  {
    return fault;
  }
  const ForceBaseline baseline =
    findFirstContact(loadsByDepth(*curve.tool, curve.prepared)).baseline;
  MeasuredCurve net = curve.curve;
  for (std::size_t i = 0; i < net.force.size(); ++i)
  {
    net.force[i] -= baseline.at(net.deflection[i]);
  }
  PreparedCurve judged;
  fault = prepareCurve(net, limits, judged);
  for (std::size_t i = 0; i < judged.loads.size(); ++i)
  {
    judged.loads[i].force = curve.prepared.loads[i].force;
  }
  curve.prepared = std::move(judged);
  return fault;
}

/// Identifies a body that relaxes. On failure sets the reason.
void identifyAsRelaxing(const BodyIdentification& identification, MeasuredSite& site)
{
  std::vector<PressHistory> histories;
  for (const SiteCurve& curve : site.curves)
  {
    histories.push_back(
      makeHistory(*curve.tool, curve.curve, curve.prepared, identification.options().findContact));
  }
  site.body = identifyRelaxing(identification, std::move(histories));
  site.refusal = site.body.refusal;
}

/// Describes the loop, hold or effect of speed that shows that the site relaxes; "" if there is
/// none.
std::string signOfRelaxation(const MeasuredSite& site, const ElasticityLimits& limits)
{
  for (const SiteCurve& curve : site.curves)
  {
    const PreparedCurve& prepared = curve.prepared;
    if (relaxes(prepared, limits))
    {
      return prepared.hysteresis > limits.hysteresis ? "its loop shows"
        : prepared.rateEffect > limits.rateEffect    ? "its effect of speed shows"
                                                     : "its hold shows";
    }
  }
  return {};
}
} // namespace

void identifySite(
  const ElasticityLimits& limits, const BodyIdentification& identification, MeasuredSite& site)
{
  std::vector<IndentationCurve> loadings;
  bool isJudged = true; // whether every refusal was caused by relaxation
  bool areTimed = true;
  for (SiteCurve& curve : site.curves)
  {
    std::string fault = prepareNet(limits, identification.options().findContact, curve);
    const std::string doubt = doubtSigns(curve.curve);
    fault = doubt.empty() ? fault : doubt;
    if (!fault.empty() && site.refusal.empty())
    {
      site.refusal = fault;
    }
    isJudged = isJudged && doubt.empty() && (fault.empty() || relaxes(curve.prepared, limits));
    areTimed = areTimed && hasTimes(curve);
    loadings.push_back(loadsByDepth(*curve.tool, curve.prepared));
  }
  const PronySeries& given = identification.options().relaxation;
  const std::string flow = signOfRelaxation(site, limits);
  if (isJudged && areTimed && (!flow.empty() || given.count > 0))
  {
    identifyAsRelaxing(identification, site);
    return;
  }
  if (isJudged && !flow.empty())
  {
    site.refusal += (site.refusal.empty() ? "" : "; ") + flow +
      " that the body relaxes, which can be identified only from curves with time_s: record the "
      "time of every reading, with a hold at depth until the force has come to rest";
  }
  if (site.refusal.empty())
  {
    site.body = identification.identify(std::move(loadings));
    site.refusal = site.body.refusal;
    site.body.relaxation = given;
    for (std::size_t i = 0; i < given.count; ++i)
    {
      site.body.relaxationStrength.push_back(linearEstimate(given.strength[i], 0.0));
      site.body.relaxationTime.push_back(linearEstimate(given.time[i], 0.0));
    }
    if (given.count > 0)
    {
      site.body.remark = "relaxation given; the curves have no times, and count as slow ones" +
        std::string(site.body.remark.empty() ? "" : "; ") + site.body.remark;
    }
  }
}
} // namespace palpate

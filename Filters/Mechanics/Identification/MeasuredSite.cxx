// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Identification/MeasuredSite.h"

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
        return file.file + ": site '" + curve.site + "' lies elsewhere than in the files before";
      }
      site.curves.push_back({ file.toolText, tool, curve, {} });
    }
  }
  sites = std::move(collected);
  return {};
}

void identifySite(
  const ElasticityLimits& limits, const BodyIdentification& identification, MeasuredSite& site)
{
  std::vector<IndentationCurve> loadings;
  for (SiteCurve& curve : site.curves)
  {
    const std::string fault = prepareCurve(curve.curve, limits, curve.prepared);
    if (!fault.empty() && site.refusal.empty())
    {
      site.refusal = fault;
    }
    IndentationCurve loading;
    loading.tool = curve.tool.get();
    for (const LoadingBranch& load : curve.prepared.loads)
    {
      loading.deflection.insert(
        loading.deflection.end(), load.deflection.begin(), load.deflection.end());
      loading.force.insert(loading.force.end(), load.force.begin(), load.force.end());
    }
    loadings.push_back(std::move(loading));
  }
  if (site.refusal.empty())
  {
    site.body = identification.identify(std::move(loadings));
    site.refusal = site.body.refusal;
  }
}
} // namespace palpate

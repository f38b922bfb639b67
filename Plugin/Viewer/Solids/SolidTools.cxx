// SPDX-License-Identifier: BSD-3-Clause
#include "SolidTools.h"

#include "BodyCache.h"
#include "Mechanics/FiniteStrain/StrainCorrection.h"
#include "Mechanics/Files/NumberText.h"
#include "Mechanics/JoinedText.h"
#include "Response/BodyConversion.h"
#include "ResponseSet.h"
#include "SolvedCache.h"

#include "vtkElasticContactResponse.h"

#include <algorithm>
#include <numeric>

namespace palpate
{
namespace
{
/// Returns the range of Poisson's ratios of the tissues, or of the body, of a scene.
StrainBodies strainBodiesOf(const ViewerOptions& options, const ViewerScene& scene)
{
  StrainBodies bodies{ scene.poissonRatio, scene.poissonRatio };
  if (!options.tissues.empty())
  {
    const auto [least, most] = std::minmax_element(options.tissues.begin(), options.tissues.end(),
      [](const TissueChoice& a, const TissueChoice& b) { return a.poissonRatio < b.poissonRatio; });
    bodies = { least->poissonRatio, most->poissonRatio };
  }
  return bodies;
}

/// Chooses the law of finite strain for a tool. It is the law of the options, or Neo-Hooke if this
/// law is tabulated for the tool and the material (for a segmentation, the materials of all
/// tissues).
StrainLaw strainUnder(vtkContactTool* tool, const ViewerOptions& options, const ViewerScene& scene)
{
  if (options.strainGiven && !scene.terms.automatic)
  {
    return scene.terms.strain;
  }
  const bool isKnown = isStrainTabulated(
    *tool->GetKernel(), strainBodiesOf(options, scene), options.maximumDeflection);
  return { isKnown ? StrainModel::NeoHooke : StrainModel::Linear, 0.0 };
}
} // namespace

std::string makeSolidTools(const ViewerOptions& options, const ViewerScene& scene, SolidTools& made)
{
  std::vector<double> radii;
  for (const std::string& text : scene.tools)
  {
    made.tools.push_back(vtkSmartPointer<vtkContactTool>::New());
    if (!made.tools.back()->SetSpecification(text))
    {
      return "tool '" + text + "' is not known";
    }
    radii.push_back(made.tools.back()->GetKernel()->contactRadius(options.maximumDeflection));
  }
  made.order.resize(made.tools.size());
  std::iota(made.order.begin(), made.order.end(), std::size_t{ 0 });
  std::stable_sort(made.order.begin(), made.order.end(),
    [&radii](std::size_t a, std::size_t b) { return radii[a] > radii[b]; });
  made.widest = radii[made.order.front()];
  return {};
}

void setSolidTerms(
  const ViewerOptions& options, const ViewerScene& scene, vtkElasticContactResponse* pressed)
{
  pressed->SetMaximumDeflection(options.maximumDeflection);
  pressed->SetErrorTolerance(scene.terms.errorTolerance);
  pressed->SetEdgeCorrection(scene.terms.edges);
  pressed->SetMaximumTilt(scene.terms.tilt);
  for (std::size_t i = 0; i < scene.relaxation.count; ++i)
  {
    pressed->AddRelaxation(scene.relaxation.strength[i], scene.relaxation.time[i]);
  }
}

void setSolidTool(const ViewerOptions& options, const ViewerScene& scene, const SolidTools& made,
  std::size_t t, vtkElasticContactResponse* pressed)
{
  const StrainLaw law = strainUnder(made.tools[t], options, scene);
  pressed->SetStrainModel(static_cast<int>(law.model));
  pressed->SetOgdenExponent(law.parameter);
  pressed->SetDemirayExponent(law.parameter);
  pressed->SetTool(made.tools[t]);
  pressed->SetResponseName(responseName(t));
}

std::string solidTermsKey(const ViewerOptions& options, const ViewerScene& scene)
{
  return joined(solvedKey(options, scene), '|', shortestDecimals(options.solidSpacing), '|',
    options.fixedFaces, '|', options.strainGiven && !scene.terms.automatic, '|',
    static_cast<int>(scene.terms.strain.model), ':', scene.terms.strain.parameter);
}

std::string solveOrRead(const std::string& kind, const std::string& key, ViewerScene& scene,
  const std::function<std::string()>& solve)
{
  std::vector<std::string> arrays;
  for (std::size_t i = 0; i < scene.tools.size(); ++i)
  {
    arrays.push_back(responseName(i) + "Force");
  }
  const std::string file = cachePlace(kind, key, ".vtp");
  if (const vtkSmartPointer<vtkPolyData> solved = readSolved(file, arrays))
  {
    scene.body = solved;
    scene.notes.push_back("its solid's responses taken from the cache " + file);
  }
  else
  {
    const std::string error = solve();
    if (!error.empty())
    {
      return error;
    }
    const std::string fault = keepSolved(scene.body, file);
    if (!fault.empty())
    {
      scene.notes.push_back("cache not used: " + fault);
    }
  }
  scene.stored = true;
  scene.modelReason = responseText(scene.body, "Response", ResponseArray::Model);
  return {};
}
} // namespace palpate

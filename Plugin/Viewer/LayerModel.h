// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LayerModel_h
#define palpate_LayerModel_h

#include "ResponseSet.h"
#include "ViewerScene.h"

#include <optional>
#include <string>

namespace palpate
{
/// The grey level below which a scan is bone, if its thickness of soft tissue is wanted: by
/// --layer, or else by the scene.
std::optional<double> scanValue(const ViewerOptions& options, const LayerChoice& ofScene);

/// Settles what lies under the surface of a scene that has its body: --layer, or else the scene's
/// own choice, where nothing else decides on it. Says so in the reason of the model. Returns an
/// error, or "": scan wanted where there was none.
std::string chooseLayer(const ViewerOptions& options, ViewerScene& scene);

/// Where the numbers of a stack come from, for the summary.
std::string layerSource(const LayerChoice& layer);

/// What the body is made of, for the summary.
std::string describeMaterial(const ViewerScene& scene);

/// The law in words, for the summary: what is a layer and what a half-space.
std::string describeLaw(const ViewerScene& scene);

/// ": 6.4 mm of soft tissue over bone" or the like; "" where the scene knows of no layer.
std::string describeSpot(const ViewerScene& scene, vtkIdType point);

/// How many times the force of each tool on a half-space the layer under a point makes, at two
/// depths; "" without a layer.
std::string describeStiffening(const ViewerScene& scene, const ResponseSet& responses,
  vtkIdType point, double depth, double deep);
} // namespace palpate

#endif

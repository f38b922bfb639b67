// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LayerModel_h
#define palpate_LayerModel_h

#include "ResponseSet.h"
#include "ViewerScene.h"

#include <optional>
#include <string>

namespace palpate
{
/// The grey level below which a scan is bone, if the thickness of its soft tissue is wanted: by
/// --layer, otherwise by the scene.
std::optional<double> scanValue(const ViewerOptions& options, const LayerChoice& ofScene);

/// Chooses the layers under the surface of a scene that has its body: --layer, otherwise the
/// scene's own choice, unless something else determines them. Notes it in the reason of the model.
/// Returns an error, or "": a scan is wanted but there is none.
std::string chooseLayer(const ViewerOptions& options, ViewerScene& scene);

/// The source of a stack's numbers, for the summary.
std::string layerSource(const LayerChoice& layer);

/// The material of the body, for the summary.
std::string describeMaterial(const ViewerScene& scene);

/// The law in words, for the summary: where it is a layer and where a half-space.
std::string describeLaw(const ViewerScene& scene);

/// ": 6.4 mm of soft tissue over bone" or the like; "" if the scene has no layer.
std::string describeSpot(const ViewerScene& scene, vtkIdType point);

/// The ratio of each tool's force on the layer under a point to that on a half-space, at two
/// depths; "" without a layer.
std::string describeStiffening(const ViewerScene& scene, const ResponseSet& responses,
  vtkIdType point, double depth, double deep);
} // namespace palpate

#endif

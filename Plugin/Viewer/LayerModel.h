// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LayerModel_h
#define palpate_LayerModel_h

#include "ResponseSet.h"
#include "ViewerScene.h"

#include <optional>
#include <string>

namespace palpate
{
/// Returns the grey level below which a scan is bone, if the thickness of the soft tissue is
/// requested by --layer or, without --layer, by the scene. Otherwise returns nothing.
std::optional<double> scanValue(const ViewerOptions& options, const LayerChoice& ofScene);

/// Chooses the layers under the surface of a scene that has its body: the layers of --layer,
/// otherwise the layers of the scene. There are no layers if another option defines the body below
/// the surface. Adds the choice to the reason of the model. Returns "", or an error if the
/// thickness from a scan is requested but the body is not from a scan.
std::string chooseLayer(const ViewerOptions& options, ViewerScene& scene);

/// Returns the source of the numbers of a stack, for the summary.
std::string layerSource(const LayerChoice& layer);

/// The material of the body, for the summary.
std::string describeMaterial(const ViewerScene& scene);

/// Describes the law for the summary, including where it uses the layer and where the half-space.
std::string describeLaw(const ViewerScene& scene);

/// Description of the layer at a point: ": 6.4 mm of soft tissue over bone" or similar; "" if the
/// scene has no layer.
std::string describeSpot(const ViewerScene& scene, vtkIdType point);

/// Ratio of each tool's force on the layer under a point to its force on a half-space, at two
/// depths; "" without a layer.
std::string describeStiffening(const ViewerScene& scene, const ResponseSet& responses,
  vtkIdType point, double depth, double deep);
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LayerModel_h
#define palpate_LayerModel_h

#include "ResponseSet.h"
#include "ViewerScene.h"

#include <optional>
#include <string>

namespace palpate
{
/// Returns the grey level below which a voxel of a scan is bone, if --layer or, without --layer,
/// the scene requests the thickness of the soft tissue. Otherwise returns an empty optional.
std::optional<double> scanValue(const ViewerOptions& options, const LayerChoice& ofScene);

/// Chooses the layers under the surface of a scene whose body exists. They are the layers of
/// --layer or, without this option, the layers of the scene. There are no layers if another option
/// defines the body below the surface. The choice is added to the reason for the model. Returns "",
/// or an error if the thickness from a scan is requested but the body is not from a scan.
std::string chooseLayer(const ViewerOptions& options, ViewerScene& scene);

/// Returns the source of the values of a stack, for the summary.
std::string layerSource(const LayerChoice& layer);

/// Describes the material of the body, for the summary.
std::string describeMaterial(const ViewerScene& scene);

/// Describes the law for the summary, including where it uses the layer and where it uses the
/// half-space.
std::string describeLaw(const ViewerScene& scene);

/// Describes the layer at a point, for example ": 6.4 mm of soft tissue over bone". Returns "" if
/// the scene has no layer.
std::string describeSpot(const ViewerScene& scene, vtkIdType point);

/// Describes the ratio of each tool's force on the layer under a point to its force on a
/// half-space, at the two depths `depth` and `deep` (mm). Returns "" without a layer.
std::string describeStiffening(const ViewerScene& scene, const ResponseSet& responses,
  vtkIdType point, double depth, double deep);
} // namespace palpate

#endif

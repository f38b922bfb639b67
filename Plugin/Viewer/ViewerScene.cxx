// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerScene.h"

#include "ClearView.h"

#include "Response/BodyConversion.h"
#include "BodyFile.h"
#include "LayerModel.h"
#include "ViewerModules.h"
#include "WholeBodyScene.h"

#include "vtkContactTool.h"
#include "vtkNew.h"
#include "vtkToolContactResponse.h"

namespace palpate
{
namespace
{
/// Makes a solid from the surface of the scene, for --voxel and --solid. Returns "" or an error.
std::string fillBody(const ViewerOptions& options, ViewerScene& scene)
{
  if (scene.stored)
  {
    return options.body + ": contains its response, which " +
      (options.solid ? "--solid" : "--voxel") + " cannot change; give --tool for a new one";
  }
  std::string fault;
  const SolidsModule* solids = solidsModule(options.solid ? "--solid" : "--voxel", fault);
  if (!solids)
  {
    return fault;
  }
  if (options.solid)
  {
    return solids->fillWithTetrahedra(options, scene);
  }
  scene.solid = true;
  scene.modelReason = "in series with the compliance of the solid, by finite elements";
  return solids->fillWithVoxels(scene.body,
    { options.voxel, options.fixedFaces, scene.youngsModulus, scene.poissonRatio }, scene.notes);
}

/// Makes a solid from a segmentation, for --tissue. Returns "" or an error.
std::string fillTissues(const ViewerOptions& options, ViewerScene& scene)
{
  std::string fault;
  const SolidsModule* solids = solidsModule("--tissue", fault);
  return solids ? solids->pressTissues(options, scene) : fault;
}

std::string makePhantom(const ViewerOptions& options, ViewerScene& scene)
{
  std::string fault;
  const SolidsModule* solids = solidsModule("--scene phantom", fault);
  return solids ? solids->pressPhantom(options, scene) : fault;
}

/// Makes the responses from curves measured on the body, for --measured. Returns "" or an error.
std::string identifyBody(const ViewerOptions& options, ViewerScene& scene)
{
  std::string fault;
  const IdentificationModule* identification = identificationModule("--measured", fault);
  return identification ? identification->identify(options, scene) : fault;
}
} // namespace

std::string makeViewerScene(const ViewerOptions& options, ViewerScene& scene)
{
  std::string error;
  if (!options.tissues.empty())
  {
    error = fillTissues(options, scene);
  }
  else if (!options.body.empty())
  {
    error = makeUserScene(options, scene);
  }
  else
  {
    error = options.scene == "cylinder" ? makeCylinderScene(options, scene)
      : options.scene == "phantom"      ? makePhantom(options, scene)
                                        : makeHeadScene(options, scene);
  }
  if (!error.empty())
  {
    return error;
  }
  // The options of the user override the values of the scene.
  if (options.youngsModulus || options.poissonRatio)
  {
    scene.materialSource = "given on the command line";
  }
  if (options.layer && options.layer->isStack())
  {
    const StackLayer& top = options.layer->stack.layers.front();
    scene.youngsModulus = top.youngsModulus;
    scene.poissonRatio = top.poissonRatio;
    scene.materialSource = layerSource(*options.layer);
  }
  scene.youngsModulus = options.youngsModulus.value_or(scene.youngsModulus);
  scene.poissonRatio = options.poissonRatio.value_or(scene.poissonRatio);
  scene.depth = options.depth.value_or(scene.depth);
  scene.terms = options.terms;
  scene.terms.changeTolerance = options.tolerance;
  scene.relaxation = options.relaxation;
  if (!scene.stored && scene.relaxation.count > 0)
  {
    scene.materialSource += "; relaxing " + textOf(scene.relaxation) + " (strength:seconds)";
  }
  const bool isHead = options.body.empty() && options.scene == "head";
  if (isHead && !options.strainGiven && options.automatic && !scene.layer.isStack())
  {
    scene.terms.automatic = true;
  }
  if (!options.tools.empty())
  {
    scene.tools = options.tools;
  }
  if (options.site || options.slideTo)
  {
    const Direction from = options.site.value_or(scene.directions.front());
    scene.directions = { from };
    if (options.slideTo)
    {
      scene.directions.push_back(*options.slideTo);
    }
    scene.viewFrom = from;
  }
  if (options.tissues.empty() && (options.site || options.slideTo || !options.body.empty()))
  {
    scene.viewFrom = clearView(scene);
  }
  error = chooseLayer(options, scene);
  if (!error.empty())
  {
    return error;
  }
  if (!options.tissues.empty())
  {
    return {};
  }
  if (options.voxel > 0.0 || options.solid)
  {
    return fillBody(options, scene);
  }
  if (options.measured.empty())
  {
    addBodyCompliance(options, scene);
    return {};
  }
  return identifyBody(options, scene);
}

std::string makeUserScene(const ViewerOptions& options, ViewerScene& scene)
{
  BodyFileOptions file;
  file.lengthScale = options.lengthScale;
  file.resolution = options.resolution;
  file.contourValue = options.contourValue;
  file.closingRadius = options.closingRadius;
  file.baseValue = scanValue(options, {});
  const BodyFileResult read = readBodyFile(options.body, file);
  if (!read.error.empty())
  {
    return read.error;
  }
  scene.title = options.body.substr(options.body.find_last_of('/') + 1);
  scene.body = read.body;
  scene.notes = read.notes;
  scene.materialSource = "default of the viewer, soft tissue by order of magnitude; give --young "
                         "and --poisson";
  scene.modelReason = "no layer thickness and no compliance is known for this body";
  scene.tools = { vtkNew<vtkContactTool>()->GetSpecification() };
  vtkNew<vtkToolContactResponse> usual;
  scene.youngsModulus = usual->GetYoungsModulus();
  scene.poissonRatio = usual->GetPoissonRatio();
  const std::string tool = responseText(scene.body, "Response", ResponseArray::Tool);
  if (!tool.empty() && options.tools.empty() && !options.youngsModulus && !options.poissonRatio &&
    !options.layer)
  {
    ResponseArrays arrays;
    const float* validity = nullptr;
    const unsigned char* limit = nullptr;
    std::string error;
    if (!viewResponse(scene.body, "Response", arrays, error) ||
      !viewValidity(scene.body, "Response", validity, limit, error))
    {
      return options.body + ": its response cannot be used: " + error +
        "; give --tool for a new one";
    }
    scene.stored = true;
    scene.tools = { tool };
    scene.materialSource = "not used: the file contains its response";
    scene.modelReason =
      "as stored in the file: " + responseText(scene.body, "Response", ResponseArray::Model);
    if (options.relaxation.count > 0)
    {
      removeArrays(scene.body, "Response", ContractArray::Use::Relaxation);
      describeRelaxation(scene.body, "Response", options.relaxation);
      scene.modelReason += "; its relaxation is given on the command line";
    }
  }
  scene.body->GetCenter(scene.center.data());
  scene.directions = { { 0.0, 0.0, 1.0 } };
  scene.viewFrom = { 0.5, -0.8, 0.6 };
  return {};
}
} // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "LiveSetup.h"

#include "ProgressLine.h"
#include "Response/Files/CollectingWindow.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkContactSetup.h"
#include "vtkNew.h"
#include "vtkToolContactResponse.h"

namespace palpate
{
namespace
{
int modelOf(const ViewerScene& scene)
{
  return scene.stored ? vtkContactSetup::Stored
    : scene.solid     ? vtkContactSetup::Series
    : scene.layer.scanned || scene.layer.thickness > 0.0 || scene.layer.isStack()
    ? vtkContactSetup::Layer
    : vtkContactSetup::HalfSpace;
}
/// Passes the layers to the setup. The material of the top layer is that of the scene.
void giveStack(const LayerChoice& layer, vtkContactSetup* setup)
{
  const LayerStack& stack = layer.stack;
  setup->SetLayerThickness(layer.scanned ? 0.0 : stack.layers.front().thickness);
  for (std::size_t i = 1; i < stack.layers.size(); ++i)
  {
    const StackLayer& below = stack.layers[i];
    setup->AddLayer(
      layer.scanned ? 0.0 : below.thickness, below.youngsModulus, below.poissonRatio, below.slips);
  }
  setup->SetLayerBase(stack.hasHalfSpace ? vtkToolContactResponse::ElasticBase
      : stack.base == LayerBase::Slip    ? vtkToolContactResponse::Slip
                                         : vtkToolContactResponse::Bonded);
  setup->SetBaseYoungsModulus(stack.halfSpace.youngsModulus);
  setup->SetBasePoissonRatio(stack.halfSpace.poissonRatio);
  setup->SetBaseSlips(stack.halfSpace.slips);
}

/// Computes the responses and shows the progress. Returns false after an error.
bool computeResponses(vtkContactSetup* setup)
{
  ProgressLine line("the responses are computed");
  vtkNew<vtkCallbackCommand> show;
  show->SetClientData(&line);
  show->SetCallback([](vtkObject*, unsigned long, void* client, void* done)
    { static_cast<ProgressLine*>(client)->show(*static_cast<const double*>(done)); });
  const unsigned long tag = setup->AddObserver(vtkCommand::ProgressEvent, show);
  // Update is used, because Request would compute with a lower priority than other programs.
  const bool isMade = setup->Update();
  setup->RemoveObserver(tag);
  return isMade;
}
} // namespace

std::string makeLiveSetup(const ViewerOptions& options, const ViewerScene& scene,
  vtkContactSetup* setup, ResponseSet& responses)
{
  setup->SetBody(scene.body);
  for (const std::string& tool : scene.tools)
  {
    const auto shape = vtkSmartPointer<vtkContactTool>::New();
    const QuietScope quiet;
    if (!shape->SetSpecification(tool))
    {
      return "tool '" + tool + "' is not known";
    }
    setup->AddTool(shape);
    responses.tools.push_back(shape);
    responses.names.push_back(setup->GetResponseName(setup->GetNumberOfTools() - 1));
  }
  setup->SetYoungsModulus(scene.youngsModulus);
  setup->SetPoissonRatio(scene.poissonRatio);
  setup->SetMaximumDeflection(options.maximumDeflection);
  setup->SetLayerThickness(scene.layer.scanned ? 0.0 : scene.layer.thickness);
  if (scene.layer.isStack())
  {
    giveStack(scene.layer, setup);
  }
  setup->SetComplianceModulus(scene.solid ? scene.youngsModulus : 0.0);
  setup->SetModel(modelOf(scene));
  setup->SetCurvatureCorrection(scene.terms.curvature);
  setup->SetEdgeCorrection(scene.terms.edges);
  setup->SetMaximumTilt(scene.terms.tilt);
  setup->SetCoupling(!options.hands.empty());
  for (std::size_t i = 0; i < scene.relaxation.count; ++i)
  {
    setup->AddRelaxation(scene.relaxation.strength[i], scene.relaxation.time[i]);
  }
  setup->SetStrainModel(static_cast<int>(scene.terms.strain.model));
  setup->SetStrainExponent(scene.terms.strain.parameter);
  setup->SetErrorTolerance(scene.terms.errorTolerance);
  setup->SetAutomaticTerms(scene.terms.automatic);
  setup->SetTolerance(options.automatic ? options.tolerance : 0.0);
  setup->SetChoiceDeflection(scene.depth);
  {
    const QuietScope quiet;
    if (!computeResponses(setup))
    {
      return quiet.window->reason();
    }
    quiet.window->printWarnings();
  }
  responses.body = setup->GetOutput();
  return writeResponses(options, responses);
}
} // namespace palpate

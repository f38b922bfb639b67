// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Session/ResponseMaker.h"

#include "Response/BodyConversion.h"
#include "Haptics/Devices/DeviceFit.h"
#include "Interaction/Session/LeastForm.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkToolContactResponse.h"

#include <cmath>

namespace palpate
{
namespace
{
/// What filter and tool complain about, so that nothing is printed by another thread.
struct Heard
{
  MadeResponses& made;
  const std::function<bool()>& stale;

  void listen(vtkObject* object)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback(&Heard::hear);
    for (const unsigned long event :
      { vtkCommand::ErrorEvent, vtkCommand::WarningEvent, vtkCommand::ProgressEvent })
    {
      object->AddObserver(event, command);
    }
  }

  static void hear(vtkObject* caller, unsigned long event, void* data, void* text)
  {
    auto* heard = static_cast<Heard*>(data);
    if (event == vtkCommand::ProgressEvent)
    {
      if (heard->stale())
      {
        vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
      }
      return;
    }
    std::string& kept = event == vtkCommand::ErrorEvent ? heard->made.error : heard->made.warning;
    if (kept.empty() && !caller->IsA("vtkExecutive"))
    {
      // "ERROR: In file, line n\nclass (address): message\n\n"
      kept = static_cast<const char*>(text);
      const std::size_t start = kept.find("): ");
      kept.erase(0, start == std::string::npos ? 0 : start + 3);
      kept.erase(kept.find_last_not_of(" \n.") + 1);
    }
  }
};

/// A compliance is inversely proportional to the modulus, a mode to the root of it.
void scaleGlobal(vtkPolyData* body, const ResponseRequest& request)
{
  if (request.complianceArray.empty() || request.complianceFactor == 1.0)
  {
    return;
  }
  vtkPointData* data = body->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* given = data->GetArray(i);
    const std::string name = given && given->GetName() ? given->GetName() : "";
    const bool isMode = name.rfind("GlobalMode", 0) == 0;
    if (name != request.complianceArray && !isMode)
    {
      continue;
    }
    const double factor = isMode ? std::sqrt(request.complianceFactor) : request.complianceFactor;
    const auto scaled = vtkSmartPointer<vtkDataArray>::Take(given->NewInstance());
    scaled->DeepCopy(given);
    for (vtkIdType t = 0; t < scaled->GetNumberOfTuples(); ++t)
    {
      for (int c = 0; c < scaled->GetNumberOfComponents(); ++c)
      {
        scaled->SetComponent(t, c, factor * scaled->GetComponent(t, c));
      }
    }
    data->AddArray(scaled); // in the place of the one of this name
  }
}

void attachResponse(
  const ResponseRequest& request, std::size_t tool, MadeResponses& made, Heard& heard)
{
  constexpr int points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkNew<vtkToolContactResponse> attach;
  heard.listen(attach);
  heard.listen(attach->GetExecutive());
  heard.listen(request.tools[tool]);
  attach->SetTool(request.tools[tool]);
  attach->SetInputData(made.body);
  attach->SetYoungsModulus(request.youngsModulus);
  attach->SetPoissonRatio(request.poissonRatio);
  attach->SetMaximumDeflection(request.maximumDeflection);
  attach->SetLayerThickness(request.layerThickness);
  attach->SetResponseName(request.names[tool]);
  if (!request.thicknessArray.empty())
  {
    attach->SetInputArrayToProcess(1, 0, 0, points, request.thicknessArray.c_str());
  }
  if (!request.complianceArray.empty())
  {
    attach->SetInputArrayToProcess(2, 0, 0, points, request.complianceArray.c_str());
  }
  attach->Update();
  request.tools[tool]->RemoveAllObservers();
  made.body = vtkSmartPointer<vtkPolyData>::New(); // and not the filter's
  made.body->ShallowCopy(attach->GetOutput());
}

/// The body with the form of a tool's response that is felt; null after an error.
vtkSmartPointer<vtkPolyData> feltForm(
  const ResponseRequest& request, std::size_t tool, MadeResponses& made, Heard& heard)
{
  if (request.tolerance == 0.0)
  {
    return made.body;
  }
  const LeastFormRequest wanted{ made.body, request.names[tool], request.tolerance,
    request.choiceDeflection, request.complianceArray, request.tools[tool], request.youngsModulus,
    request.poissonRatio };
  const LeastForm form = findLeastForm(wanted,
    [&](vtkAlgorithm* filter)
    {
      heard.listen(filter);
      heard.listen(filter->GetExecutive());
      filter->Update();
      return made.error.empty() && !heard.stale();
    });
  made.choices.push_back(form.reason);
  return form.body;
}

/// As the session would make them. One after the other: each is threaded.
void makeKernels(const ResponseRequest& request, MadeResponses& made, Heard& heard)
{
  std::shared_ptr<const ContactBody> surface = request.surface;
  for (std::size_t i = 0; i < request.names.size(); ++i)
  {
    const vtkSmartPointer<vtkPolyData> felt = feltForm(request, i, made, heard);
    if (!felt || heard.stale() || !made.error.empty())
    {
      return;
    }
    const std::string& name = request.names[i];
    auto& kernel = made.kernels.read[name];
    kernel = surface ? makeContactBody(felt, name, made.error, *surface)
                     : makeContactBody(felt, name, made.error);
    if (kernel)
    {
      surface = kernel;
      DeviceFit peaks(DeviceSpecification{});
      peaks.include(kernel->response, request.maximumDeflection);
      made.kernels.peaks[{ name, request.maximumDeflection }] = { peaks.peakForce(),
        peaks.peakStiffness() };
    }
  }
}
} // namespace

MadeResponses makeResponses(const ResponseRequest& request, const std::function<bool()>& stale)
{
  MadeResponses made;
  Heard heard{ made, stale };
  made.from = request.body;
  made.tools = request.tools;
  made.poissonRatio = request.poissonRatio;
  made.body = vtkSmartPointer<vtkPolyData>::New();
  made.body->ShallowCopy(request.body);
  scaleGlobal(made.body, request);
  for (std::size_t i = 0; !request.stored && i < request.tools.size(); ++i)
  {
    attachResponse(request, i, made, heard);
    if (stale() || !made.error.empty())
    {
      break;
    }
  }
  if (made.error.empty())
  {
    makeKernels(request, made, heard);
  }
  if (!made.error.empty())
  {
    made.body = nullptr;
  }
  return made;
}
} // namespace palpate

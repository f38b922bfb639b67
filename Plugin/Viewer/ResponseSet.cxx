// SPDX-License-Identifier: BSD-3-Clause
#include "ResponseSet.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkToolContactResponse.h"

#include <chrono>

namespace palpate
{
namespace
{
double responseBytes(vtkPolyData* body, const std::string& name)
{
  double bytes = 0.0;
  for (int i = 0; i < body->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = body->GetPointData()->GetAbstractArray(i);
    if (array->GetName() && std::string(array->GetName()).rfind(name, 0) == 0)
    {
      bytes += static_cast<double>(array->GetNumberOfValues()) * array->GetDataTypeSize();
    }
  }
  return bytes;
}
} // namespace

std::string updateQuietly(vtkAlgorithm* algorithm)
{
  std::string errors;
  vtkNew<vtkCallbackCommand> collect;
  collect->SetClientData(&errors);
  collect->SetCallback(
    [](vtkObject*, unsigned long, void* client, void* text)
    {
      auto& all = *static_cast<std::string*>(client);
      all += text ? static_cast<const char*>(text) : "unknown error";
    });
  const unsigned long tag = algorithm->AddObserver(vtkCommand::ErrorEvent, collect);
  algorithm->Update();
  algorithm->RemoveObserver(tag);
  return errors;
}

std::string attachResponses(
  const TouchScene& scene, double maximumDeflection, ResponseSet& responses)
{
  const auto begin = std::chrono::steady_clock::now();
  responses.body = scene.body;
  for (const std::string& specification : scene.tools)
  {
    auto tool = vtkSmartPointer<vtkContactTool>::New();
    if (!tool->SetSpecification(specification))
    {
      return "tool '" + specification + "' is not known";
    }
    const std::string name = responses.names.empty()
      ? std::string("Response")
      : "Response" + std::to_string(responses.names.size() + 1);
    vtkNew<vtkToolContactResponse> attach;
    attach->SetTool(tool);
    attach->SetInputData(responses.body);
    attach->SetYoungsModulus(scene.youngsModulus);
    attach->SetPoissonRatio(scene.poissonsRatio);
    attach->SetMaximumDeflection(maximumDeflection);
    attach->SetResponseName(name);
    const std::string error = updateQuietly(attach);
    if (!error.empty())
    {
      return error;
    }
    responses.body = attach->GetOutput();
    responses.tools.push_back(tool);
    responses.names.push_back(name);
  }
  responses.seconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  responses.bytesPerTool = responseBytes(responses.body, responses.names.back());
  return {};
}
} // namespace palpate

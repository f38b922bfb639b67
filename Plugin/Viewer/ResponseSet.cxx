// SPDX-License-Identifier: BSD-3-Clause
#include "ResponseSet.h"

#include "Response/Files/CollectingWindow.h"
#include "Response/FlatBodyConversion.h"
#include "Mechanics/Files/WholeFile.h"

#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLPolyDataWriter.h"

#include <chrono>
#include <cstdio>

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

void warn(const std::string& warning)
{
  if (!warning.empty())
  {
    std::fprintf(stderr, "palpate: warning: %s\n", warning.c_str());
  }
}
} // namespace

std::string updateQuietly(vtkAlgorithm* algorithm)
{
  const QuietScope quiet;
  algorithm->Update();
  quiet.window->printWarnings();
  return quiet.window->hasFailed() ? quiet.window->reason() : std::string();
}

ContactLaw lawOf(const ViewerScene& scene)
{
  return { scene.youngsModulus, scene.poissonsRatio, scene.layer };
}

BodyMaterial::Constants materialOf(const ContactLaw& law)
{
  BodyMaterial::Constants made{ law.youngsModulus, law.poissonsRatio, law.layer.thickness,
    law.layer.stack.base, false };
  if (law.layer.isStack())
  {
    const LayerStack& stack = law.layer.stack;
    const StackLayer& top = stack.layers.front();
    made.youngsModulus = top.youngsModulus;
    made.poissonsRatio = top.poissonsRatio;
    made.thickness = top.thickness;
    made.deeper.assign(stack.layers.begin() + 1, stack.layers.end());
    if (stack.hasHalfSpace)
    {
      made.halfSpace = stack.halfSpace;
    }
  }
  return made;
}

MaterialArrays arraysOf(const ContactLaw& law, const ViewerScene& scene, vtkPolyData* body)
{
  const bool isStack = law.layer.isStack();
  const std::string first = isStack ? "LayerThickness0" : "LayerThickness";
  return materialArrays(body,
    { "", law.layer.scanned ? first : "", scene.solid ? "GlobalCompliance" : "", "",
      law.layer.scanned && isStack ? "LayerThickness1" : "" });
}

std::string responseName(std::size_t tool)
{
  return tool == 0 ? "Response" : "Response" + std::to_string(tool + 1);
}

std::string addToolResponse(const ViewerScene& scene, const std::string& tool,
  const ContactLaw& law, double maximumDeflection, ResponseSet& responses)
{
  auto shape = vtkSmartPointer<vtkContactTool>::New();
  if (!shape->SetSpecification(tool))
  {
    return "tool '" + tool + "' is not known";
  }
  const std::string name = responseName(responses.names.size());
  responses.tools.push_back(shape);
  responses.names.push_back(name);
  if (scene.stored)
  {
    return {};
  }
  const auto body = vtkSmartPointer<vtkPolyData>::New();
  std::string warning;
  const std::string error = attachResponse(Ranks(), responses.body,
    { shape, name, maximumDeflection, materialOf(law), arraysOf(law, scene, responses.body), 8,
      scene.terms, nullptr, { scene.relaxation } },
    {}, body, warning);
  warn(warning);
  if (error.empty())
  {
    responses.body = body;
  }
  return error;
}

namespace
{
std::string attachResponses(
  const ViewerScene& scene, double maximumDeflection, ResponseSet& responses)
{
  const auto begin = std::chrono::steady_clock::now();
  responses.body = scene.body;
  for (const std::string& tool : scene.tools)
  {
    const std::string error =
      addToolResponse(scene, tool, lawOf(scene), maximumDeflection, responses);
    if (!error.empty())
    {
      return error;
    }
  }
  responses.seconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  responses.bytesPerTool = responseBytes(responses.body, responses.names.back());
  return {};
}
} // namespace

std::string saveBody(vtkPolyData* body, const std::string& path)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetDataModeToBinary();   // newer versions of expat cannot read appended data
  writer->WriteToOutputStringOn(); // writing to a file crashes on a full disk (VTK 9.2)
  writer->SetInputData(body);
  const QuietScope quiet;
  writer->Write();
  if (writer->GetErrorCode() != 0 || quiet.window->hasFailed())
  {
    return "cannot write '" + path + "': " + quiet.window->reason();
  }
  WholeFile file(path);
  std::string error = file.open();
  if (error.empty())
  {
    file.write(writer->GetOutputString());
    error = file.finish();
  }
  return error;
}

std::string prepareResponses(
  const ViewerOptions& options, const ViewerScene& scene, ResponseSet& responses)
{
  const std::string error = attachResponses(scene, options.maximumDeflection, responses);
  return error.empty() ? writeResponses(options, responses) : error;
}

std::string writeResponses(const ViewerOptions& options, const ResponseSet& responses)
{
  std::string error;
  if (!options.save.empty())
  {
    error = saveBody(responses.body, options.save);
  }
  if (error.empty() && !options.exportTo.empty())
  {
    error = writeFlatBody(responses.body, responses.names.front(), options.exportTo);
  }
  return error;
}
} // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "ResponseSet.h"

#include "Contact/ResponseContract.h"
#include "Mechanics/Checked.h"
#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Response/Files/CollectingWindow.h"
#include "Response/FlatBodyConversion.h"
#include "Mechanics/Files/WholeFile.h"

#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkXMLPolyDataWriter.h"

#include <chrono>
#include <cstdio>

namespace palpate
{
namespace
{
double responseBytes(vtkPolyData* body, const std::string& response)
{
  double bytes = 0.0;
  for (const ContractArray& array : ResponseContract)
  {
    if (vtkDataArray* found = body->GetPointData()->GetArray(array.named(response).c_str()))
    {
      bytes += static_cast<double>(found->GetNumberOfValues()) * found->GetDataTypeSize();
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
  return { scene.youngsModulus, scene.poissonRatio, scene.layer };
}

BodyMaterial::Constants materialOf(const ContactLaw& law)
{
  BodyMaterial::Constants made{ law.youngsModulus, law.poissonRatio, law.layer.thickness,
    law.layer.stack.base, false };
  if (law.layer.isStack())
  {
    const LayerStack& stack = law.layer.stack;
    const StackLayer& top = stack.layers.front();
    made.youngsModulus = top.youngsModulus;
    made.poissonRatio = top.poissonRatio;
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

namespace
{
/// Adds a tool without a response. Returns "" or an error.
std::string addTool(const std::string& tool, ResponseSet& responses)
{
  auto shape = vtkSmartPointer<vtkContactTool>::New();
  if (!shape->SetSpecification(tool))
  {
    return "tool '" + tool + "' is not known";
  }
  responses.names.push_back(responseName(responses.names.size()));
  responses.tools.push_back(shape);
  return {};
}

/// Attaches the response of a tool. If an array `pressed` is given, the response is attached only
/// at the points where the value of the array is not 0.
std::string attachToolResponse(std::size_t tool, const ViewerScene& scene, const ContactLaw& law,
  double maximumDeflection, const MaterialArray& pressed, ResponseSet& responses)
{
  if (scene.stored)
  {
    return {};
  }
  const auto begin = std::chrono::steady_clock::now();
  LawRequest request;
  request.tool = responses.tools[tool];
  request.responseName = responses.names[tool];
  request.deflection = maximumDeflection;
  request.material = materialOf(law);
  request.arrays = arraysOf(law, scene, responses.body);
  request.terms = scene.terms;
  request.relaxation.series = scene.relaxation;
  request.pressed = pressed;
  const auto body = vtkSmartPointer<vtkPolyData>::New();
  std::string warning;
  const std::string error = attachResponse(Ranks(), responses.body, request, {}, body, warning);
  warn(warning);
  if (error.empty())
  {
    responses.body = body;
  }
  responses.seconds +=
    std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return error;
}

/// Adds all tools of the scene, and attaches the responses of the first `count` tools.
std::string attachResponses(
  const ViewerScene& scene, double maximumDeflection, std::size_t count, ResponseSet& responses)
{
  responses.body = scene.body;
  std::string error;
  for (std::size_t i = 0; i < scene.tools.size() && error.empty(); ++i)
  {
    error = firstFault([&] { return addTool(scene.tools[i], responses); },
      [&]
      {
        return scene.stored
          ? std::string()
          : checkToolDepth(*responses.tools.back()->GetKernel(), maximumDeflection);
      });
  }
  for (std::size_t i = 0; i < count && error.empty(); ++i)
  {
    error = attachToolResponse(i, scene, lawOf(scene), maximumDeflection, {}, responses);
  }
  responses.bytesPerTool = responseBytes(responses.body, responses.names.front());
  return error;
}
} // namespace

std::string addToolResponse(const ViewerScene& scene, const std::string& tool,
  const ContactLaw& law, double maximumDeflection, ResponseSet& responses)
{
  const std::string error = addTool(tool, responses);
  return error.empty()
    ? attachToolResponse(responses.tools.size() - 1, scene, law, maximumDeflection, {}, responses)
    : error;
}

std::string saveBody(vtkPolyData* body, const std::string& path)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetDataModeToBinary();   // not appended data, which newer versions of expat cannot read
  writer->WriteToOutputStringOn(); // not directly to a file, because VTK 9.2 crashes on a full disk
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

namespace
{
std::string attachAndWrite(
  const ViewerOptions& options, const ViewerScene& scene, std::size_t count, ResponseSet& responses)
{
  const std::string error = attachResponses(scene, options.maximumDeflection, count, responses);
  return error.empty() ? writeResponses(options, responses) : error;
}
} // namespace

std::string prepareResponses(
  const ViewerOptions& options, const ViewerScene& scene, ResponseSet& responses)
{
  return attachAndWrite(options, scene, scene.tools.size(), responses);
}

std::string prepareFirstResponse(
  const ViewerOptions& options, const ViewerScene& scene, ResponseSet& responses)
{
  return attachAndWrite(options, scene, options.save.empty() ? 1 : scene.tools.size(), responses);
}

namespace
{
/// Returns an array with 1 at the given points and 0 at all others.
vtkSmartPointer<vtkUnsignedCharArray> maskOf(
  vtkPolyData* body, const std::vector<vtkIdType>& points)
{
  auto mask = vtkSmartPointer<vtkUnsignedCharArray>::New();
  mask->SetNumberOfValues(body->GetNumberOfPoints());
  mask->FillValue(0);
  for (const vtkIdType point : points)
  {
    mask->SetValue(point, 1);
  }
  return mask;
}
} // namespace

std::string attachAtPoints(const ViewerScene& scene, const ResponseSet& responses,
  const std::vector<vtkIdType>& points, const std::string& name, double range, double tolerance,
  vtkSmartPointer<vtkPolyData>& body)
{
  ViewerScene judged = scene;
  judged.terms.errorTolerance = tolerance;
  ResponseSet one;
  one.body = responses.body;
  one.tools = { responses.tools.front() };
  one.names = { name };
  const auto pressed = maskOf(one.body, points);
  std::string error =
    attachToolResponse(0, judged, lawOf(judged), range, { "Pressed", pressed }, one);
  body = one.body;
  return error;
}

std::string addOtherResponses(const ViewerOptions& options, const ViewerScene& scene,
  const std::vector<vtkIdType>& points, ResponseSet& responses)
{
  if (!options.save.empty())
  {
    return {}; // all responses are already attached
  }
  const auto pressed = maskOf(responses.body, points);
  std::string error;
  for (std::size_t i = 1; i < responses.tools.size() && error.empty(); ++i)
  {
    error = attachToolResponse(
      i, scene, lawOf(scene), options.maximumDeflection, { "Pressed", pressed }, responses);
  }
  return error;
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

// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Session/ResponseMaker.h"

#include "Response/BodyConversion.h"
#include "Response/BodyLaws.h"
#include "Haptics/Devices/DeviceFit.h"
#include "Interaction/Session/LeastForm.h"
#include "Interaction/Session/ModulusChange.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <cmath>

namespace palpate
{
namespace
{
/// Fraction of the work that is needed for the curves. The remaining work is for forms and kernels.
constexpr double CurvesShare = 0.8;

/// Scales compliance and modes to another Young's modulus. The compliance is proportional to the
/// inverse of the modulus, the modes to the inverse of its square root.
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
    const bool isMode = name.rfind("GlobalMode", 0) == 0 || name == CouplingModesName;
    if (name != request.complianceArray && name != request.complianceArray + "Error" && !isMode)
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
    data->AddArray(scaled); // this replaces the array with the same name
  }
}

/// Adds the response of a tool to the body. Returns false if the work was stopped.
bool addResponse(const ResponseRequest& request, std::size_t tool, MadeResponses& made,
  const std::function<bool(double)>& goOn)
{
  // FindFault is used because GetKernel would print the error.
  made.error = request.tools[tool]->FindFault();
  if (!made.error.empty())
  {
    return true;
  }
  const LawRequest law{ request.tools[tool], request.names[tool], request.maximumDeflection,
    { request.youngsModulus, request.poissonRatio, request.layerThickness, request.base, false,
      request.deeper, request.halfSpace },
    materialArrays(
      made.body, { "", request.thicknessArray, request.complianceArray, "", request.secondArray }),
    8, request.terms, nullptr, request.relaxation, request.coupling };
  const auto body = vtkSmartPointer<vtkPolyData>::New();
  std::string warning;
  const auto total = static_cast<double>(request.tools.size());
  const auto reached = [&](double done)
  { return goOn(CurvesShare * (static_cast<double>(tool) + done) / total); };
  made.error = attachResponse(Ranks(), made.body, law, reached, body, warning);
  made.warning = made.warning.empty() ? warning : made.warning;
  made.body = body;
  return reached(1.0);
}

/// Returns the body with the form of a tool's response from which a session computes the force.
/// Returns null after an error.
vtkSmartPointer<vtkPolyData> formOfForce(
  const ResponseRequest& request, std::size_t tool, MadeResponses& made)
{
  if (request.tolerance == 0.0)
  {
    return made.body;
  }
  const LeastForm form =
    findLeastForm({ made.body, request.names[tool], request.tolerance, request.choiceDeflection,
      request.complianceArray, request.tools[tool], request.youngsModulus, request.poissonRatio });
  made.error = form.error;
  made.choices.push_back(form.reason);
  return form.body;
}

/// Makes the kernels that the session would otherwise make. The kernels are made one after the
/// other, because making a kernel uses several threads.
void makeKernels(
  const ResponseRequest& request, MadeResponses& made, const std::function<bool(double)>& goOn)
{
  std::shared_ptr<const ContactBody> surface = request.surface;
  for (std::size_t i = 0; i < request.names.size(); ++i)
  {
    const double done = static_cast<double>(i) / static_cast<double>(request.names.size());
    const auto isWanted = [&] { return goOn(CurvesShare + (1.0 - CurvesShare) * done); };
    const vtkSmartPointer<vtkPolyData> formed =
      isWanted() ? formOfForce(request, i, made) : nullptr;
    if (!formed || !isWanted() || !made.error.empty())
    {
      return;
    }
    const std::string& name = request.names[i];
    made.forms.push_back(formed);
    auto& kernel = made.kernels.read[name];
    kernel = surface ? makeContactBody(formed, name, made.error, *surface)
                     : makeContactBody(formed, name, made.error);
    if (kernel)
    {
      surface = kernel;
      DeviceFit peaks(DeviceSpecification{});
      peaks.include(*kernel, request.maximumDeflection);
      made.kernels.peaks[{ name, request.maximumDeflection }] = { peaks.peakForce(),
        peaks.peakStiffness() };
    }
  }
}
} // namespace

MadeResponses makeResponses(const ResponseRequest& request, const std::function<bool(double)>& goOn)
{
  if (request.known &&
    (isModulusChange(request.known->of, request) ||
      (!request.isFinal && isPoissonChange(*request.known, request))))
  {
    return scaleForces(*request.known, request, goOn);
  }
  MadeResponses made;
  made.of = request;
  made.of.surface = nullptr;
  made.of.known = nullptr;
  made.from = request.body;
  made.tools = request.tools;
  made.poissonRatio = request.poissonRatio;
  made.body = vtkSmartPointer<vtkPolyData>::New();
  made.body->ShallowCopy(request.body);
  scaleGlobal(made.body, request);
  for (std::size_t i = 0; !request.stored && i < request.tools.size(); ++i)
  {
    if (!addResponse(request, i, made, goOn) || !made.error.empty())
    {
      break;
    }
  }
  if (made.error.empty())
  {
    makeKernels(request, made, goOn);
  }
  if (!made.error.empty())
  {
    made.body = nullptr;
  }
  return made;
}
} // namespace palpate

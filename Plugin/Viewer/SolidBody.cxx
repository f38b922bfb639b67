// SPDX-License-Identifier: BSD-3-Clause
#include "SolidBody.h"

#include "FacingPoints.h"
#include "Mechanics/JoinedText.h"
#include "Response/BodyConversion.h"
#include "ResponseSet.h"

#include "vtkElasticContactResponse.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkGradedBody.h"
#include "vtkMassProperties.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace palpate
{
namespace
{
// A minute or two on two cores: a factor of a hundred thousand unknowns, two thousand solutions.
constexpr double UsualCells = 20000.0;
constexpr double UsualSources = 2000.0;
/// Of vtkGradedBody: cells on mm² of the surface, in spacings.
constexpr double CellsPerSquare = 8.7;
/// No finer than what a tool feels needs, no coarser than what the body's shape does.
constexpr double LeastOfContact = 0.5;
constexpr double MostOfBody = 1.0 / 6.0;

double secondsSince(std::chrono::steady_clock::time_point begin)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::string roundedText(double value)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

/// How large cells at the surface are to be, and how far apart its points that are solved for.
struct SolidSizes
{
  double spacing = 0.0; ///< mm
  double sources = 0.0; ///< mm
};

SolidSizes chooseSizes(vtkPolyData* body, double given, double contactRadius)
{
  vtkNew<vtkMassProperties> shape;
  shape->SetInputData(body);
  shape->Update();
  const double area = shape->GetSurfaceArea();
  SolidSizes sizes;
  sizes.spacing = given;
  if (given == 0.0)
  {
    sizes.spacing =
      std::max(std::sqrt(CellsPerSquare * area / UsualCells), LeastOfContact * contactRadius);
    sizes.spacing = std::min(sizes.spacing, MostOfBody * std::cbrt(shape->GetVolume()));
  }
  sizes.sources = std::max(sizes.spacing, std::sqrt(area / UsualSources));
  return sizes;
}

/// Weights of points of the solid that have a response; or of one that has none.
std::vector<std::pair<vtkIdType, double>> withResponse(
  const std::vector<std::pair<vtkIdType, double>>& around, vtkDataArray* status)
{
  std::vector<std::pair<vtkIdType, double>> taken;
  double sum = 0.0;
  for (const auto& part : around)
  {
    if (status->GetTuple1(part.first) == 0.0)
    {
      taken.push_back(part);
      sum += part.second;
    }
  }
  if (sum > 0.5)
  {
    for (auto& part : taken)
    {
      part.second /= sum;
    }
    return taken;
  }
  const auto nearest = std::max_element(around.begin(), around.end(),
    [status](const auto& a, const auto& b)
    {
      const auto rank = [status](const auto& part)
      { return status->GetTuple1(part.first) == 0.0 ? -1.0 : part.second; };
      return rank(a) < rank(b);
    });
  return { { nearest->first, 1.0 } };
}
} // namespace

void carryResponse(vtkPolyData* solid, const std::string& name, vtkPolyData* body)
{
  const auto of = [&](ResponseArray array)
  { return solid->GetPointData()->GetArray(arrayName(name, array).c_str()); };
  vtkDataArray* status = of(ResponseArray::Status);
  vtkDataArray* range = of(ResponseArray::Range);
  const FacingPoints sources(solid, [](vtkIdType) { return true; });
  const BodyMesh mesh = makeBodyMesh(body);
  const vtkIdType count = body->GetNumberOfPoints();
  std::vector<vtkDataArray*> from;
  std::vector<vtkSmartPointer<vtkDataArray>> to;
  for (const ContractArray& array : ResponseContract)
  {
    vtkDataArray* found = array.place == ContractArray::Place::Points ? of(array.array) : nullptr;
    if (found)
    {
      from.push_back(found);
      to.push_back(vtkSmartPointer<vtkDataArray>::Take(found->NewInstance()));
      to.back()->SetName(found->GetName());
      to.back()->SetNumberOfComponents(found->GetNumberOfComponents());
      to.back()->SetNumberOfTuples(count);
      to.back()->Fill(0.0);
    }
  }
  vtkDataArray* normals = of(ResponseArray::Normal);
  vtkDataArray* stiffness = of(ResponseArray::Stiffness);
  for (vtkIdType i = 0; i < count; ++i)
  {
    std::array<double, 3> place{};
    body->GetPoint(i, place.data());
    const Vector3 normal = mesh.pointNormal(static_cast<std::int32_t>(i));
    auto sum = sources.around(place.data(), normal);
    const bool isAlone = sum.empty();
    if (!isAlone)
    {
      sum = withResponse(sum, status);
    }
    double depth = 0.0;
    for (const auto& [id, weight] : sum)
    {
      depth += weight * range->GetTuple1(id);
    }
    for (std::size_t a = 0; a < from.size(); ++a)
    {
      if (from[a] == normals)
      {
        to[a]->SetTuple(i, normal.data());
        continue;
      }
      if (isAlone)
      {
        to[a]->SetComponent(
          i, 0, from[a] == status ? static_cast<double>(ResponseStatus::OutOfReach) : 0.0);
        continue;
      }
      if (vtkUnsignedCharArray::SafeDownCast(from[a]))
      {
        const auto most = std::max_element(
          sum.begin(), sum.end(), [](const auto& x, const auto& y) { return x.second < y.second; });
        to[a]->SetTuple(i, most->first, from[a]);
        continue;
      }
      for (int k = 0; k < from[a]->GetNumberOfComponents(); ++k)
      {
        double value = 0.0;
        for (const auto& [id, weight] : sum)
        {
          // At equal fractions of their ranges; what is per mm is so of the blended one.
          const double stretch =
            from[a] == stiffness && depth > 0.0 ? range->GetTuple1(id) / depth : 1.0;
          value += weight * stretch * from[a]->GetComponent(id, k);
        }
        to[a]->SetComponent(i, k, value);
      }
    }
  }
  for (const auto& array : to)
  {
    body->GetPointData()->AddArray(array);
  }
  for (const ContractArray& array : ResponseContract)
  {
    vtkAbstractArray* found =
      solid->GetFieldData()->GetAbstractArray(arrayName(name, array.array).c_str());
    if (array.place == ContractArray::Place::Fields && found)
    {
      body->GetFieldData()->AddArray(found);
    }
  }
}

std::string attachSolidResponses(const ViewerOptions& options, TouchScene& scene)
{
  std::vector<vtkSmartPointer<vtkContactTool>> tools;
  std::vector<double> radii;
  for (const std::string& text : scene.tools)
  {
    tools.push_back(vtkSmartPointer<vtkContactTool>::New());
    if (!tools.back()->SetSpecification(text))
    {
      return "tool '" + text + "' is not known";
    }
    radii.push_back(tools.back()->GetKernel()->contactRadius(options.maximumDeflection));
  }
  // The widest first: the others share its solutions.
  std::vector<std::size_t> order(tools.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(),
    [&radii](std::size_t a, std::size_t b) { return radii[a] > radii[b]; });
  const SolidSizes sizes = chooseSizes(scene.body, options.solidSpacing, radii[order.front()]);
  auto begin = std::chrono::steady_clock::now();
  vtkNew<vtkGradedBody> filled;
  filled->SetInputData(scene.body);
  filled->SetSurfaceSpacing(sizes.spacing);
  filled->SetFixedFaces(options.fixedFaces);
  std::string error = updateQuietly(filled);
  if (!error.empty())
  {
    return error;
  }
  const double filledIn = secondsSince(begin);
  begin = std::chrono::steady_clock::now();
  vtkNew<vtkElasticContactResponse> pressed;
  pressed->SetInputConnection(filled->GetOutputPort());
  pressed->SetYoungsModulus(scene.youngsModulus);
  pressed->SetPoissonRatio(scene.poissonsRatio);
  pressed->SetMaximumDeflection(options.maximumDeflection);
  pressed->SetErrorTolerance(scene.terms.errorTolerance);
  pressed->SetSourceSpacing(sizes.sources);
  const auto body = vtkSmartPointer<vtkPolyData>::New();
  body->ShallowCopy(scene.body);
  vtkIdType solutions = 0;
  for (const std::size_t t : order)
  {
    const std::string name = t == 0 ? "Response" : "Response" + std::to_string(t + 1);
    pressed->SetTool(tools[t]);
    pressed->SetResponseName(name);
    error = updateQuietly(pressed);
    if (!error.empty())
    {
      return error;
    }
    solutions += pressed->GetNumberOfSolutions();
    carryResponse(pressed->GetOutput(), name, body);
  }
  scene.notes.push_back(joined("filled with ", filled->GetOutput()->GetNumberOfCells(),
    " tetrahedra of ", filled->GetOutput()->GetNumberOfPoints(), " nodes, ",
    roundedText(sizes.spacing), " mm at the surface",
    options.solidSpacing == 0.0 ? " (chosen from its size and the tools)" : "", ", held at ",
    options.fixedFaces, ", in ", roundedText(filledIn), " s; ", solutions,
    " points of it solved for, ", roundedText(sizes.sources), " mm apart, and ", tools.size(),
    tools.size() == 1 ? " tool in " : " tools in ", roundedText(secondsSince(begin)), " s"));
  scene.body = body;
  scene.stored = true;
  scene.modelReason = responseText(body, "Response", ResponseArray::Model);
  return {};
}
} // namespace palpate

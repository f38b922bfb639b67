// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/FactorisedBody.h"

#include "Mechanics/Checked.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/Numerics/AvailableMemory.h"
#include "Mechanics/ReducedModulus.h"
#include "SolidResponse/Bodies/VolumeConversion.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <utility>

namespace palpate
{
namespace
{
/// Fraction of the available memory for the factorisation. The remaining memory is for the
/// solutions and for other programs.
constexpr double MemoryShare = 0.9;

std::string refusal(vtkIdType unknowns, double memoryLimit, double memory)
{
  return joined("The factorisation of ", unknowns, " unknowns needs about ", memory,
    " MiB, more than ",
    memoryLimit > 0.0 ? "Memory Limit, " : "what is available (Memory Limit is 0), ",
    allowedMemory(memoryLimit) / Mebibyte, " MiB");
}
} // namespace

bool isElementRatio(double ratio)
{
  return ratio >= 0.0 && ratio <= LargestPoissonRatio;
}

std::string checkFactorRequest(const FactorRequest& request)
{
  if (!isYoungsModulus(request.material.youngsModulus))
  {
    return joined(
      "Young's Modulus must be positive and finite (MPa), but is ", request.material.youngsModulus);
  }
  const double ratio = request.material.poissonRatio;
  if (!isElementRatio(ratio))
  {
    return joined("Poisson's Ratio must lie between 0 and ", LargestPoissonRatio,
      " (finite elements need a compressible material), but is ", ratio);
  }
  if (!(request.memoryLimit >= 0.0))
  {
    return joined("Memory Limit must be 0 or positive (MiB), but is ", request.memoryLimit);
  }
  if (request.solver < static_cast<int>(StiffnessFactor::Kind::Automatic) ||
    request.solver > static_cast<int>(StiffnessFactor::Kind::Simplicial))
  {
    return joined("Solver must be 0, 1 or 2, but is ", request.solver);
  }
  return {};
}

double allowedMemory(double memoryLimit)
{
  return memoryLimit > 0.0 ? Mebibyte * memoryLimit : MemoryShare * availableMemory();
}

namespace
{
std::string findGridArray(vtkAlgorithm* filter, vtkDataSetAttributes* data, vtkIdType count,
  int index, const std::function<vtkDataArray*(int)>& find, vtkDataArray*& array)
{
  array = nullptr;
  vtkInformationVector* wanted =
    filter->GetInformation()->Get(vtkAlgorithm::INPUT_ARRAYS_TO_PROCESS());
  if (!wanted || index >= wanted->GetNumberOfInformationObjects() ||
    !wanted->GetInformationObject(index)->Has(vtkAlgorithm::INPUT_PORT()))
  {
    return {}; // no array was set, so the constant property is used
  }
  vtkInformation* which = wanted->GetInformationObject(index);
  const char* name =
    which->Has(vtkDataObject::FIELD_NAME()) ? which->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  if (name && !*name)
  {
    return {}; // an empty name means that no array is requested
  }
  array = name ? data->GetArray(name) : find(index);
  if (!array)
  {
    const bool isOfCells = data->IsA("vtkCellData");
    const char* label = !isOfCells ? "Layer Thickness Array"
      : index % 2 == 0             ? "Young's Modulus Array"
                                   : "Poisson's Ratio Array";
    return joined(label, " '", name ? name : "active attribute", "' (array to process ", index,
      ") is not on the input's ", isOfCells ? "cells" : "points");
  }
  if (array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != count)
  {
    return joined("Array '", array->GetName(), "' must have 1 component and ", count,
      " tuples, but has ", array->GetNumberOfComponents(), " and ", array->GetNumberOfTuples());
  }
  return {};
}
} // namespace

std::string findCellArray(vtkAlgorithm* filter, vtkUnstructuredGrid* grid, int index,
  const std::function<vtkDataArray*(int)>& find, vtkDataArray*& array)
{
  return findGridArray(filter, grid->GetCellData(), grid->GetNumberOfCells(), index, find, array);
}

std::string findPointArray(vtkAlgorithm* filter, vtkUnstructuredGrid* grid, int index,
  const std::function<vtkDataArray*(int)>& find, vtkDataArray*& array)
{
  return findGridArray(filter, grid->GetPointData(), grid->GetNumberOfPoints(), index, find, array);
}

std::string factoriseBody(vtkUnstructuredGrid* grid, const FactorRequest& request,
  const std::function<bool(double)>& goOn, ElasticBody& body, double& memory, bool& ended)
{
  const auto wrong = [](const std::string& fault) { return prefixed("Wrong input: ", fault); };
  ended = false;
  const auto ends = [&](double done)
  {
    ended = !goOn(done);
    return ended;
  };
  ElasticBodyInput input;
  std::string fault = firstFault([&] { return convertVolume(grid, input.mesh); },
    [&] { return convertFixed(grid, input.fixed); });
  if (!fault.empty())
  {
    return wrong(fault);
  }
  input.materials =
    convertMaterials(grid->GetNumberOfCells(), request.young, request.poisson, request.material);
  fault = body.take(std::move(input));
  if (!fault.empty())
  {
    return wrong(fault);
  }
  const MemoryForecast forecast = body.memoryForecast();
  if (forecast.exceeds(allowedMemory(request.memoryLimit)))
  {
    memory = (forecast.matrix + forecast.factor) / Mebibyte;
    return refusal(3 * grid->GetNumberOfPoints(), request.memoryLimit, memory);
  }
  fault = body.assemble();
  if (!fault.empty() || ends(0.1))
  {
    return wrong(fault);
  }
  fault = body.analyse(static_cast<StiffnessFactor::Kind>(request.solver));
  if (!fault.empty())
  {
    return wrong(fault);
  }
  memory = body.memoryEstimate() / Mebibyte;
  if (body.memoryEstimate() > allowedMemory(request.memoryLimit))
  {
    return refusal(body.unknowns(), request.memoryLimit, memory);
  }
  if (ends(0.3))
  {
    return {};
  }
  fault = body.factorise();
  if (fault.empty())
  {
    ends(1.0);
  }
  return wrong(fault);
}
} // namespace palpate

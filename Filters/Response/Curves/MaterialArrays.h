// SPDX-License-Identifier: BSD-3-Clause
#ifndef MaterialArrays_h
#define MaterialArrays_h

#include "palpateResponseModule.h"

#include "Laws/BodyMaterial.h"

#include <array>
#include <functional>
#include <string>

class vtkAlgorithm;
class vtkDataArray;
class vtkPolyData;

namespace palpate
{
class Ranks;

/// The point arrays of a body that override its constants: 0 Young's modulus, 1 layer thickness,
/// 2 global compliance, 3 Poisson's ratio. One that is not wanted has no name; one that is wanted
/// and not there has no array.
struct MaterialArray
{
  std::string name;
  vtkDataArray* array = nullptr;
};
using MaterialArrays = std::array<MaterialArray, 4>;

/// Those that a filter was told to process; `find(index)` fetches one.
MaterialArrays arraysToProcess(
  vtkAlgorithm* filter, const std::function<vtkDataArray*(int index)>& find);
/// Those of these names; "" for one that is not wanted.
PALPATERESPONSE_EXPORT MaterialArrays materialArrays(
  vtkPolyData* body, const std::array<std::string, 4>& names);

/// Gives `material` the values of the points of a body. Returns what is wrong, naming property or
/// array, point and value, or "".
std::string readMaterial(vtkPolyData* body, const MaterialArrays& arrays, BodyMaterial& material);

/// After readMaterial, on every rank that has a piece of the body, and without it on those that
/// have none: the range of `material` becomes that of the whole body. Collective.
void agreeOnRange(const Ranks& ranks, bool hasPiece, BodyMaterial& material);

/// Attaches <name>LayerThickness and <name>LayerBase, if there are layers.
void attachLayers(const BodyMaterial& material, const std::string& name, vtkPolyData* output);
} // namespace palpate

#endif

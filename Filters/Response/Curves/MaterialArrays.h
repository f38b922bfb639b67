// SPDX-License-Identifier: BSD-3-Clause
#ifndef MaterialArrays_h
#define MaterialArrays_h

#include "palpateResponseModule.h"

#include "Laws/BodyMaterial.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;
class vtkPolyData;

namespace palpate
{
class Ranks;

/// The point arrays of a body that override its constants: 0 Young's modulus, 1 layer thickness,
/// 2 global compliance, 3 Poisson's ratio, 4 thickness of a stack's second layer. One that is not
/// wanted has no name; one that is wanted and not there has no array. Beside a compliance an array
/// named <its name>Error says, if it is there, how far it may be off.
struct MaterialArray
{
  std::string name;
  vtkDataArray* array = nullptr;
};
using MaterialArrays = std::array<MaterialArray, 5>;

/// `first` with the layers that were added to a filter, each as thickness (mm), Young's modulus
/// (MPa), Poisson's ratio and whether it slips, and with an elastic base in place of the rigid one.
BodyMaterial::Constants layeredMaterial(BodyMaterial::Constants first,
  const std::vector<std::array<double, 4>>& added, bool isElasticBase, double baseModulus,
  double baseRatio);

/// One that a filter was told to process, without a name if it was not; `find(index)` fetches it.
MaterialArray arrayToProcess(
  vtkAlgorithm* filter, int index, const std::function<vtkDataArray*(int index)>& find);
/// Those that a filter was told to process.
MaterialArrays arraysToProcess(
  vtkAlgorithm* filter, const std::function<vtkDataArray*(int index)>& find);
/// Those of these names; "" for one that is not wanted.
PALPATERESPONSE_EXPORT MaterialArrays materialArrays(
  vtkPolyData* body, const std::array<std::string, 5>& names);

/// Gives `material` the values of the points of a body. Returns what is wrong, naming property or
/// array, point and value, or "".
std::string readMaterial(vtkPolyData* body, const MaterialArrays& arrays, BodyMaterial& material);

/// After readMaterial, on every rank that has a piece of the body, and without it on those that
/// have none: the range of `material` becomes that of the whole body. Collective.
void agreeOnRange(const Ranks& ranks, bool hasPiece, BodyMaterial& material);

/// Attaches <name>LayerThickness and <name>LayerBase, if there are layers; of a stack also, as
/// field data, <name>LayerStack (double 4: thickness in mm, 0 for the half-space; E in MPa, ν,
/// whether it slips below what is above it; one tuple each, from the top, those that vary at their
/// thinnest), and <name>SecondThickness per point.
void attachLayers(const BodyMaterial& material, const std::string& name, vtkPolyData* output);
} // namespace palpate

#endif

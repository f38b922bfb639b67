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

/// The point arrays of a body that override its constants: 0 Young's modulus, 1 layer thickness, 2
/// global compliance, 3 Poisson's ratio, 4 thickness of a stack's second layer. One that is not
/// wanted has no name; one that is wanted but missing has no array. With a compliance, an array
/// named <its name>Error is its error, if present.
struct MaterialArray
{
  std::string name;
  vtkDataArray* array = nullptr;
};
using MaterialArrays = std::array<MaterialArray, 5>;

/// `first` with the layers that were added to a filter, each by thickness (mm), Young's modulus
/// (MPa), Poisson's ratio and whether it slides, and with an elastic base in place of the rigid
/// one.
BodyMaterial::Constants layeredMaterial(BodyMaterial::Constants first,
  const std::vector<std::array<double, 4>>& added, bool isElasticBase, double baseModulus,
  double baseRatio);

/// The array that a filter was told to process, without a name if none was set; `find(index)`
/// fetches it.
MaterialArray arrayToProcess(
  vtkAlgorithm* filter, int index, const std::function<vtkDataArray*(int index)>& find);
/// All arrays that a filter was told to process.
MaterialArrays arraysToProcess(
  vtkAlgorithm* filter, const std::function<vtkDataArray*(int index)>& find);
/// Those of these names; "" for one that is not wanted.
PALPATERESPONSE_EXPORT MaterialArrays materialArrays(
  vtkPolyData* body, const std::array<std::string, 5>& names);

/// Gives `material` the values of the points of a body. Returns what is wrong, naming property or
/// array, point and value, or "".
std::string readMaterial(vtkPolyData* body, const MaterialArrays& arrays, BodyMaterial& material);

/// Makes the range of `material` that of the whole body, after readMaterial on the ranks that have
/// a piece of it. Collective: the ranks without one call it, too.
void agreeOnRange(const Ranks& ranks, bool hasPiece, BodyMaterial& material);

/// Attaches <name>LayerThickness and <name>LayerBase, if there are layers; of a stack also, as
/// field data, <name>LayerStack (double 4: thickness in mm, 0 for the half-space; E in MPa, ν,
/// whether it slides below the layer above; one tuple each, from the top, varying ones at their
/// thinnest), and <name>SecondThickness per point.
void attachLayers(const BodyMaterial& material, const std::string& name, vtkPolyData* output);
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef MaterialArrays_h
#define MaterialArrays_h

#include "palpateResponseModule.h"

#include "Laws/BodyMaterial.h"
#include "Mechanics/Relaxation/PronySeries.h"

#include "vtkType.h"

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;
class vtkPolyData;

namespace palpate
{
class Ranks;

/// A point array of a body that replaces a constant of the material. Its index is 0 for Young's
/// modulus, 1 for the layer thickness, 2 for the global compliance, 3 for Poisson's ratio, and 4
/// for the thickness of the second layer of a stack.
///
/// The name is empty if no array is requested. The array is null if it is requested but missing. An
/// array whose name is that of the compliance array followed by `Error` contains the error of the
/// compliance. An array whose name is that of a thickness array followed by `Error` contains the
/// error of 1/thickness, 1/mm.
struct MaterialArray
{
  std::string name;
  vtkDataArray* array = nullptr;
};
using MaterialArrays = std::array<MaterialArray, 5>;
constexpr std::size_t ThicknessArrayIndex = 1;
constexpr std::size_t ComplianceArrayIndex = 2;
constexpr std::size_t SecondArrayIndex = 4;
/// Index of the array to process that contains the strengths of the relaxation at each point.
constexpr int RelaxationArrayIndex = 5;

/// The relaxation of a body. Without branches the body does not relax.
struct RelaxationRequest
{
  PronySeries series;
  /// Array of strengths with one component per branch; it replaces the strengths of the series.
  MaterialArray strength = {};
  bool complianceRelaxes = true; ///< whether the global compliance relaxes with the material
};

/// Returns the material `first` with the layers that were added to a filter. The four numbers of a
/// layer are its thickness (mm), Young's modulus (MPa), Poisson's ratio, and whether it slips. If
/// `isElasticBase` is set, an elastic base replaces the rigid base.
BodyMaterial::Constants layeredMaterial(BodyMaterial::Constants first,
  const std::vector<std::array<double, 4>>& added, bool isElasticBase, double baseModulus,
  double baseRatio);

/// Returns the array that is set as the input array `index` of a filter. `find(index)` fetches the
/// array. If none is set, the returned name is empty.
MaterialArray arrayToProcess(
  vtkAlgorithm* filter, int index, const std::function<vtkDataArray*(int index)>& find);
/// Returns all arrays that are set as input arrays of a filter.
MaterialArrays arraysToProcess(
  vtkAlgorithm* filter, const std::function<vtkDataArray*(int index)>& find);
/// Returns the arrays with the names `names`. An empty name means that no array is requested.
PALPATERESPONSE_EXPORT MaterialArrays materialArrays(
  vtkPolyData* body, const std::array<std::string, 5>& names);

/// Returns the error message for a requested array that the body does not have. The message
/// contains the label of the property in the panel. `index` is 0 to 4 (see MaterialArray), 5 for
/// the relaxation or 6 for the pressed points.
std::string missingArray(const std::string& name, std::size_t index);

/// Checks that a requested array exists and has one value for each of `points` points. `index` is
/// the index of the array to process. Returns "" or an error message.
std::string checkPointArray(const MaterialArray& given, std::size_t index, vtkIdType points);

/// Sets the values of `material` at the points of a body. Returns "" or an error that names the
/// property or the array, the point and the value.
std::string readMaterial(vtkPolyData* body, const MaterialArrays& arrays, BodyMaterial& material);

/// Sets the range of `material` to the range over the whole body. On the ranks that have a piece,
/// call it after readMaterial. Collective; ranks without a piece must also call it.
void agreeOnRange(const Ranks& ranks, bool hasPiece, BodyMaterial& material);
} // namespace palpate

#endif

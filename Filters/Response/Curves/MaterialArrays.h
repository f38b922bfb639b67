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

/// The point arrays of a body that override its constants: 0 Young's modulus, 1 layer thickness, 2
/// global compliance, 3 Poisson's ratio, 4 thickness of a stack's second layer. An array that is
/// not requested has no name; an array that is requested but missing is null. An array with the
/// name of the compliance array followed by `Error`, if present, is the error of the compliance. An
/// array with the name of a thickness array followed by `Error`, if present, is the error of
/// 1/thickness (1/mm).
struct MaterialArray
{
  std::string name;
  vtkDataArray* array = nullptr;
};
using MaterialArrays = std::array<MaterialArray, 5>;
constexpr std::size_t ThicknessArrayIndex = 1;
constexpr std::size_t ComplianceArrayIndex = 2;
constexpr std::size_t SecondArrayIndex = 4;
/// Index of the array to process that has the strengths of the relaxation at each point.
constexpr int RelaxationArrayIndex = 5;

/// The relaxation of a body. Without branches the body does not relax.
struct RelaxationRequest
{
  PronySeries series;
  MaterialArray strength = {};   ///< one component per branch; replaces the strengths of the series
  bool complianceRelaxes = true; ///< whether the global compliance relaxes with the material
};

/// The material `first` with the layers that were added to a filter (each with thickness (mm),
/// Young's modulus (MPa), Poisson's ratio and whether the layer slips), and with an elastic base
/// instead of the rigid one if `isElasticBase`.
BodyMaterial::Constants layeredMaterial(BodyMaterial::Constants first,
  const std::vector<std::array<double, 4>>& added, bool isElasticBase, double baseModulus,
  double baseRatio);

/// The array that is set as input of a filter; without a name if none was set. `find(index)`
/// fetches it.
MaterialArray arrayToProcess(
  vtkAlgorithm* filter, int index, const std::function<vtkDataArray*(int index)>& find);
/// All arrays that are set as inputs of a filter.
MaterialArrays arraysToProcess(
  vtkAlgorithm* filter, const std::function<vtkDataArray*(int index)>& find);
/// The arrays with these names; "" for an array that is not requested.
PALPATERESPONSE_EXPORT MaterialArrays materialArrays(
  vtkPolyData* body, const std::array<std::string, 5>& names);

/// The message for a requested array that the body lacks. It names the property on the panel: of
/// the arrays above, of 5 (relaxation) or of 6 (pressed points).
std::string missingArray(const std::string& name, std::size_t index);

/// Checks that a requested array exists and has one value for each of `points` points. `index` is
/// the index of the array to process. Returns "" or an error message.
std::string checkPointArray(const MaterialArray& given, std::size_t index, vtkIdType points);

/// Sets the values of `material` at the points of a body. Returns "" or an error that names
/// property or array, point and value.
std::string readMaterial(vtkPolyData* body, const MaterialArrays& arrays, BodyMaterial& material);

/// Sets the range of `material` to that of the whole body, after readMaterial on the ranks that
/// have a piece. Collective: the ranks without a piece call it, too.
void agreeOnRange(const Ranks& ranks, bool hasPiece, BodyMaterial& material);
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef MaterialArrays_h
#define MaterialArrays_h

#include "Laws/BodyMaterial.h"

#include <functional>
#include <string>

class vtkAlgorithm;
class vtkDataArray;
class vtkPolyData;

namespace palpate
{
class Ranks;

/// Gives `material` what a filter was told to use of the points of a body, its arrays to process
/// 0 Young's modulus, 1 layer thickness, 2 global compliance, 3 Poisson's ratio; `find(index)`
/// fetches one. Returns what is wrong, naming property or array, point and value, or "".
std::string readMaterial(vtkAlgorithm* filter, vtkPolyData* body,
  const std::function<vtkDataArray*(int index)>& find, BodyMaterial& material);

/// After readMaterial, on every rank that has a piece of the body, and without it on those that
/// have none: the range of `material` becomes that of the whole body. Collective.
void agreeOnRange(const Ranks& ranks, bool hasPiece, BodyMaterial& material);

/// Attaches <name>LayerThickness and <name>LayerBase, if there are layers.
void attachLayers(const BodyMaterial& material, const std::string& name, vtkPolyData* output);
} // namespace palpate

#endif

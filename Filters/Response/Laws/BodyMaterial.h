// SPDX-License-Identifier: BSD-3-Clause
#ifndef BodyMaterial_h
#define BodyMaterial_h

#include "LayerTable.h"
#include "ResponseFiller.h"

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

/**
 * What a body is made of, point by point, as a filter's properties and arrays to process say:
 * 0 Young's modulus, 1 layer thickness, 2 global compliance, 3 Poisson's ratio.
 */
class BodyMaterial
{
public:
  /// The properties: for points without an array.
  struct Constants
  {
    double youngsModulus; ///< MPa
    double poissonsRatio;
    double thickness; ///< mm, 0 for a half-space
    LayerBase base;
    bool complianceExcludesLayer;
  };
  explicit BodyMaterial(const Constants& constants);

  /// Reads the arrays the filter was told to use; `find(index)` fetches one. Returns what is wrong,
  /// naming property or array, point and value, or "".
  using Find = std::function<vtkDataArray*(int index)>;
  std::string read(vtkAlgorithm* filter, vtkPolyData* body, const Find& find);

  /// After read, on every rank that has a piece of the body, and without it on those that have
  /// none: what is of the whole body below holds for all pieces. Collective.
  void agree(const Ranks& ranks, bool hasPiece);

  ResponseMaterial view() const;
  bool hasLayers() const noexcept { return this->Layers.thickest > 0.0; }
  const LayerTable::Layers& layers() const noexcept { return this->Layers; }
  /// Whether a compliance is negative somewhere.
  bool stiffens() const noexcept { return this->Stiffens; }

  /// The exponent with the smaller storage error where the body is softest, stiffest, thinnest and
  /// thickest: the tip's, or 1.
  double bestExponent(const AxisymmetricTool& tool, const ResponseLaw& law) const;

  /// The model in words.
  std::string describe() const;
  /// Attaches <name>LayerThickness and <name>LayerBase, if there are layers.
  void attachLayers(vtkPolyData* output, const std::string& name) const;

private:
  std::string checkConstants() const;
  std::string readModulus(vtkDataArray* young, vtkDataArray* poisson, vtkIdType points);
  void findLayers(vtkIdType points);
  void addRatio(double poissonsRatio);
  void findExtremes();

  Constants Given;
  std::vector<double> ReducedModulus; ///< empty vectors: the constant holds
  std::vector<double> PoissonsRatio;
  std::vector<double> Compliance;
  std::vector<double> Thickness;
  LayerTable::Layers Layers;
  bool Stiffens = false;
  /// The spots that are softest, stiffest, thinnest and thickest.
  using Extremes = std::array<ContactSpot, 4>;
  static void widen(Extremes& extremes, const ContactSpot& spot);
  Extremes Extreme{};
};
} // namespace palpate

#endif

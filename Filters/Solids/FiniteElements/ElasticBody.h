// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ElasticBody_h
#define palpate_ElasticBody_h

#include "Solids/FiniteElements/BodySurface.h"
#include "Solids/FiniteElements/MemoryForecast.h"
#include "Mechanics/PalpateExport.h"
#include "Solids/FiniteElements/StiffnessFactor.h"

namespace palpate
{
/// Mesh, materials and fixed nodes of a linear elastic body, in mm, N and MPa.
struct ElasticBodyInput
{
  VolumeMesh mesh;
  std::vector<ElasticMaterial> materials; ///< one per element, or one for all elements
  /// For each node, a sum of the bits FixedX, FixedY and FixedZ.
  std::vector<unsigned char> fixed;
};

/**
 * A linear elastic body under small loads: mesh, surface, stiffness and its factor.
 *
 * Call take(), assemble(), analyse() and factorise() in this order. The other functions may then be
 * called any number of times. After an error the body must not be used further.
 */
class PALPATE_EXPORT ElasticBody
{
public:
  /// Stores the input. Returns "", or an error message with the index of the element or node: a
  /// part of the body is floating, or E or ν is out of range. memoryForecast() is valid after this
  /// call.
  std::string take(ElasticBodyInput input);
  MemoryForecast memoryForecast() const;
  /// Assembles the stiffness. Returns "", or an error message about inverted elements.
  std::string assemble();
  /// Calls take() and assemble(). Returns "" or an error message.
  std::string assemble(ElasticBodyInput input);

  /// Chooses the order of elimination. Returns "" or an error message. After this call,
  /// memoryEstimate() is the memory that factorise() needs.
  std::string analyse(StiffnessFactor::Kind kind);
  double memoryEstimate() const; ///< Returns the estimated memory of the factorisation, bytes.
  std::string factorise();

  const VolumeMesh& mesh() const { return this->Input.mesh; }
  const MeshTopology& topology() const { return this->Topology; }
  const BodySurface& surface() const { return this->Surface; }
  const StiffnessMatrix& stiffness() const { return this->Stiffness; }
  const StiffnessFactor& factor() const { return *this->Factor; }
  int unknowns() const { return static_cast<int>(this->Stiffness.lower.rows()); }
  /// Returns the index of the unknown of a node along an axis, or -1 if the node is fixed along the
  /// axis.
  int unknown(std::int32_t node, int axis) const
  {
    return this->Stiffness.dof[3 * static_cast<std::size_t>(node) + static_cast<std::size_t>(axis)];
  }

  /// Returns whether a node is fixed in all three directions.
  bool isHeld(std::int32_t node) const
  {
    return this->unknown(node, 0) < 0 && this->unknown(node, 1) < 0 && this->unknown(node, 2) < 0;
  }

  /// Returns whether the body has a single material.
  bool isUniform() const;
  const ElasticMaterial& material(std::int32_t element) const
  {
    const std::vector<ElasticMaterial>& all = this->Input.materials;
    return all[all.size() == 1 ? 0 : static_cast<std::size_t>(element)];
  }
  /// Returns the mean E and ν of the elements that meet at a node.
  ElasticMaterial materialAt(std::int32_t node) const;

  /// Returns the displacement of every node (3 × nodes, mm) under forces on the nodes (3 × nodes,
  /// N).
  Eigen::Matrix3Xd displacement(const Eigen::Matrix3Xd& forces) const;

private:
  std::string checkInput() const;

  ElasticBodyInput Input;
  MeshTopology Topology;
  BodySurface Surface;
  StiffnessMatrix Stiffness;
  std::unique_ptr<StiffnessFactor> Factor;
};
} // namespace palpate

#endif

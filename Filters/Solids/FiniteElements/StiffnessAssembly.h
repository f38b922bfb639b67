// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_StiffnessAssembly_h
#define palpate_StiffnessAssembly_h

#include "Solids/FiniteElements/ElasticElement.h"
#include "Mechanics/PalpateExport.h"

#include <Eigen/SparseCore>

namespace palpate
{
/// Bits of a node that does not move: along x, y, z.
constexpr unsigned char FixedX = 1;
constexpr unsigned char FixedY = 2;
constexpr unsigned char FixedZ = 4;

/// Lower triangle of a symmetric matrix, by columns.
using SymmetricSparse = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

/**
 * The stiffness matrix of a body, without fixed unknowns.
 *
 * `dof` (3 per node) maps a node's direction to its unknown, -1 where it is fixed or the node
 * belongs to no element; unknowns are numbered in the order of the nodes.
 */
struct StiffnessMatrix
{
  SymmetricSparse lower;
  std::vector<int> dof;
};

/// Numbers the unknowns and sums the elements. `materials` holds one per element, or one for all.
/// Returns what is wrong (an inverted element, by its index), or "".
PALPATE_EXPORT std::string assembleStiffness(const VolumeMesh& mesh, const MeshTopology& topology,
  const std::vector<ElasticMaterial>& materials, const std::vector<unsigned char>& fixed,
  StiffnessMatrix& stiffness);

/// Adds an element's matrix to those of others.
PALPATE_EXPORT void addElement(
  const VolumeElement& element, const ElementMatrix& k, StiffnessMatrix& stiffness);

/**
 * Finds a part of the body that is free to move as a whole.
 *
 * A part is connected by shared nodes. Its fixed directions must prevent its six rigid motions;
 * mechanisms inside a part (two halves that share an edge only) are not searched, as the
 * factorisation fails on them. Returns a sentence that names the part by its first element and the
 * number of free motions, or "".
 */
PALPATE_EXPORT std::string findFloatingPart(
  const VolumeMesh& mesh, const MeshTopology& topology, const std::vector<unsigned char>& fixed);
} // namespace palpate

#endif

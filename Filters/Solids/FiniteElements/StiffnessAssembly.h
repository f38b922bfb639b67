// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_StiffnessAssembly_h
#define palpate_StiffnessAssembly_h

#include "Solids/FiniteElements/ElasticElement.h"
#include "Mechanics/PalpateExport.h"

#include <Eigen/SparseCore>

namespace palpate
{
/// Bits for a node that is fixed along x, y, z.
constexpr unsigned char FixedX = 1;
constexpr unsigned char FixedY = 2;
constexpr unsigned char FixedZ = 4;

/// Lower triangle of a symmetric matrix, stored column by column.
using SymmetricSparse = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

/**
 * The stiffness matrix of a body, without the fixed degrees of freedom.
 *
 * `dof` (3 per node) maps a node's direction to its unknown. It is -1 if the direction is fixed or
 * the node is not part of any element. Unknowns are numbered in the order of the nodes.
 */
struct StiffnessMatrix
{
  SymmetricSparse lower;
  std::vector<int> dof;
};

/// Numbers the unknowns and sums the element matrices. `materials` has one entry per element, or
/// one for all elements. Returns "", or an error message with the index of an inverted element.
PALPATE_EXPORT std::string assembleStiffness(const VolumeMesh& mesh, const MeshTopology& topology,
  const std::vector<ElasticMaterial>& materials, const std::vector<unsigned char>& fixed,
  StiffnessMatrix& stiffness);

/// Adds an element's matrix to the stiffness.
PALPATE_EXPORT void addElement(
  const VolumeElement& element, const ElementMatrix& k, StiffnessMatrix& stiffness);

/**
 * Finds a part of the body that is free to move as a whole.
 *
 * The nodes that elements share connect a part. The fixed directions of a part must prevent its six
 * rigid motions. The function does not search for mechanisms inside a part (such as two halves that
 * share only an edge), because the factorisation fails for a mechanism. Returns "", or a sentence
 * with the first element of the floating part and the number of its free rigid motions.
 */
PALPATE_EXPORT std::string findFloatingPart(
  const VolumeMesh& mesh, const MeshTopology& topology, const std::vector<unsigned char>& fixed);
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * The parts of a user's body, which are the blocks of a composite data set. Each block is a data
 * set or the partitions of a data set. Empty parts are skipped.
 */
#ifndef BodyBlocks_h
#define BodyBlocks_h

#include <cstddef>
#include <string>
#include <vector>

class vtkDataObject;
class vtkDataObjectTree;
class vtkDataSet;

namespace palpate
{
struct BodyBlock
{
  std::string name; // name of the block in the composite; the number of the block if it has no name
  std::vector<vtkDataSet*> pieces;
};

/// Returns the number of blocks with three-dimensional cells.
std::size_t countVolumes(const std::vector<BodyBlock>& blocks);

/// Joins the blocks with three-dimensional cells into one block, so that faces between them are
/// inner faces. The joined block has the same name on all ranks.
void joinVolumes(std::vector<BodyBlock>& blocks);

class BodyBlocks
{
public:
  explicit BodyBlocks(vtkDataObject* input);

  /// The blocks do not own their data sets, which must live as long as the input.
  const std::vector<BodyBlock>& blocks() const { return this->Blocks; }
  /// Reason why the input is not a body, and the name of the filter to apply first; "" if the input
  /// is a body.
  const std::string& fault() const { return this->Fault; }

private:
  void add(vtkDataObject* data, const std::string& name);
  void addTree(vtkDataObjectTree* tree, const std::string& name);

  std::vector<BodyBlock> Blocks;
  std::string Fault;
};
} // namespace palpate

#endif

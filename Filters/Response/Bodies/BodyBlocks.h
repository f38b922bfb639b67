// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * The parts of a user's body: the blocks of a composite, each a data set or the partitions of
 * one. Empty parts are skipped.
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
  std::string name; // as the composite names it, or its number
  std::vector<vtkDataSet*> pieces;
};

/// How many blocks have three-dimensional cells.
std::size_t countVolumes(const std::vector<BodyBlock>& blocks);

/// Makes one block of those with three-dimensional cells, so that faces between them are inner
/// ones. It has the same name on all ranks.
void joinVolumes(std::vector<BodyBlock>& blocks);

class BodyBlocks
{
public:
  explicit BodyBlocks(vtkDataObject* input);

  /// Not owned: they live as long as the input.
  const std::vector<BodyBlock>& blocks() const { return this->Blocks; }
  /// Why the input is not a body, and what to do; "" if it is one.
  const std::string& fault() const { return this->Fault; }

private:
  void add(vtkDataObject* data, const std::string& name);
  void addTree(vtkDataObjectTree* tree, const std::string& name);

  std::vector<BodyBlock> Blocks;
  std::string Fault;
};
} // namespace palpate

#endif

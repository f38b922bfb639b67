// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Bodies/BodyBlocks.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
/** Returns the name of the filter that converts data of another type to a body. */
std::string advice(vtkDataObject* data)
{
  struct Advice
  {
    const char* type;
    const char* text;
  };
  const Advice known[] = {
    { "vtkTable", "apply Table To Points (vtkTableToPolyData), then Delaunay 3D (vtkDelaunay3D)" },
    { "vtkUniformGridAMR",
      "apply Contour (vtkContourFilter) or Resample To Image "
      "(vtkResampleToImage) first" },
    { "vtkHyperTreeGrid",
      "apply HyperTreeGrid To UnstructuredGrid "
      "(vtkHyperTreeGridToUnstructuredGrid) first" },
    { "vtkMolecule",
      "apply Molecule To Lines (vtkMoleculeToLinesFilter), then Tube "
      "(vtkTubeFilter)" },
  };
  std::string text = std::string("a ") + data->GetClassName() + " is not a body: ";
  for (const Advice& one : known)
  {
    if (data->IsA(one.type))
    {
      return text + one.text;
    }
  }
  return text +
    "first apply a filter that makes a surface of it, such as Extract Surface "
    "(vtkDataSetSurfaceFilter)";
}

bool isVolume(vtkDataSet* data)
{
  int last = VTK_EMPTY_CELL;
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    const int type = data->GetCellType(i);
    if (type == last)
    {
      continue;
    }
    last = type;
    cell->SetCellType(type);
    if (cell->GetCellDimension() == 3)
    {
      return true;
    }
  }
  return false;
}

bool isVolumeBlock(const BodyBlock& block)
{
  return std::any_of(block.pieces.begin(), block.pieces.end(), isVolume);
}
} // namespace

std::size_t countVolumes(const std::vector<BodyBlock>& blocks)
{
  return static_cast<std::size_t>(std::count_if(blocks.begin(), blocks.end(), isVolumeBlock));
}

void joinVolumes(std::vector<BodyBlock>& blocks)
{
  BodyBlock all{ "of volumes", {} };
  for (const BodyBlock& block : blocks)
  {
    if (isVolumeBlock(block))
    {
      all.pieces.insert(all.pieces.end(), block.pieces.begin(), block.pieces.end());
    }
  }
  blocks.erase(std::remove_if(blocks.begin(), blocks.end(), isVolumeBlock), blocks.end());
  if (!all.pieces.empty())
  {
    blocks.insert(blocks.begin(), std::move(all));
  }
}

BodyBlocks::BodyBlocks(vtkDataObject* input)
{
  if (input)
  {
    this->add(input, "");
  }
}

void BodyBlocks::add(vtkDataObject* data, const std::string& name)
{
  if (auto* one = vtkDataSet::SafeDownCast(data))
  {
    if (one->GetNumberOfPoints() > 0)
    {
      this->Blocks.push_back({ name, { one } });
    }
  }
  else if (auto* tree = vtkDataObjectTree::SafeDownCast(data))
  {
    this->addTree(tree, name);
  }
  else if (this->Fault.empty())
  {
    this->Fault = (name.empty() ? "" : "block " + name + ": ") + advice(data);
  }
}

void BodyBlocks::addTree(vtkDataObjectTree* tree, const std::string& name)
{
  const bool isPartitioned =
    tree->IsA("vtkPartitionedDataSet") || tree->IsA("vtkMultiPieceDataSet");
  BodyBlock joined{ name, {} };
  vtkSmartPointer<vtkDataObjectTreeIterator> child;
  child.TakeReference(tree->NewTreeIterator());
  child->VisitOnlyLeavesOff();
  child->TraverseSubTreeOff();
  child->SkipEmptyNodesOff(); // the numbers of the blocks are then equal on all ranks
  unsigned int number = 0;
  for (child->InitTraversal(); !child->IsDoneWithTraversal(); child->GoToNextItem(), ++number)
  {
    vtkDataObject* data = child->GetCurrentDataObject();
    auto* piece = vtkDataSet::SafeDownCast(data);
    if (!data)
    {
      continue;
    }
    if (isPartitioned && piece)
    {
      if (piece->GetNumberOfPoints() > 0)
      {
        joined.pieces.push_back(piece);
      }
      continue;
    }
    std::string own = std::to_string(number);
    if (child->HasCurrentMetaData() &&
      child->GetCurrentMetaData()->Has(vtkCompositeDataSet::NAME()))
    {
      own = std::string("'") + child->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME()) + "'";
    }
    this->add(data, name.empty() ? own : name + " / " + own);
  }
  if (!joined.pieces.empty())
  {
    this->Blocks.push_back(joined);
  }
}
} // namespace palpate

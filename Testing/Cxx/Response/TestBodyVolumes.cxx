// SPDX-License-Identifier: BSD-3-Clause
// Volumes as mesh generators write them: with faces and edges as cells, in several blocks, with
// inverted or mixed cells. Also polygons that touch themselves.
#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkBodySurface.h"
#include "vtkIdList.h"
#include "vtkMassProperties.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cmath>
#include <vector>

using namespace palpate::testing;

namespace
{
constexpr int Cells = 3; // cells of 10 mm along each axis
constexpr double Volume = 27000.0;
constexpr double Rounding = 1e-9; // relative to the volume

vtkIdType pointId(int i, int j, int k)
{
  return (static_cast<vtkIdType>(k) * (Cells + 1) + j) * (Cells + 1) + i;
}

using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

Grid gridWithPoints()
{
  vtkNew<vtkPoints> points;
  for (int k = 0; k <= Cells; ++k)
  {
    for (int j = 0; j <= Cells; ++j)
    {
      for (int i = 0; i <= Cells; ++i)
      {
        points->InsertNextPoint(10.0 * i, 10.0 * j, 10.0 * k);
      }
    }
  }
  auto grid = Grid::New();
  grid->SetPoints(points);
  return grid;
}

/// Tetrahedra in the layers of cubes from `first` up to, but without, `last`.
Grid tetrahedra(int first, int last)
{
  const Grid grid = gridWithPoints();
  const std::array<std::array<int, 4>, 6> parts{ { { 0, 1, 3, 7 }, { 0, 3, 2, 7 }, { 0, 2, 6, 7 },
    { 0, 6, 4, 7 }, { 0, 4, 5, 7 }, { 0, 5, 1, 7 } } };
  for (int k = first; k < last; ++k)
  {
    for (int j = 0; j < Cells; ++j)
    {
      for (int i = 0; i < Cells; ++i)
      {
        for (const auto& part : parts)
        {
          vtkIdType corners[4];
          for (std::size_t c = 0; c < 4; ++c)
          {
            corners[c] = pointId(i + (part[c] & 1), j + (part[c] >> 1 & 1), k + (part[c] >> 2));
          }
          grid->InsertNextCell(VTK_TETRA, 4, corners);
        }
      }
    }
  }
  return grid;
}

struct Made
{
  vtkNew<vtkBodySurface> filter;
  Messages messages{ static_cast<vtkAlgorithm*>(this->filter) };

  explicit Made(vtkDataObject* input)
  {
    this->filter->SetInputDataObject(input);
    this->filter->Update();
  }
  std::string notes()
  {
    std::string all;
    for (int i = 0; i < this->filter->GetNumberOfNotes(); ++i)
    {
      all += this->filter->GetNote(i) + "; ";
    }
    return all;
  }
};

/// Checks that only the surface of the block remains: no inner wall, no duplicate face, outward
/// winding.
void checkBlock(vtkDataObject* input, const char* note = "")
{
  Made made(input);
  PALPATE_CHECK(made.messages.none());
  vtkPolyData* body = made.filter->GetOutput();
  PALPATE_CHECK(body->GetNumberOfPolys() == 6 * Cells * Cells * 2);
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(body);
  mass->Update();
  PALPATE_CHECK_NEAR(mass->GetVolumeProjected(), Volume, Rounding * Volume);
  PALPATE_CHECK_NEAR(mass->GetSurfaceArea(), 6 * 900.0, Rounding * Volume);
  PALPATE_CHECK_TEXT(made.notes(), note);
}

void checkCellsOfFewerDimensions()
{
  for (const bool turned : { false, true })
  {
    const Grid grid = tetrahedra(0, Cells);
    for (int j = 0; j < Cells; ++j)
    {
      for (int i = 0; i < Cells; ++i)
      {
        for (const int k : { 1, Cells }) // an inner wall, and the top
        {
          const vtkIdType face[4] = { pointId(i, j, k), pointId(i + 1, j, k),
            pointId(i + 1, j + 1, k), pointId(i, j + 1, k) };
          const vtkIdType back[4] = { face[3], face[2], face[1], face[0] };
          grid->InsertNextCell(VTK_QUAD, 4, turned ? back : face);
        }
      }
    }
    const vtkIdType edge[2] = { 0, 1 };
    grid->InsertNextCell(VTK_LINE, 2, edge);
    grid->InsertNextCell(VTK_VERTEX, 1, edge);
    checkBlock(grid, "20 cells of fewer than three dimensions left out");
  }
}

void checkSeveralBlocks()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, tetrahedra(0, 1));
  blocks->SetBlock(1, nullptr);
  blocks->SetBlock(2, tetrahedra(1, Cells));
  blocks->SetBlock(3, vtkNew<vtkUnstructuredGrid>());
  checkBlock(blocks);
  vtkNew<vtkPartitionedDataSet> partitions;
  partitions->SetPartition(0, tetrahedra(0, 2));
  partitions->SetPartition(1, tetrahedra(2, Cells));
  checkBlock(partitions);
}

/// Cells that occur two times have no outer face between them. Blocks with rounded points are
/// joined at these points.
void checkRepeatedCellsAndRoundedPoints()
{
  for (const int times : { 1, 6 * Cells * Cells * Cells })
  {
    const Grid grid = tetrahedra(0, Cells);
    for (int i = 0; i < times; ++i)
    {
      vtkNew<vtkIdList> corners;
      grid->GetCellPoints(i, corners);
      grid->InsertNextCell(VTK_TETRA, corners);
    }
    checkBlock(grid, "occur twice left out");
  }
  const Grid rounded = tetrahedra(1, Cells);
  vtkPoints* points = rounded->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> at{};
    points->GetPoint(i, at.data());
    points->SetPoint(i, at[0] * (1.0 + 1e-7), at[1] * (1.0 - 2e-7), at[2]);
  }
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, tetrahedra(0, 1));
  blocks->SetBlock(1, rounded);
  Made made(blocks);
  PALPATE_CHECK(made.messages.none());
  PALPATE_CHECK(made.filter->GetOutput()->GetNumberOfPolys() == 6 * Cells * Cells * 2);
}

/// Voxels that are not parallel to the axes, and a grid that is bent around an axis until its ends
/// meet up to rounding. A grid with one inverted cell is rejected.
void checkTurnedAndClosedGrids()
{
  constexpr double Pi = 3.14159265358979323846;
  const auto bent = [](double width)
  {
    constexpr int around = 24;
    auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
    grid->SetDimensions(around + 1, 2, 2);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (int k = 0; k < 2; ++k)
    {
      for (int j = 0; j < 2; ++j)
      {
        for (int i = 0; i <= around; ++i)
        {
          const double turn = 2.0 * Pi * i / around;
          const double r = 10.0 + width * j;
          points->InsertNextPoint(r * std::cos(turn), r * std::sin(turn), 10.0 * k);
        }
      }
    }
    grid->SetPoints(points);
    return grid;
  };
  Made ring(bent(5.0));
  PALPATE_CHECK(ring.messages.none());
  PALPATE_CHECK(ring.filter->GetOutput()->GetNumberOfPolys() == 24 * 4 * 2);
  const auto broken = bent(5.0);
  std::array<double, 3> at{};
  for (const vtkIdType inner : { 3, 53 }) // points of the lower and the upper layer
  {
    broken->GetPoints()->GetPoint(inner, at.data());
    // moves the inner point beyond the outer side
    broken->GetPoints()->SetPoint(inner, 3.0 * at[0], 3.0 * at[1], at[2]);
  }
  Made refused(broken);
  PALPATE_CHECK_TEXT(refused.messages.errors(), "cells are inverted, the first is cell");

  const Grid voxels = gridWithPoints();
  vtkPoints* points = voxels->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    points->GetPoint(i, at.data());
    points->SetPoint(i, std::cos(0.3) * at[0] - std::sin(0.3) * at[1],
      std::sin(0.3) * at[0] + std::cos(0.3) * at[1], at[2]);
  }
  for (int cell = 0; cell < Cells * Cells * Cells; ++cell)
  {
    vtkIdType corners[8];
    for (int c = 0; c < 8; ++c)
    {
      corners[c] = pointId(cell % Cells + (c & 1), cell / Cells % Cells + (c >> 1 & 1),
        cell / (Cells * Cells) + (c >> 2));
    }
    voxels->InsertNextCell(VTK_VOXEL, 8, corners);
  }
  Made turned(voxels);
  PALPATE_CHECK(turned.messages.none());
  PALPATE_CHECK(turned.filter->GetOutput()->GetNumberOfPolys() == 6 * Cells * Cells * 2);
}

/// A cube of a wedge and a hexahedron, with a pyramid on top: 1000/2 + 1000 + 1000/3 mm³.
void checkMixedCells()
{
  const Grid grid = gridWithPoints();
  const auto insert = [&grid](int type, const std::vector<vtkIdType>& ids)
  { grid->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data()); };
  insert(VTK_HEXAHEDRON,
    { pointId(0, 0, 0), pointId(1, 0, 0), pointId(1, 1, 0), pointId(0, 1, 0), pointId(0, 0, 1),
      pointId(1, 0, 1), pointId(1, 1, 1), pointId(0, 1, 1) });
  insert(VTK_WEDGE,
    { pointId(1, 0, 0), pointId(1, 1, 0), pointId(2, 0, 0), pointId(1, 0, 1), pointId(1, 1, 1),
      pointId(2, 0, 1) });
  insert(VTK_PYRAMID,
    { pointId(0, 0, 1), pointId(1, 0, 1), pointId(1, 1, 1), pointId(0, 1, 1), pointId(0, 0, 2) });
  Made made(grid);
  PALPATE_CHECK(made.messages.none());
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(made.filter->GetOutput());
  mass->Update();
  const double volume = 1000.0 * (1.0 + 1.0 / 2.0 + 1.0 / 3.0);
  PALPATE_CHECK_NEAR(mass->GetVolumeProjected(), volume, Rounding * volume);
}

void checkInvertedCells()
{
  const Grid all = tetrahedra(0, Cells);
  const Grid some = gridWithPoints();
  const Grid turned = gridWithPoints();
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < all->GetNumberOfCells(); ++i)
  {
    all->GetCellPoints(i, ids);
    const vtkIdType own[4] = { ids->GetId(0), ids->GetId(1), ids->GetId(2), ids->GetId(3) };
    const vtkIdType back[4] = { own[0], own[2], own[1], own[3] };
    turned->InsertNextCell(VTK_TETRA, 4, back);
    some->InsertNextCell(VTK_TETRA, 4, i == 7 || i == 40 ? back : own);
  }
  checkBlock(turned); // a left-handed mesh
  Made made(some);
  PALPATE_CHECK_TEXT(made.messages.errors(), "2 of 162 cells are inverted", "cell 7");
}

/// A square ring. Each of its two ends is one polygon with a cut from the outer to the inner
/// square.
void checkKeyhole(bool crosses)
{
  vtkNew<vtkPoints> points;
  for (const double z : { 0.0, 20.0 })
  {
    for (const double half : { 30.0, 10.0 })
    {
      points->InsertNextPoint(-half, -half, z);
      points->InsertNextPoint(half, -half, z);
      points->InsertNextPoint(half, half, z);
      points->InsertNextPoint(-half, half, z);
    }
  }
  vtkNew<vtkCellArray> polygons;
  // Counter-clockwise around the outer square, clockwise around the inner one.
  const std::vector<vtkIdType> top{ 8, 9, 10, 11, 8, 12, 15, 14, 13, 12 };
  std::vector<vtkIdType> bottom{ 4, 5, 6, 7, 4, 0, 3, 2, 1, 0 };
  if (crosses)
  {
    std::swap(bottom[1], bottom[7]);
  }
  polygons->InsertNextCell(10, top.data());
  polygons->InsertNextCell(10, bottom.data());
  for (vtkIdType k = 0; k < 4; ++k)
  {
    const vtkIdType next = (k + 1) % 4;
    polygons->InsertNextCell({ k, next, next + 8, k + 8 });
    polygons->InsertNextCell({ next + 4, k + 4, k + 12, next + 12 });
  }
  vtkNew<vtkPolyData> ring;
  ring->SetPoints(points);
  ring->SetPolys(polygons);
  Made made(ring);
  if (crosses)
  {
    PALPATE_CHECK_TEXT(made.messages.errors(), "polygon 1 of 10 corners");
    return;
  }
  PALPATE_CHECK(made.messages.none());
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(made.filter->GetOutput());
  mass->Update();
  const double volume = (3600.0 - 400.0) * 20.0;
  PALPATE_CHECK_NEAR(mass->GetVolumeProjected(), volume, Rounding * volume);
}

/// Repeated corners have no effect. Polygons with crossing sides are rejected, also quadrilaterals.
void checkPolygons()
{
  const auto bodyOf = [](std::initializer_list<vtkIdType> first)
  {
    const Body box = boxBody(10.0, 10.0, 10.0, 1);
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkIdList> ids;
    cells->InsertNextCell(first);
    for (vtkIdType i = 2; i < box->GetNumberOfPolys(); ++i)
    {
      box->GetPolys()->GetCellAtId(i, ids);
      cells->InsertNextCell(ids);
    }
    box->SetPolys(cells);
    return box;
  };
  const Body box = boxBody(10.0, 10.0, 10.0, 1);
  vtkNew<vtkIdList> one;
  vtkNew<vtkIdList> other;
  box->GetPolys()->GetCellAtId(0, one);
  box->GetPolys()->GetCellAtId(1, other);
  const vtkIdType a = one->GetId(0);
  const vtkIdType b = one->GetId(1);
  const vtkIdType c = one->GetId(2);
  const vtkIdType d = other->GetId(2); // the square a, b, c, d
  Made repeated(bodyOf({ a, a, b, b, c, d, d }));
  PALPATE_CHECK(repeated.messages.none());
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(repeated.filter->GetOutput());
  mass->Update();
  PALPATE_CHECK_NEAR(mass->GetVolumeProjected(), 8000.0, 8000.0 * Rounding);
  Made crossed(bodyOf({ a, b, d, c }));
  PALPATE_CHECK_TEXT(crossed.messages.errors(), "polygon 0 of 4 corners");
}
} // namespace

int TestBodyVolumes(int, char*[])
{
  checkBlock(tetrahedra(0, Cells), "surface extracted from 162 cells");
  checkCellsOfFewerDimensions();
  checkSeveralBlocks();
  checkRepeatedCellsAndRoundedPoints();
  checkTurnedAndClosedGrids();
  checkMixedCells();
  checkInvertedCells();
  checkPolygons();
  checkKeyhole(false);
  checkKeyhole(true);
  return result();
}

// SPDX-License-Identifier: BSD-3-Clause
// Any input is converted to a body of triangles in mm, or causes an error message with a remedy.
#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkAppendFilter.h"
#include "vtkBodySurface.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkReverseSense.h"
#include "vtkStripper.h"
#include "vtkStructuredGrid.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <limits>

using namespace palpate::testing;

namespace
{
constexpr int Cells = 3;       // cells of the block along each axis
constexpr double Side = 30.0;  // mm
constexpr double Exact = 1e-9; // rounding of coordinates of at most 100 mm, relative

struct Made
{
  vtkNew<vtkBodySurface> filter;
  Messages messages{ static_cast<vtkAlgorithm*>(this->filter) };
  vtkPolyData* body = nullptr;
};

void make(Made& made, vtkDataObject* input)
{
  made.filter->SetInputDataObject(input);
  made.filter->Update();
  made.body = made.filter->GetOutput();
}

bool isSilent(const Made& made)
{
  return made.messages.none();
}

/**
 * Checks that all cells are triangles. Returns their enclosed volume, positive for the correct
 * winding.
 */
double enclosedVolume(vtkPolyData* body)
{
  PALPATE_CHECK(body->GetNumberOfCells() == body->GetNumberOfPolys());
  double sum = 0.0;
  for (vtkIdType i = 0; i < body->GetNumberOfCells(); ++i)
  {
    vtkCell* cell = body->GetCell(i);
    PALPATE_CHECK(cell->GetNumberOfPoints() == 3);
    std::array<std::array<double, 3>, 3> p;
    for (int k = 0; k < 3; ++k)
    {
      cell->GetPoints()->GetPoint(k, p[static_cast<std::size_t>(k)].data());
    }
    double normal[3];
    vtkMath::Cross(p[1].data(), p[2].data(), normal);
    sum += vtkMath::Dot(p[0].data(), normal) / 6.0;
  }
  return sum;
}

/** A cube with the side Side and Cells³ voxels, one corner at the origin, with a point array. */
vtkSmartPointer<vtkImageData> imageBlock(int first = 0, int last = Cells)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(first, last, 0, Cells, 0, Cells);
  image->SetSpacing(Side / Cells, Side / Cells, Side / Cells);
  vtkNew<vtkDoubleArray> height;
  height->SetName("Height");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    height->InsertNextValue(image->GetPoint(i)[2]);
  }
  image->GetPointData()->AddArray(height);
  return image;
}

vtkSmartPointer<vtkRectilinearGrid> rectilinearBlock()
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetDimensions(Cells + 1, Cells + 1, Cells + 1);
  vtkNew<vtkDoubleArray> ticks;
  for (int i = 0; i <= Cells; ++i)
  {
    ticks->InsertNextValue(Side * i / Cells);
  }
  grid->SetXCoordinates(ticks);
  grid->SetYCoordinates(ticks);
  grid->SetZCoordinates(ticks);
  grid->GetPointData()->ShallowCopy(imageBlock()->GetPointData());
  return grid;
}

vtkSmartPointer<vtkStructuredGrid> structuredBlock(double handedness)
{
  auto image = imageBlock();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* x = image->GetPoint(i);
    points->InsertNextPoint(handedness * x[0], x[1], x[2]);
  }
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(Cells + 1, Cells + 1, Cells + 1);
  grid->SetPoints(points);
  grid->GetPointData()->ShallowCopy(image->GetPointData());
  return grid;
}

vtkSmartPointer<vtkUnstructuredGrid> unstructuredBlock()
{
  vtkNew<vtkAppendFilter> cells;
  cells->AddInputData(imageBlock());
  cells->Update();
  return cells->GetOutput();
}

/**
 * Checks that the input becomes one closed surface of a cube, without duplicate points or inner
 * walls, and with the array at its points.
 */
void checkBlock(vtkDataObject* input)
{
  Made made;
  make(made, input);
  PALPATE_CHECK(isSilent(made));
  const int inner = (Cells - 1) * (Cells - 1) * (Cells - 1);
  const int all = (Cells + 1) * (Cells + 1) * (Cells + 1);
  PALPATE_CHECK(made.body->GetNumberOfPoints() == all - inner);
  PALPATE_CHECK(made.body->GetNumberOfPolys() == 2 * 6 * Cells * Cells);
  PALPATE_CHECK_NEAR(enclosedVolume(made.body), Side * Side * Side, Exact * Side * Side * Side);
  vtkDataArray* height = made.body->GetPointData()->GetArray("Height");
  PALPATE_CHECK(height != nullptr);
  for (vtkIdType i = 0; height && i < made.body->GetNumberOfPoints(); ++i)
  {
    PALPATE_CHECK_NEAR(height->GetTuple1(i), made.body->GetPoint(i)[2], Exact);
  }
}

void checkVolumes()
{
  checkBlock(imageBlock());
  checkBlock(rectilinearBlock());
  checkBlock(structuredBlock(1.0));
  // left-handed: its cells are inverted, and the surface must be turned outward
  checkBlock(structuredBlock(-1.0));
  checkBlock(unstructuredBlock());

  // Two halves of a block are joined, also if one contains a layer of the other as ghost cells.
  for (const int ghosts : { 0, 1 })
  {
    auto left = imageBlock(0, 1 + ghosts);
    auto right = imageBlock(1, Cells);
    left->AllocateCellGhostArray();
    right->AllocateCellGhostArray();
    for (vtkIdType i = 0; ghosts == 1 && i < left->GetNumberOfCells(); ++i)
    {
      const double x = left->GetCell(i)->GetBounds()[0];
      left->GetCellGhostArray()->SetValue(
        i, x > Side / Cells / 2 ? vtkDataSetAttributes::DUPLICATECELL : 0);
    }
    vtkNew<vtkPartitionedDataSet> halves;
    halves->SetPartition(0, left);
    halves->SetPartition(1, right);
    checkBlock(halves);
  }
}

void checkSurfaces()
{
  // An input of triangles only keeps its cells, points and arrays, without a message.
  const Body ball = sphereBody(30.0, 2);
  addRadialNormals(ball);
  Made same;
  make(same, ball);
  PALPATE_CHECK(isSilent(same));
  PALPATE_CHECK(same.body->GetPoints() == ball->GetPoints());
  PALPATE_CHECK(same.body->GetPolys() == ball->GetPolys());
  PALPATE_CHECK(same.body->GetPointData()->GetNormals() == ball->GetPointData()->GetNormals());
  PALPATE_CHECK(same.filter->GetNumberOfNotes() == 0);
  const double volume = enclosedVolume(ball);
  PALPATE_CHECK(volume > 0.0);

  // The same ball in strips, with an additional vertex and line.
  vtkNew<vtkStripper> strips;
  strips->SetInputData(ball);
  strips->Update();
  vtkNew<vtkPolyData> mixed;
  mixed->ShallowCopy(strips->GetOutput());
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 0 });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  mixed->SetVerts(verts);
  mixed->SetLines(lines);
  PALPATE_CHECK(mixed->GetNumberOfStrips() > 0);
  Made cut;
  make(cut, mixed);
  PALPATE_CHECK(isSilent(cut));
  PALPATE_CHECK(cut.body->GetNumberOfPolys() == ball->GetNumberOfPolys());
  PALPATE_CHECK_NEAR(enclosedVolume(cut.body), volume, Exact * volume);
  PALPATE_CHECK(cut.filter->GetNumberOfNotes() == 2);
  PALPATE_CHECK_TEXT(cut.filter->GetNote(0), "strips cut into 320 triangles");
  PALPATE_CHECK_TEXT(cut.filter->GetNote(1), "2 vertices and lines left out");

  // A surface with inward winding is reversed.
  const Body bare = sphereBody(30.0, 2);
  vtkNew<vtkReverseSense> reverse;
  reverse->SetInputData(bare);
  reverse->Update();
  Made turned;
  make(turned, reverse->GetOutput());
  PALPATE_CHECK_NEAR(enclosedVolume(turned.body), volume, Exact * volume);
  PALPATE_CHECK_TEXT(turned.filter->GetNote(0), "320 triangles wound inward");
  PALPATE_CHECK_NEAR(
    enclosedVolume(reverse->GetOutput()), -volume, Exact * volume); // the input is unchanged
}

/** Triangles that enclose no volume are left out. The two sides of a sheet are an error. */
void checkFlaps()
{
  const Body ball = sphereBody(30.0, 2);
  const vtkIdType own = ball->GetNumberOfPolys();
  vtkNew<vtkPolyData> merged;
  merged->DeepCopy(ball);
  const auto add = [&merged](vtkIdType a, vtkIdType b, vtkIdType c) {
    merged->GetPolys()->InsertNextCell({ a, b, c });
  };
  vtkNew<vtkIdList> once;
  ball->GetCellPoints(0, once);
  add(once->GetId(1), once->GetId(2), once->GetId(0)); // the triangle occurs twice
  vtkNew<vtkIdList> both;
  ball->GetCellPoints(5, both);
  add(both->GetId(2), both->GetId(0), both->GetId(1)); // a copy and a reversed copy
  add(both->GetId(1), both->GetId(0), both->GetId(2));
  add(once->GetId(0), once->GetId(1), both->GetId(0)); // two sides of a flap across the ball
  add(once->GetId(1), once->GetId(0), both->GetId(0));
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("Number");
  for (vtkIdType i = 0; i < merged->GetPolys()->GetNumberOfCells(); ++i)
  {
    numbers->InsertNextValue(static_cast<double>(i));
  }
  merged->GetCellData()->AddArray(numbers);
  Made made;
  make(made, merged);
  PALPATE_CHECK(isSilent(made));
  PALPATE_CHECK(made.body->GetNumberOfPolys() == own);
  PALPATE_CHECK(made.body->GetNumberOfPoints() == ball->GetNumberOfPoints());
  PALPATE_CHECK_NEAR(enclosedVolume(made.body), enclosedVolume(ball), Exact * enclosedVolume(ball));
  vtkDataArray* kept = made.body->GetCellData()->GetArray("Number");
  PALPATE_CHECK(kept && kept->GetNumberOfTuples() == own);
  PALPATE_CHECK(
    // the first one of equal triangles is kept
    kept && kept->GetRange()[1] == static_cast<double>(own - 1));
  PALPATE_CHECK(made.filter->GetNumberOfNotes() == 1);
  PALPATE_CHECK_TEXT(made.filter->GetNote(0), "5 triangles that occur twice");
  PALPATE_CHECK(merged->GetPolys()->GetNumberOfCells() == own + 5); // the input is unchanged

  vtkNew<vtkPolyData> sheet;
  sheet->DeepCopy(ball);
  for (vtkIdType i = 0; i < own; ++i)
  {
    ball->GetCellPoints(i, once);
    sheet->GetPolys()->InsertNextCell({ once->GetId(1), once->GetId(0), once->GetId(2) });
  }
  Made sides;
  make(sides, sheet);
  PALPATE_CHECK_TEXT(sides.messages.errors(), "occur with their reverse", "keep one side");
  PALPATE_CHECK(sides.body->GetNumberOfPolys() == 0);
}

/** A ball in two partitions, each with separate points at the seam, and in two blocks. */
void checkComposites()
{
  const Body ball = sphereBody(30.0, 2);
  std::array<vtkNew<vtkPolyData>, 2> halves;
  for (std::size_t half = 0; half < 2; ++half)
  {
    vtkNew<vtkCellArray> cells;
    for (vtkIdType i = 0; i < ball->GetNumberOfCells(); ++i)
    {
      double center[3] = { 0.0, 0.0, 0.0 };
      vtkCell* cell = ball->GetCell(i);
      for (int k = 0; k < 3; ++k)
      {
        double p[3];
        cell->GetPoints()->GetPoint(k, p);
        vtkMath::Add(center, p, center);
      }
      if ((center[2] > 0.0) == (half == 1))
      {
        cells->InsertNextCell(cell);
      }
    }
    halves[half]->SetPoints(ball->GetPoints());
    halves[half]->SetPolys(cells);
    vtkNew<vtkDoubleArray> shared;
    shared->SetName("Shared");
    shared->SetNumberOfTuples(ball->GetNumberOfPoints());
    shared->Fill(static_cast<double>(half));
    halves[half]->GetPointData()->AddArray(shared);
  }
  const double volume = enclosedVolume(ball);

  vtkNew<vtkPartitionedDataSet> partitions;
  partitions->SetPartition(0, halves[0]);
  partitions->SetPartition(1, halves[1]);
  Made joined;
  make(joined, partitions);
  PALPATE_CHECK(isSilent(joined));
  PALPATE_CHECK(joined.body->GetNumberOfPoints() == ball->GetNumberOfPoints());
  PALPATE_CHECK_NEAR(enclosedVolume(joined.body), volume, Exact * volume);
  PALPATE_CHECK(joined.body->GetPointData()->HasArray("Shared"));
  PALPATE_CHECK_TEXT(joined.filter->GetNote(0), "2 partitions joined");

  // Blocks stay separate and keep their order. Empty blocks and blocks of lines have no effect.
  // Only the block with inward winding is reversed. An array that is missing in one block is left
  // out with a message.
  const Body second = sphereBody(20.0, 1);
  vtkNew<vtkReverseSense> reverse;
  reverse->SetInputData(second);
  reverse->Update();
  vtkNew<vtkDoubleArray> own;
  own->SetName("Own");
  own->SetNumberOfTuples(second->GetNumberOfPoints());
  own->Fill(0.0);
  reverse->GetOutput()->GetPointData()->AddArray(own);
  vtkNew<vtkPolyData> line;
  line->SetPoints(ball->GetPoints());
  vtkNew<vtkCellArray> segment;
  segment->InsertNextCell({ 0, 1 });
  line->SetLines(segment);
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, reverse->GetOutput());
  vtkNew<vtkPolyData> nothing;
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, nothing);
  blocks->SetBlock(1, ball);
  blocks->SetBlock(2, line);
  blocks->SetBlock(3, inner);
  Made appended;
  make(appended, blocks);
  PALPATE_CHECK(appended.messages.errors().empty());
  PALPATE_CHECK_TEXT(appended.messages.warnings(), "left out: Own");
  PALPATE_CHECK(appended.body->GetNumberOfPolys() == 320 + 80);
  PALPATE_CHECK(
    appended.body->GetNumberOfPoints() == ball->GetNumberOfPoints() + second->GetNumberOfPoints());
  PALPATE_CHECK_NEAR(
    enclosedVolume(appended.body), volume + enclosedVolume(second), Exact * volume);
  double first[3];
  double expected[3];
  appended.body->GetPoint(0, first);
  ball->GetPoint(0, expected);
  PALPATE_CHECK_NEAR(std::sqrt(vtkMath::Distance2BetweenPoints(first, expected)), 0.0, Exact);
}

void checkUnits()
{
  vtkNew<vtkBodySurface> defaults;
  PALPATE_CHECK(defaults->GetLengthUnit() == vtkBodySurface::Millimetre);
  defaults->SetLengthScale(25.4);
  PALPATE_CHECK(defaults->GetLengthUnit() == -1);
  const double scales[3] = { 1.0, 10.0, 1000.0 };
  for (int unit = 0; unit < 3; ++unit)
  {
    const Body ball = sphereBody(30.0 / scales[unit], 2);
    Made made;
    made.filter->SetLengthUnit(unit);
    PALPATE_CHECK(made.filter->GetLengthUnit() == unit);
    make(made, ball);
    PALPATE_CHECK(isSilent(made));
    double p[3];
    made.body->GetPoint(7, p);
    PALPATE_CHECK_NEAR(vtkMath::Norm(p), 30.0, Exact);
  }
  struct Size
  {
    double side; // side of a cube, mm
    bool asked;
  };
  for (const Size& size :
    { Size{ 4.99, true }, Size{ 5.01, false }, Size{ 4990.0, false }, Size{ 5010.0, true } })
  {
    auto image = imageBlock();
    image->SetSpacing(size.side / Cells, size.side / Cells, size.side / Cells);
    Made made;
    make(made, image);
    PALPATE_CHECK(made.messages.none() != size.asked);
    PALPATE_CHECK_NEAR(made.filter->GetLongestSide(), size.side, Exact * size.side);
    if (size.asked)
    {
      PALPATE_CHECK_TEXT(
        made.messages.warnings(), "longest side", "mm", "is the Length Unit right?");
    }
    Made quiet;
    quiet.filter->AskAboutSizeOff();
    make(quiet, image);
    PALPATE_CHECK(isSilent(quiet));
  }
}

template <class... Words>
void checkError(vtkDataObject* input, const Words&... words)
{
  Made made;
  make(made, input);
  PALPATE_CHECK_TEXT(made.messages.errors(), words...);
  PALPATE_CHECK(made.body->GetNumberOfPoints() == 0 && made.body->GetNumberOfCells() == 0);
}

void checkErrors()
{
  vtkNew<vtkPolyData> nothing;
  Made empty;
  make(empty, nothing);
  PALPATE_CHECK(isSilent(empty) && empty.body->GetNumberOfPoints() == 0);

  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(sphereBody(30.0, 1)->GetPoints());
  checkError(cloud, "no triangles", "only 42 points", "Delaunay 3D");
  vtkNew<vtkPolyData> line;
  line->SetPoints(cloud->GetPoints());
  vtkNew<vtkCellArray> segment;
  segment->InsertNextCell({ 0, 1 });
  line->SetLines(segment);
  checkError(line, "no triangles", "lines", "Tube");
  vtkNew<vtkTable> table;
  checkError(table, "vtkTable", "Table To Points");
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, sphereBody(30.0, 1));
  blocks->SetBlock(1, table);
  checkError(blocks, "block 1", "vtkTable");

  const Body hole = sphereBody(30.0, 1);
  hole->GetPoints()->SetPoint(7, 0.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  hole->GetPoints()->SetPoint(9, std::numeric_limits<double>::infinity(), 0.0, 0.0);
  Made holed;
  make(holed, hole); // a hole around the two points
  PALPATE_CHECK(holed.messages.errors().empty() && holed.filter->GetNumberOfNotes() == 0);
  PALPATE_CHECK_TEXT(
    holed.messages.warnings(), "triangles with a coordinate that is not finite", "left out");
  PALPATE_CHECK(holed.body->GetNumberOfPoints() == 40 && holed.body->GetNumberOfPolys() < 80);
  PALPATE_CHECK(holed.filter->GetLongestSide() < 61.0);
  const Body damaged = sphereBody(30.0, 1);
  vtkNew<vtkCellArray> lost;
  lost->InsertNextCell({ 0, 1, 999 });
  damaged->SetPolys(lost);
  checkError(damaged, "damaged", "point 999", "42 points");

  Made scale;
  scale.filter->SetLengthScale(0.0);
  make(scale, sphereBody(30.0, 1));
  PALPATE_CHECK_TEXT(
    scale.messages.errors(), "LengthScale must be positive and finite (mm), but is 0");
}
} // namespace

int TestBodySurface(int, char*[])
{
  checkSurfaces();
  checkFlaps();
  checkVolumes();
  checkComposites();
  checkUnits();
  checkErrors();
  return result();
}

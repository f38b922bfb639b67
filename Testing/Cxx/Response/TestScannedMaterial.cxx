// SPDX-License-Identifier: BSD-3-Clause
// vtkScannedMaterial: labels and scales, mixed cells, points outside the image, faults.
#include "FilterChecks.h"
#include "VolumeBlock.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkScannedMaterial.h"

#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>

namespace
{
using namespace palpate::testing;
using Material = vtkSmartPointer<vtkScannedMaterial>;

constexpr int Side = 6;
constexpr int Height = 6;

/// An image over the block with cubic voxels of `size` mm. The first voxel is at `from` on all
/// axes. Values are a function of the position.
vtkSmartPointer<vtkImageData> scan(
  double size, double from, int count, const std::function<double(double, double, double)>& value)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(count, count, count);
  image->SetOrigin(from, from, from);
  image->SetSpacing(size, size, size);
  image->AllocateScalars(VTK_DOUBLE, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> x{};
    image->GetPoint(i, x.data());
    image->GetPointData()->GetScalars()->SetTuple1(i, value(x[0], x[1], x[2]));
  }
  return image;
}

Material mapped(vtkUnstructuredGrid* grid, vtkImageData* image)
{
  auto filter = Material::New();
  filter->SetInputData(grid);
  filter->SetImageData(image);
  filter->SetYoungsModulus(0.7);
  filter->SetPoissonRatio(0.2);
  return filter;
}

double valueOf(vtkScannedMaterial* filter, const char* name, int i, int j, int k)
{
  return filter->GetOutput()->GetCellData()->GetArray(name)->GetTuple1(
    (static_cast<vtkIdType>(k) * Side + j) * Side + i);
}

/// Skin of 1.75 mm on fat, with voxels of half a millimetre. The second image ends at x = 5 mm.
void checkLabels()
{
  const auto image =
    scan(0.5, 0.25, 12, [](double, double, double z) { return z > Height - 1.75 ? 2.0 : 1.0; });
  for (const int kind : { VTK_HEXAHEDRON, VTK_VOXEL })
  {
    const Grid grid = block(Side, Height, kind);
    const Material filter = mapped(grid, image);
    filter->AddMaterial(1.0, 0.01, 0.49);
    filter->AddMaterial(2.0, 0.1, 0.45);
    Messages messages(filter.Get());
    filter->Update();
    PALPATE_CHECK(messages.none());
    PALPATE_CHECK(valueOf(filter, "YoungsModulus", 2, 2, 0) == 0.01);
    PALPATE_CHECK(valueOf(filter, "PoissonRatio", 2, 2, 0) == 0.49);
    PALPATE_CHECK(valueOf(filter, "YoungsModulus", 2, 2, Height - 1) == 0.1);
    // The upper half of the second cell is skin. Its two middle voxels of 0.5 mm are at 4.25 mm
    // (fat) and 4.75 mm (skin). Both materials are equally frequent, so the smaller label counts as
    // the most frequent material.
    PALPATE_CHECK_NEAR(valueOf(filter, "YoungsModulus", 2, 2, Height - 2),
      1.0 / (0.5 / 0.01 + 0.5 / 0.1), 1e-12); // harmonic mean, because skin is harder
    PALPATE_CHECK_NEAR(valueOf(filter, "PoissonRatio", 2, 2, Height - 2), 0.47, 1e-12);
    // Only the arrays of the filter are changed.
    PALPATE_CHECK(filter->GetOutput()->GetPointData()->GetArray("Fixed") != nullptr);
  }
  const auto narrow =
    scan(0.5, 0.25, 10, [](double, double, double) { return 1.0; }); // the image ends at 5 mm
  const Material filter = mapped(block(Side, Height), narrow);
  filter->AddMaterial(1.0, 0.01, 0.49);
  filter->Update();
  PALPATE_CHECK(valueOf(filter, "YoungsModulus", 4, 4, 4) == 0.01);
  PALPATE_CHECK(valueOf(filter, "YoungsModulus", 5, 2, 2) == 0.7);
  PALPATE_CHECK(valueOf(filter, "PoissonRatio", 2, 5, 2) == 0.2);
}

/// E from a scale: logarithmic between two rows of the map, constant beyond them.
void checkScale()
{
  const auto image = scan(0.5, -1.0, 20, [](double x, double, double) { return 100.0 * x; });
  const Material filter = mapped(block(Side, Height), image);
  filter->LabelsOff();
  filter->AddMaterial(400.0, 0.2, 0.4);
  filter->AddMaterial(100.0, 0.05, 0.49);
  filter->Update();
  PALPATE_CHECK_NEAR(valueOf(filter, "YoungsModulus", 0, 3, 3), 0.05, 1e-15);
  // The middle of the third cell has the value 250, half-way between two rows. The image is linear,
  // so 250 is also its mean over the cell.
  PALPATE_CHECK_NEAR(valueOf(filter, "YoungsModulus", 2, 3, 3), 0.1, 1e-12);
  PALPATE_CHECK_NEAR(valueOf(filter, "PoissonRatio", 2, 3, 3), 0.445, 1e-12);
  PALPATE_CHECK_NEAR(valueOf(filter, "YoungsModulus", 5, 3, 3), 0.2, 1e-15);
}

void checkErrors()
{
  const auto image =
    scan(1.0, 0.0, 8, [](double, double, double z) { return z > 4.5 ? 3.0 : 1.0; });
  const auto fails =
    [&](auto&& change, std::initializer_list<const char*> words, vtkImageData* given = nullptr)
  {
    const Material filter = mapped(block(Side, Height), given ? given : image.Get());
    filter->AddMaterial(1.0, 0.01, 0.49);
    filter->AddMaterial(3.0, 0.02, 0.49);
    Messages messages(filter.Get());
    change(filter.Get());
    filter->Update();
    checkText(messages.errors(), words, __FILE__, __LINE__);
    PALPATE_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
  };
  fails([](auto* f) { f->ClearMaterials(); }, { "Materials are required", "AddMaterial" });
  fails([](auto* f) { f->AddMaterial(1.0, 0.3, 0.4); }, { "Materials 0 and 2", "1" });
  fails([](auto* f) { f->AddMaterial(7.0, -0.3, 0.4); }, { "Material 2", "Young", "-0.3" });
  fails([](auto* f) { f->AddMaterial(7.0, 0.3, 0.5); }, { "Material 2", "Poisson", "0.5" });
  fails([](auto* f) { f->AddMaterial(std::nan(""), 0.3, 0.4); }, { "Material 2", "nan" });
  fails([](auto* f) { f->SetSubdivisions(0); }, { "Subdivisions", "0" });
  fails([](auto* f) { f->SetYoungsModulus(0.0); }, { "Young's Modulus", "0" });
  fails(
    [](auto* f)
    {
      f->ClearMaterials();
      f->AddMaterial(1.0, 0.01, 0.49);
    },
    { "cell 144", "label 3", "AddMaterial" });
  fails([](auto* f) { f->SetInputArrayToProcess(0, 1, 0, 0, "CT"); }, { "image", "array" });
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(3, 3, 3);
  fails([](auto*) {}, { "image", "array" }, bare);
  const auto holed = scan(1.0, 0.0, 8, [](double x, double, double) { return std::sqrt(2.5 - x); });
  fails([](auto* f) { f->LabelsOff(); }, { "cell", "nan" }, holed);

  const Material empty = mapped(Grid::New(), image);
  Messages messages(empty.Get());
  empty->Update();
  PALPATE_CHECK(messages.none() && empty->GetOutput()->GetNumberOfPoints() == 0);
}
} // namespace

int TestScannedMaterial(int, char*[])
{
  checkLabels();
  checkScale();
  checkErrors();
  return palpate::testing::result();
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Bodies/HeldPlaces.h"

#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"

#include <array>
#include <utility>

namespace palpate
{
namespace
{
constexpr double LeastShare = 1e-6; ///< of a corner, by rounding
}

HeldPlaces::HeldPlaces(vtkPolyData* surface, std::function<bool(vtkIdType)> isHeld)
  : Surface(surface)
  , Locator(vtkSmartPointer<vtkStaticCellLocator>::New())
  , IsHeld(std::move(isHeld))
{
  this->Locator->SetDataSet(surface);
  this->Locator->BuildLocator();
}

bool HeldPlaces::contain(const double place[3]) const
{
  const std::array<double, 3> from = { place[0], place[1], place[2] };
  std::array<double, 3> at{};
  vtkNew<vtkGenericCell> cell;
  vtkIdType id = -1;
  int part = 0;
  double square = 0.0;
  this->Locator->FindClosestPoint(from.data(), at.data(), cell, id, part, square);
  if (id < 0)
  {
    return false;
  }
  this->Surface->GetCell(id, cell);
  std::array<double, 3> within{};
  std::array<double, 3> shares{};
  cell->EvaluatePosition(at.data(), nullptr, part, within.data(), square, shares.data());
  for (int corner = 0; corner < 3; ++corner)
  {
    if (shares[static_cast<std::size_t>(corner)] > LeastShare &&
      !this->IsHeld(cell->GetPointId(corner)))
    {
      return false;
    }
  }
  return true;
}
} // namespace palpate

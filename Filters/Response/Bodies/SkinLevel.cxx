// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Bodies/SkinLevel.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <set>

namespace palpate
{
namespace
{
constexpr double LevelOfRange = 0.12;

bool areLabels(vtkDataArray* values)
{
  const int type = values->GetDataType();
  if (type == VTK_FLOAT || type == VTK_DOUBLE)
  {
    return false;
  }
  std::set<double> found;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    found.insert(values->GetComponent(i, 0));
    if (found.size() > MostLabels)
    {
      return false;
    }
  }
  return true;
}
} // namespace

void SkinLevel::mark(std::vector<float>& values) const
{
  if (this->isLabelled)
  {
    std::transform(values.begin(), values.end(), values.begin(),
      [this](float label) { return label > this->outside ? 1.0f : 0.0f; });
  }
}

SkinLevel skinLevel(vtkDataArray* values, double wanted, double least, double most)
{
  SkinLevel level;
  level.outside = static_cast<float>(least);
  level.isLabelled = wanted == 0.0 && areLabels(values);
  if (level.isLabelled)
  {
    level.given = 0.5 * (least + most);
    level.contour = 0.5f;
    level.tissue = 1.0f;
    return level;
  }
  level.given = wanted == 0.0 ? least + LevelOfRange * (most - least) : wanted;
  level.contour = static_cast<float>(level.given);
  level.tissue = 2.0f * level.contour - level.outside;
  return level;
}
} // namespace palpate

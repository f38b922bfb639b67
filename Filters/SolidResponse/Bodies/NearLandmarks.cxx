// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/NearLandmarks.h"

#include "Solids/TrueShape/LandmarkKernels.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cstdint>

namespace palpate
{
NearLandmarks::NearLandmarks(vtkPolyData* solid, const LandmarkKernels& landmarks)
  : Landmarks(landmarks)
  , OnSolid(solid,
      [&landmarks](vtkIdType id)
      {
        const std::vector<std::int32_t>& all = landmarks.points();
        return std::binary_search(all.begin(), all.end(), static_cast<std::int32_t>(id));
      })
  , Held(solid,
      [&landmarks](vtkIdType id)
      {
        const SurfaceDisc* disc = landmarks.green().disc(static_cast<std::int32_t>(id));
        return disc != nullptr && disc->status == PatchStatus::OutOfReach;
      })
{
}

std::vector<std::size_t> NearLandmarks::around(const double place[3], const Vector3& normal) const
{
  std::vector<std::size_t> found;
  if (this->Held.contain(place))
  {
    return found;
  }
  const std::vector<std::int32_t>& all = this->Landmarks.points();
  for (const auto& part : this->OnSolid.nearBy(place, normal))
  {
    const auto at = std::lower_bound(all.begin(), all.end(), static_cast<std::int32_t>(part.first));
    found.push_back(static_cast<std::size_t>(at - all.begin()));
  }
  return found;
}
} // namespace palpate

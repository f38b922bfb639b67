// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/SurfaceCurvature.h"

namespace palpate
{
SurfaceCurvature::SurfaceCurvature(
  const TriangleSpans& surface, const float* normals, double contactRadius)
  : SurfaceCurvature(SurfaceForms(surface, normals), contactRadius)
{
}

SurfaceCurvature::SurfaceCurvature(const SurfaceForms& forms, double contactRadius)
  : Found(forms.curvatures(contactRadius))
{
}
} // namespace palpate

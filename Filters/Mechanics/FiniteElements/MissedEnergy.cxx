// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/FiniteElements/MissedEnergy.h"

#include "Mechanics/FiniteElements/ElasticElement.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
MissedEnergy::MissedEnergy(const VolumeMesh& mesh)
  : Middles(3, mesh.elementTotal())
  , Weights(mesh.elements.size(), 0.0)
{
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
  {
    const VolumeElement& element = mesh.elements[e];
    this->Middles.col(static_cast<Eigen::Index>(e)) = elementMiddle(mesh, element);
    if (element.kind != ElementKind::QuadraticTetrahedron)
    {
      const double volume = leastVolume(element.kind, elementNodes(mesh, element));
      this->Weights[e] = volume * std::pow(volume, 2.0 / 3.0);
    }
  }
}

double MissedEnergy::of(const Eigen::Vector3d& point, std::size_t element) const
{
  const double square =
    (this->Middles.col(static_cast<Eigen::Index>(element)) - point).squaredNorm();
  return this->Weights[element] / (square * square * square);
}

double MissedEnergy::fraction(const Eigen::Vector3d& point, const LocalPatch& patch) const
{
  double inner = 0.0;
  double outer = 0.0;
  for (std::size_t i = 0; i < patch.elements.size(); ++i)
  {
    const double energy = this->of(point, static_cast<std::size_t>(patch.elements[i]));
    outer += energy;
    inner += patch.inner[i] ? energy : 0.0;
  }
  double all = 0.0;
  for (std::size_t e = 0; e < this->Weights.size(); ++e)
  {
    all += this->of(point, e);
  }
  const double between = outer - inner;
  return between > 1e-9 * outer ? std::max(all - outer, 0.0) / between : 0.0;
}
} // namespace palpate

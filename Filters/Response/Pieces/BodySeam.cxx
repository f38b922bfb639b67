// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Pieces/BodySeam.h"

#include "Response/Pieces/LoadedPieces.h"

namespace palpate
{
BodySeam::BodySeam(const Ranks& ranks, vtkPolyData* body)
  : Among(ranks)
{
  if (ranks.areAlone())
  {
    this->Found.seams.resize(1);
  }
  else
  {
    this->Found = loadedPieces().module->findSeam(ranks, body);
  }
}
} // namespace palpate

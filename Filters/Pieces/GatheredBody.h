// SPDX-License-Identifier: BSD-3-Clause
#ifndef GatheredBody_h
#define GatheredBody_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkPolyData;

namespace palpate
{
/**
 * One body with the response `name`, joined from the parts that BodyPiece::cut returned on several
 * ranks. The points of a seam are merged. The rank and the cell of each triangle are stored.
 */
class GatheredBody
{
public:
  /// The rank and the cell from which a triangle comes.
  struct Origin
  {
    int rank;
    vtkIdType cell; ///< cell of the piece on `rank`
  };

  /// `parts` contains at most one part for each rank.
  GatheredBody(const std::vector<vtkSmartPointer<vtkPolyData>>& parts, const std::string& name);

  vtkPolyData* body() const { return this->Body; }
  const Origin& origin(std::size_t triangle) const { return this->Origins[triangle]; }

private:
  vtkSmartPointer<vtkPolyData> Body;
  std::vector<Origin> Origins;
};
} // namespace palpate

#endif

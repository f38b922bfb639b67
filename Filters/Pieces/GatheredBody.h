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
 * The parts that BodyPiece has cut on several ranks, as one body with the response `name`. The
 * points of a seam are merged. The origin of each triangle is stored.
 */
class GatheredBody
{
public:
  /// The origin of a triangle.
  struct Origin
  {
    int rank;
    vtkIdType cell; ///< cell of that rank's piece
  };

  /// `parts`: at most one for each rank.
  GatheredBody(const std::vector<vtkSmartPointer<vtkPolyData>>& parts, const std::string& name);

  vtkPolyData* body() const { return this->Body; }
  const Origin& origin(std::size_t triangle) const { return this->Origins[triangle]; }

private:
  vtkSmartPointer<vtkPolyData> Body;
  std::vector<Origin> Origins;
};
} // namespace palpate

#endif

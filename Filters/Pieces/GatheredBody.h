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
 * The parts cut by BodyPiece on several ranks as one body with the response `name`: the points of a
 * seam are merged. The origin of each triangle is kept.
 */
class GatheredBody
{
public:
  /// Where a triangle comes from.
  struct Origin
  {
    int rank;
    vtkIdType cell; ///< of that rank's piece
  };

  /// `parts`: one of each rank.
  GatheredBody(const std::vector<vtkSmartPointer<vtkPolyData>>& parts, const std::string& name);

  vtkPolyData* body() const { return this->Body; }
  const Origin& origin(std::size_t triangle) const { return this->Origins[triangle]; }

private:
  vtkSmartPointer<vtkPolyData> Body;
  std::vector<Origin> Origins;
};
} // namespace palpate

#endif

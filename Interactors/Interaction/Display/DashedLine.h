// SPDX-License-Identifier: BSD-3-Clause
#ifndef DashedLine_h
#define DashedLine_h

#include "vtkSmartPointer.h"

#include <Eigen/Core>

class vtkCellArray;
class vtkDoubleArray;
class vtkPoints;
class vtkPolyData;

namespace palpate
{
/// Makes partly dashed lines through points. The lines are input for vtkTubeFilter, which requires
/// lines without repeated positions. Each point has a value, which is interpolated linearly along
/// the line.
class DashedLine
{
public:
  /// `dash` and `gap` are the length of a dash and of the gap after it, mm, > 0.
  DashedLine(double dash, double gap);
  ~DashedLine();
  DashedLine(const DashedLine&) = delete;
  DashedLine& operator=(const DashedLine&) = delete;

  /// Begins a line at `point`.
  void moveTo(const Eigen::Vector3d& point, double value = 0.0);
  /// Continues the line from the last point to `point`. Dashes continue around corners.
  void lineTo(const Eigen::Vector3d& point, double value = 0.0, bool dashed = false);

  /// Whether at least one gap has been drawn.
  bool hasGaps() const { return this->HasGaps; }
  /// Returns all lines drawn so far. The values are the active scalars with the name `name`.
  vtkSmartPointer<vtkPolyData> take(const char* name);

private:
  void extend(const Eigen::Vector3d& point, double value);
  void end();

  double Dash;
  double Gap;
  bool InGap = false;
  bool IsAfterGap = false; ///< whether the line had a gap since the last dash
  bool HasGaps = false;
  double Remaining; ///< remaining length of the present dash or gap, mm
  Eigen::Vector3d Last = Eigen::Vector3d::Zero();
  double LastValue = 0.0;
  vtkIdType OpenPoints = 0; ///< number of points of the line that is being drawn
  vtkSmartPointer<vtkPoints> Points;
  vtkSmartPointer<vtkCellArray> Lines;
  vtkSmartPointer<vtkDoubleArray> Values;
};
} // namespace palpate

#endif

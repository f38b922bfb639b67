// SPDX-License-Identifier: BSD-3-Clause
#ifndef TipPoses_h
#define TipPoses_h

#include "Contact/Contact.h"
#include "Contact/ContactBody.h"
#include "Contact/TriangleTree.h"

#include "vtkType.h"

#include <cstdint>
#include <string>

class vtkDataArray;
class vtkPolyData;

namespace palpate
{
/// Name of the point array of tips that contains the axes of the tools.
constexpr const char* ToolAxisName = "ToolAxis";

/// Returns whether tips have the array of tool axes.
bool haveAxes(vtkPolyData* tips);

/// Checks the tool axes of tips. Returns "" or an error that names the first tip with an invalid
/// axis.
std::string checkAxes(vtkPolyData* tips);

/**
 * Computes the poses of tools at tips whose axes have passed checkAxes. Each tip is moved inward by
 * `indentation` (mm) along the blended normal at its closest point. The pose includes the axis if
 * the tips have axes. Use each object from one thread only. Body and tips must outlive the object.
 */
class TipPoses
{
public:
  TipPoses(const ContactBody& body, vtkPolyData* tips, double indentation);

  ToolPose at(vtkIdType tip);
  /// Returns the pose for a tip whose position is already known.
  ToolPose at(vtkIdType tip, const Vector3& position);

  /// Returns a pose just below the triangle of the closest point, away from the edges of the
  /// triangle. A contact that begins at this pose and then moves to at() is on the face that is
  /// pressed. A contact that begins at at() may be on another face across a sharp edge, if that
  /// face is nearer. Without an indentation, the pose is the pose of the tip itself.
  ToolPose onset(vtkIdType tip, const Vector3& position);

private:
  /// Finds the closest point and the blended normal at this point. The normal is not normalised.
  /// Returns the index of the triangle, or -1 if the indentation is 0 or no normal exists.
  std::int32_t findSite(const Vector3& tip, Vector3& point, Vector3& normal);
  ToolPose poseAt(vtkIdType tip, const Vector3& position);

  const ContactBody& Body;
  vtkPolyData* Tips;
  vtkDataArray* Axes;
  TriangleSearch Search;
  double Indentation;
};
} // namespace palpate

#endif

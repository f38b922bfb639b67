// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ViewerScene_h
#define palpate_ViewerScene_h

#include "ViewerOptions.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

#include <array>
#include <string>
#include <vector>

namespace palpate
{
using Direction = std::array<double, 3>;

/// The input of a session: a body, its material, its tools and the points to touch.
struct ViewerScene
{
  std::string title;
  vtkSmartPointer<vtkPolyData> body;
  std::vector<std::string> notes; ///< sentences that describe how the body was made
  double youngsModulus = 0.1;     ///< MPa; the default is that of vtkToolContactResponse
  double poissonRatio = 0.45;
  LawTerms terms;         ///< terms of the law: strain, curvature, error
  PronySeries relaxation; ///< relaxation of the body
  /// Whether the body already has the response "Response", which is used unchanged.
  bool stored = false;
  /// Whether the body has nodules. It then also stores the responses without the nodules, and the
  /// changes of the force by the nodules.
  bool nodules = false;
  /// Lines on the body in off-screen pictures; null if there are none.
  vtkSmartPointer<vtkPolyData> marks;
  std::string marksInWords; ///< explanation of the lines, for the caption
  std::string materialSource;
  LayerChoice layer;       ///< layers; if their thickness is scanned, the body has the array
                           ///< LayerThickness or, for a stack, LayerThickness0 and LayerThickness1
  std::string tissues;     ///< description of the tissues of a segmentation; "" for other bodies
  std::string modelReason; ///< reason for this law, and its range of validity
  std::vector<std::string> tools;
  double depth = 1.0;
  Direction center{};
  /// Directions from the centre to the points that the path visits.
  std::vector<Direction> directions;
  double pictureAt = 0.5; ///< fraction of the slide at which the pictures are taken
  Direction viewFrom{ 0.0, -1.0, 0.4 };
  Direction up{ 0.0, 0.0, 1.0 };
  /// The readings of --measured, which are output port 2 of vtkMeasuredContactResponse.
  vtkSmartPointer<vtkTable> readings;
  std::string readSite;    ///< the site whose readings are shown
  bool solid = false;      ///< whether the body has the compliance of --voxel
  bool sideBySide = false; ///< whether one picture shows all tools
};

/// Makes the scene for the options. Returns "" or an error that names the missing or wrong option.
std::string makeViewerScene(const ViewerOptions& options, ViewerScene& scene);

// Each kind of scene has one function; makeViewerScene calls one of these functions.
std::string makeHeadScene(const ViewerOptions& options, ViewerScene& scene);
std::string makeCylinderScene(const ViewerOptions& options, ViewerScene& scene);
std::string makePhantomScene(const ViewerOptions& options, ViewerScene& scene);
std::string makeSegmentedScene(const ViewerOptions& options, ViewerScene& scene);
std::string makeUserScene(const ViewerOptions& options, ViewerScene& scene);
} // namespace palpate

#endif

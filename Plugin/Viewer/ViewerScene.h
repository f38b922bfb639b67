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

/// The input of a session: a body, its material, its tools and the places to touch.
struct ViewerScene
{
  std::string title;
  vtkSmartPointer<vtkPolyData> body;
  std::vector<std::string> notes; ///< description of how the body was made, one sentence each
  double youngsModulus = 0.1;     ///< MPa; same default as in vtkToolContactResponse
  double poissonRatio = 0.45;
  LawTerms terms;         ///< terms of the law: strain, curvature, error
  PronySeries relaxation; ///< relaxation of the body
  /// Whether the body already has the response "Response", which is used unchanged.
  bool stored = false;
  /// Whether the body has nodules. It then also stores the responses without the nodules, and the
  /// changes of the force by the nodules.
  bool nodules = false;
  vtkSmartPointer<vtkPolyData> marks; ///< lines on the body in off-screen pictures; null: none
  std::string marksInWords;           ///< what the lines are, for the caption
  std::string materialSource;
  LayerChoice layer; ///< if the thickness is scanned, the body has the array LayerThickness or, for
                     ///< a stack, LayerThickness0 and LayerThickness1
  std::string tissues;     ///< description of a segmentation's tissues; "" for other bodies
  std::string modelReason; ///< reason for this law, and its range of validity
  std::vector<std::string> tools;
  double depth = 1.0;
  Direction center{};
  std::vector<Direction> directions; ///< directions from the centre that the path visits
  double pictureAt = 0.5;            ///< fraction of the slide at which the pictures are taken
  Direction viewFrom{ 0.0, -1.0, 0.4 };
  Direction up{ 0.0, 0.0, 1.0 };
  vtkSmartPointer<vtkTable> readings; ///< for --measured: the readings, port 2 of
                                      ///< vtkMeasuredContactResponse
  std::string readSite;               ///< the site whose readings are shown
  bool solid = false;                 ///< whether the body has the compliance of --voxel
  bool sideBySide = false;            ///< whether one picture shows all tools
};

/// Makes the scene for the options. Returns "", or an error that names the missing or wrong option.
std::string makeViewerScene(const ViewerOptions& options, ViewerScene& scene);

// There is one function per kind of scene; makeViewerScene calls one of them.
std::string makeHeadScene(const ViewerOptions& options, ViewerScene& scene);
std::string makeCylinderScene(const ViewerOptions& options, ViewerScene& scene);
std::string makePhantomScene(const ViewerOptions& options, ViewerScene& scene);
std::string makeSegmentedScene(const ViewerOptions& options, ViewerScene& scene);
std::string makeUserScene(const ViewerOptions& options, ViewerScene& scene);
} // namespace palpate

#endif

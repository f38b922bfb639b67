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
  std::vector<std::string> notes; ///< how the body was made, one sentence each
  double youngsModulus = 0.05;
  double poissonsRatio = 0.45;
  LawTerms terms;         ///< of the law: strain, curvature, error
  PronySeries relaxation; ///< of the body
  bool stored = false;    ///< the body has the response "Response", to be used unchanged
  /// Stored; also has the responses without its nodules, and the changes by these.
  bool nodules = false;
  std::string materialSource;
  LayerChoice layer; ///< scanned: the body's array LayerThickness, of a stack LayerThickness0 and 1
  std::string modelReason; ///< why this law, and how far it is valid
  std::vector<std::string> tools;
  double depth = 1.0;
  Direction center{};
  std::vector<Direction> directions; ///< visited by the path, seen from the centre
  double pictureAt = 0.5;            ///< fraction of the slide at which the pictures are taken
  Direction viewFrom{ 0.0, -1.0, 0.4 };
  Direction up{ 0.0, 0.0, 1.0 };
  vtkSmartPointer<vtkTable> readings; ///< of --measured: vtkMeasuredContactResponse, port 2
  std::string readSite;               ///< the site whose readings are shown
  bool solid = false;                 ///< the body has the compliance of --voxel
  bool sideBySide = false;            ///< one picture with all tools
};

/// Makes the scene of the options; returns an error that names the missing or wrong thing, or "".
std::string makeViewerScene(const ViewerOptions& options, ViewerScene& scene);

// One maker per kind of scene; makeViewerScene chooses.
std::string makeHeadScene(const ViewerOptions& options, ViewerScene& scene);
std::string makeCylinderScene(const ViewerOptions& options, ViewerScene& scene);
std::string makePhantomScene(const ViewerOptions& options, ViewerScene& scene);
std::string makeUserScene(const ViewerOptions& options, ViewerScene& scene);
} // namespace palpate

#endif

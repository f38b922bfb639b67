// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ViewerOptions_h
#define palpate_ViewerOptions_h

#include "GivenSettings.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// What lies under the surface: a layer on a rigid base, as thick as the scan shows or everywhere
/// alike; thickness 0 is a half-space.
struct LayerChoice
{
  bool scanned = false;
  double thickness = 0.0; ///< mm, unless scanned
};

/// The viewer's command line. Lengths in mm, moduli in MPa. What was not given is left to the
/// scene.
struct ViewerOptions
{
  std::string body;
  std::string scene = "head";
  std::string scan; ///< of the head scene; empty: where Debian's mricron-data puts it
  std::vector<std::string> tools;
  std::optional<double> youngsModulus;
  std::optional<double> poissonsRatio;
  std::optional<double> depth;
  double maximumDeflection = 2.0;
  std::optional<LayerChoice> layer;
  double baseValue = 35.0;           ///< of a scan: grey level below which it is bone
  std::vector<std::string> measured; ///< files of curves
  std::string registration;          ///< of their frame with the body's; empty: one frame
  double reach = 20.0;               ///< of a measured site, mm
  double voxel = 0.0; ///< side of the hexahedra a surface is filled with, mm; 0: it is not
  std::string fixedFaces = "z-"; ///< sides of the bounding box that hold it then
  double lengthScale = 1.0;
  double resolution = 0.0;
  double contourValue = 30.0;
  double closingRadius = 6.0;
  std::optional<std::array<double, 3>> site;
  std::optional<std::array<double, 3>> slideTo;
  double rate = 1000.0;
  GivenSettings contact; ///< its Poisson's ratio is the scene's
  std::string output = "palpate-output";
  std::string save;
  std::string exportTo;
  bool window = false;
  std::string screenshot;
};

/// Reads the command line. Returns an exit code when the program is to end here (help, version, or
/// a wrong call, which has then been explained on the error stream), otherwise nothing.
std::optional<int> readCommandLine(int argc, char** argv, ViewerOptions& options);
} // namespace palpate

#endif

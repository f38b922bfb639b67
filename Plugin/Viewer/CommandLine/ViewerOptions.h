// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ViewerOptions_h
#define palpate_ViewerOptions_h

#include "Contact/ContactSettings.h"
#include "Laws/LawTerms.h"
#include "LayerChoice.h"
#include "Mechanics/Relaxation/PronySeries.h"
#include "TissueChoice.h"
#include "TrialChoice.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// The values of the viewer's command line. Lengths are in mm, moduli in MPa. The scene provides
/// the values of options that are not given.
struct ViewerOptions
{
  std::string body;
  std::string scene = "head";
  std::string scan; ///< scan file of the head scene; if empty, the scan of Debian's mricron-data
  std::vector<std::string> tools;
  std::optional<double> youngsModulus;
  std::optional<double> poissonRatio;
  std::optional<double> depth;
  double maximumDeflection = 2.0;
  LawTerms terms;                    ///< terms for strain, curvature and error
  bool strainGiven = false;          ///< whether --strain is given
  PronySeries relaxation;            ///< value of --relax
  std::optional<LayerChoice> layer;  ///< value of --layer or --layers
  double baseValue = 35.0;           ///< for a scan, grey level below which a voxel is bone
  std::vector<std::string> measured; ///< files with measured curves
  std::string registration; ///< file with the transform from the curves' frame to the body's frame;
                            ///< empty if both frames are equal
  /// Radius around a measured site within which the response of the site is used, mm.
  double reach = 20.0;
  double maximumStrain = 0.4; ///< largest strain of the measured readings that are used
  double voxel = 0.0; ///< side of the hexahedra that fill a surface, mm; 0 if it is not filled
  bool solid = false; ///< whether --solid is given, which fills the body with graded tetrahedra
  /// Size of the tetrahedra at the surface, mm; 0 if it is chosen automatically.
  double solidSpacing = 0.0;
  /// Values of --tissue; empty if the body is not a segmentation.
  std::vector<TissueChoice> tissues;
  std::string fixedFaces = "z-"; ///< faces of the bounding box at which the solid is held
  bool fixedGiven = false;
  bool wholeBody = true; ///< whether the compliance of the whole body is included where it applies
  double lengthScale = 1.0;
  double resolution = 0.0;
  double contourValue = 0.0; ///< grey level of the skin in a scan; 0 if it is chosen from the scan
  double closingRadius = 6.0;
  std::optional<std::array<double, 3>> site;
  std::optional<std::array<double, 3>> slideTo;
  double rate = 1000.0;
  ContactSettings contact; ///< contact settings; the scene sets their Poisson's ratio
  std::string output = "palpate-output";
  std::string save;
  std::string exportTo;
  bool pictures = true; ///< whether an off-screen session makes pictures
  bool window = false;
  bool compare = false; ///< whether to compare two built-in bodies, side by side
  bool map = false; ///< whether to show a map of where the shape of the first tool matters, instead
                    ///< of a session
  std::string screenshot;
  std::string device = "simulated";
  std::vector<std::string> hands; ///< further devices on the same body
  double scale = 1.0;             ///< length in the body per length of the hand
  std::string record;             ///< file for the trajectory with all ticks
  bool listDevices = false;
  std::vector<TrialChoice> trial; ///< alternatives of a blind comparison; empty if there is none
  int trialRounds = 5;
  std::optional<std::uint64_t> trialSeed;
  /// Log file of a blind comparison; if empty, trial.csv in the output folder.
  std::string trialLog;
  /// Question of a blind comparison; if empty, which alternative pushes back more.
  std::string question;
  bool automatic = true; ///< whether to use the simplest form of the response that keeps the forces
                         ///< within `tolerance`
  bool verbose = false;  ///< whether to print the chosen form, with the reason
  double tolerance = 0.01; ///< largest relative error of the force of the simplest form
};

/// Reads the command line. Returns an exit code if the program must end, otherwise an empty
/// optional. The program must end after the help, the version, or an error, which has been printed
/// on the error stream.
std::optional<int> readCommandLine(int argc, char** argv, ViewerOptions& options);
} // namespace palpate

#endif

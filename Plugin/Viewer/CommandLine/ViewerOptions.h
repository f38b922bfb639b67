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
/// Values of the viewer's command line. Lengths in mm, moduli in MPa. An option that is not given
/// gets its value from the scene.
struct ViewerOptions
{
  std::string body;
  std::string scene = "head";
  std::string scan; ///< file of the scan for the head scene; empty: the scan of Debian's
                    ///< mricron-data
  std::vector<std::string> tools;
  std::optional<double> youngsModulus;
  std::optional<double> poissonRatio;
  std::optional<double> depth;
  double maximumDeflection = 2.0;
  LawTerms terms;                    ///< strain, curvature, error
  bool strainGiven = false;          ///< --strain
  PronySeries relaxation;            ///< --relax
  std::optional<LayerChoice> layer;  ///< --layer or --layers
  double baseValue = 35.0;           ///< for a scan: grey level below which it is bone
  std::vector<std::string> measured; ///< files of curves
  std::string registration;          ///< file of the transform from the curves' frame to the body's
                                     ///< frame; empty: the same frame
  double reach = 20.0;               ///< radius around a measured site that gets its response, mm
  double maximumStrain = 0.4;        ///< largest strain of the measured readings that are used
  double voxel = 0.0;                ///< side of the hexahedra that fill a surface, mm; 0: none
  bool solid = false;                ///< --solid: whether to fill the body with graded tetrahedra
  double solidSpacing = 0.0;         ///< size of the tetrahedra at the surface, mm; 0: chosen
                                     ///< automatically
  std::vector<TissueChoice> tissues; ///< --tissue; empty: the body is no segmentation
  std::string fixedFaces = "z-";     ///< sides of the bounding box that hold the solid
  bool fixedGiven = false;
  bool wholeBody = true; ///< whether the compliance of the whole body is included where it applies
  double lengthScale = 1.0;
  double resolution = 0.0;
  double contourValue = 0.0; ///< grey level of the skin in a scan; 0: chosen from the scan
  double closingRadius = 6.0;
  std::optional<std::array<double, 3>> site;
  std::optional<std::array<double, 3>> slideTo;
  double rate = 1000.0;
  ContactSettings contact; ///< the scene sets its Poisson's ratio
  std::string output = "palpate-output";
  std::string save;
  std::string exportTo;
  bool pictures = true; ///< whether a session off screen makes pictures
  bool window = false;
  bool compare = false; ///< whether to compare two built-in bodies, side by side
  bool map = false;     ///< whether to show where the shape of the first tool matters, instead of a
                        ///< session
  std::string screenshot;
  std::string device = "simulated";
  std::vector<std::string> hands; ///< further devices on the same body
  double scale = 1.0;             ///< mm of the body per mm of the hand
  std::string record;             ///< file for a trajectory of all ticks
  bool listDevices = false;
  std::vector<TrialChoice> trial; ///< alternatives of a blind comparison; empty: none
  int trialRounds = 5;
  std::optional<std::uint64_t> trialSeed;
  std::string trialLog;  ///< file of the log of a blind comparison; empty: trial.csv in the output
                         ///< folder
  std::string question;  ///< question of a blind comparison; empty: "which pushes back more"
  bool automatic = true; ///< whether to use the simplest form of the response that keeps its
                         ///< forces
  bool verbose = false;  ///< whether to print that form, with the reason
  double tolerance = 0.01; ///< largest relative error of the force of that form
};

/// Reads the command line. Returns an exit code if the program must end (help, version, or an
/// error, already explained on the error stream), otherwise an empty optional.
std::optional<int> readCommandLine(int argc, char** argv, ViewerOptions& options);
} // namespace palpate

#endif

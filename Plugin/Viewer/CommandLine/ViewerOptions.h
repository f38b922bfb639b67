// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ViewerOptions_h
#define palpate_ViewerOptions_h

#include "Contact/ContactSettings.h"
#include "Laws/LawTerms.h"
#include "LayerChoice.h"
#include "Mechanics/Relaxation/PronySeries.h"
#include "TrialChoice.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// The viewer's command line. Lengths in mm, moduli in MPa. Options not given are chosen by the
/// scene.
struct ViewerOptions
{
  std::string body;
  std::string scene = "head";
  std::string scan; ///< of the head scene; empty: that of Debian's mricron-data
  std::vector<std::string> tools;
  std::optional<double> youngsModulus;
  std::optional<double> poissonsRatio;
  std::optional<double> depth;
  double maximumDeflection = 2.0;
  LawTerms terms;                    ///< strain, curvature, error
  bool strainGiven = false;          ///< --strain
  PronySeries relaxation;            ///< --relax
  std::optional<LayerChoice> layer;  ///< --layer or --layers
  double baseValue = 35.0;           ///< of a scan: grey level below which it is bone
  std::vector<std::string> measured; ///< files of curves
  std::string registration;          ///< of their frame with the body's; empty: the same frame
  double reach = 20.0;               ///< of a measured site, mm
  double maximumStrain = 0.4;        ///< of measured readings
  double voxel = 0.0;                ///< side of the hexahedra that fill a surface, mm; 0: none
  bool solid = false;                ///< --solid: filled with graded tetrahedra
  double solidSpacing = 0.0;         ///< of these at the surface, mm; 0: chosen
  std::string fixedFaces = "z-";     ///< sides of the bounding box that hold the solid
  double lengthScale = 1.0;
  double resolution = 0.0;
  double contourValue = 30.0;
  double closingRadius = 6.0;
  std::optional<std::array<double, 3>> site;
  std::optional<std::array<double, 3>> slideTo;
  double rate = 1000.0;
  ContactSettings contact; ///< its Poisson's ratio is the scene's
  std::string output = "palpate-output";
  std::string save;
  std::string exportTo;
  bool pictures = true; ///< of a session off screen
  bool window = false;
  bool compare = false; ///< its own two bodies, side by side
  bool map = false;     ///< where the shape of the first tool matters, instead of a session
  std::string screenshot;
  std::string device = "simulated";
  std::vector<std::string> hands; ///< further devices on the same body
  double scale = 1.0;             ///< mm of the body per mm of the hand
  std::string record;             ///< a trajectory of every tick
  bool listDevices = false;
  std::vector<TrialChoice> trial; ///< blind comparison of these; empty: none
  int trialRounds = 5;
  std::optional<std::uint64_t> trialSeed;
  std::string trialLog;    ///< empty: trial.csv in the output folder
  std::string question;    ///< empty: which pushes back more
  bool automatic = true;   ///< use the simplest form of the response that keeps its forces
  double tolerance = 0.01; ///< of that form, relative
};

/// Reads the command line. Returns an exit code if the program must end (help, version, or a wrong
/// call, which has been explained on the error stream), otherwise nothing.
std::optional<int> readCommandLine(int argc, char** argv, ViewerOptions& options);
} // namespace palpate

#endif

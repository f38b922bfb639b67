// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ViewerModules_h
#define palpate_ViewerModules_h

#include "MeasuredBody.h"
#include "Mechanics/Files/ModuleFile.h"
#include "ComparisonBodies.h"
#include "ComparisonPictures.h"
#include "ComparisonWindow.h"
#include "RegimeMap.h"
#include "SolidBody.h"
#include "TrialRuns.h"
#include "VoxelCompliance.h"
#include "ViewerScene.h"

#include <string>

namespace palpate
{
/// Functions of libpalpateViewerSolids.so, for the options --solid, --voxel, --tissue, --compare
/// and --scene phantom.
struct SolidsModule : ModuleTable
{
  decltype(&attachSolidResponses) fillWithTetrahedra;
  decltype(&attachVoxelCompliance) fillWithVoxels;
  decltype(&makeComparedBodies) compareBodies;
  decltype(&makePhantomScene) pressPhantom;
  decltype(&makeSegmentedScene) pressTissues;
};

/// Functions of libpalpateViewerIdentification.so, for the option --measured.
struct IdentificationModule : ModuleTable
{
  decltype(&attachMeasured) identify;
};

/// Functions of libpalpateViewerComparison.so, for the options --compare, whose bodies SolidsModule
/// makes, and --map.
struct ComparisonModule : ModuleTable
{
  decltype(&runComparison) drawComparison;
  decltype(&runComparisonWindow) compareInWindow;
  decltype(&runRegimeMap) mapRegime;
};

/// Functions of libpalpateViewerTrials.so, for the option --trial.
struct TrialsModule : ModuleTable
{
  decltype(&runTrialWindow) askInWindow;
  decltype(&runTrialConsole) askInConsole;
};

/// Returns a module. On failure, returns null and sets `fault` to a sentence that names the option,
/// the module and how to install it. The first call loads the module.
const SolidsModule* solidsModule(const std::string& option, std::string& fault);
const IdentificationModule* identificationModule(const std::string& option, std::string& fault);
const ComparisonModule* comparisonModule(const std::string& option, std::string& fault);
const TrialsModule* trialsModule(const std::string& option, std::string& fault);
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
// The demo: forehead and cheek of the head in Debian's mricron-data (Colin 27, T1 MRI at 1 mm).
#include "ViewerScene.h"

#include "BodyCache.h"
#include "LayerModel.h"

#include <filesystem>

namespace palpate
{
namespace
{
const char* const InstalledScan = "/usr/share/mricron/templates/ch2.nii.gz";
constexpr double SkinLevel = 30.0; // grey level of the skin in this scan
} // namespace

std::string makeHeadScene(const ViewerOptions& options, ViewerScene& scene)
{
  const std::string scan = options.scan.empty() ? InstalledScan : options.scan;
  std::error_code ignored;
  if (options.scan.empty() && !std::filesystem::exists(scan, ignored))
  {
    return "the head scan " + scan +
      " is missing: install Debian's package mricron-data, or give --scan FILE";
  }
  BodyFileOptions file;
  file.resolution = options.resolution;
  file.contourValue = options.contourValue == 0.0 ? SkinLevel : options.contourValue;
  file.closingRadius = options.closingRadius;
  scene.layer = { true, 0.0 };
  file.baseValue = scanValue(options, scene.layer);
  const BodyFileResult read = readCachedScan(scan, file);
  if (!read.error.empty())
  {
    return read.error;
  }
  scene.title = "Head (Colin 27)";
  scene.body = read.body;
  scene.notes = read.notes;
  scene.youngsModulus = 0.035;
  scene.poissonRatio = 0.49;
  scene.materialSource =
    "E within the 31-42 kPa of cheek, cheekbone and forehead in vivo (aspiration; Luboz, Promayon "
    "and Payan, HAL hal-01092748); Poisson's ratio assumed nearly incompressible";
  scene.modelReason = "skin over bone is a thin layer, so that the true force there is higher, "
                      "with a difference that grows with the depth";
  scene.tools = { "sphere:6.35", "flat:1.6", "sphere:1.6" };
  scene.depth = 0.8; // depth of the press, mm; within the validity on most of the path
  // Positions are relative to the scan's origin; +x is to the right, +y to the nose and +z up. The
  // path leads from above the left brow over the temple to the left cheek.
  scene.center = { 0.0, -15.0, 14.0 };
  scene.directions = { { -30.0, 89.0, 30.0 }, { -75.0, 55.0, 5.0 }, { -72.0, 55.0, -48.0 },
    { -52.0, 72.0, -68.0 } };
  scene.pictureAt = 0.0;
  scene.viewFrom = { -0.85, 0.75, 0.10 };
  return {};
}
} // namespace palpate

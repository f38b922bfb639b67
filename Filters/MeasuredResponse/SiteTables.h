// SPDX-License-Identifier: BSD-3-Clause
#ifndef SiteTables_h
#define SiteTables_h

#include "Identification/MeasuredCurve.h"
#include "Identification/MeasuredSite.h"

#include <string>
#include <vector>

class vtkTable;

namespace palpate
{
/// A site, and its position on the body.
struct PlacedSite
{
  MeasuredSite measured;
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< position after registration, mm
  double distance = 0.0;                              ///< distance from the surface, mm
};

/// Fills a table with one row per site: the identified body, or the reason of the refusal
/// (vtkMeasuredContactResponse.h, port 1).
void tabulateSites(const std::vector<PlacedSite>& sites, vtkTable* table);

/// Fills a table with one row per reading of a loading, with depths from first contact: the
/// measured force, the force made monotone, and the force of the identified body. For a site that
/// relaxes, there is one row for every reading, in the order of time (vtkMeasuredContactResponse.h,
/// port 2).
void tabulateCurves(const std::vector<PlacedSite>& sites,
  const std::shared_ptr<const LayerKernel>& kernel, vtkTable* table);

/// Reads the readings of one tool from a table with the columns of a file of curves (CurvesFile.h),
/// for example from a reader of .csv files. Other columns are ignored. `name` replaces the file
/// name in error messages. Returns a fault with the row, or "".
std::string curvesFromTable(
  vtkTable* table, const std::string& name, const std::string& tool, MeasuredCurves& curves);
} // namespace palpate

#endif

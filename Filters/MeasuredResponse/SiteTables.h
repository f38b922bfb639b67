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
/// A site, and its place on the body.
struct PlacedSite
{
  MeasuredSite measured;
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< registered, mm
  double distance = 0.0;                              ///< from the surface, mm
};

/// One row per site: what was identified, or why not (vtkMeasuredContactResponse.h, port 1).
void tabulateSites(const std::vector<PlacedSite>& sites, vtkTable* table);

/// One row per reading of a loading, counted from first contact: as measured, made monotone, and by
/// the identified body. Of a body that relaxes a row for every reading, in the order of time
/// (vtkMeasuredContactResponse.h, port 2).
void tabulateCurves(const std::vector<PlacedSite>& sites,
  const std::shared_ptr<const LayerKernel>& kernel, vtkTable* table);

/// The readings of one tool from a table with the columns of a file of curves (CurvesFile.h), as a
/// reader of .csv files makes it; other columns are ignored. `name` stands for the file in errors.
/// Returns what is wrong, with the row, or "".
std::string curvesFromTable(
  vtkTable* table, const std::string& name, const std::string& tool, MeasuredCurves& curves);
} // namespace palpate

#endif

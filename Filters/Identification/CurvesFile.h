// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CurvesFile_h
#define palpate_CurvesFile_h

#include "Identification/MeasuredCurve.h"
#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <functional>
#include <istream>
#include <string>
#include <vector>

namespace palpate
{
/**
 * Reads measured force-deflection curves, or computed ones of any finite-element code:
 *
 *   # tool: sphere:6.35
 *   # synthetic: how they were made              (only if they were not measured)
 *   site,x_mm,y_mm,z_mm,deflection_mm,force_N,time_s,phase
 *   A,10,0,50,0.02,0.0013,0.1,loading
 *
 * time_s and phase (`loading`, `unloading`, `hold`, or empty) may be left out, and site, of a file
 * of one curve, whose site is then named by its position. Columns may be in any order; other
 * columns (CsvReader) and other comments are ignored. The rows of a site share its position; they
 * are in the order in which they were taken, and time does not decrease.
 *
 * Units: a column names its own: deflection_nm, _um, _mm, _cm or _m; force_nN, _uN, _mN, _N or _kN;
 * time_us, _ms, _s or _min. Signs: deflection and force rise as the tool is pressed in; what falls
 * instead stands in the head, as `# negative: force` or `# negative: deflection, force`.
 *
 * Returns an error "file:line: what is wrong", or "". After an error `curves` is unchanged.
 */
PALPATE_EXPORT std::string readCurves(const std::string& path, MeasuredCurves& curves);

/// The same from a stream; `name` stands for the file in errors.
PALPATE_EXPORT std::string readCurves(
  std::istream& stream, const std::string& name, MeasuredCurves& curves);

/// The readings of one tool as a table that has been read already: its columns, named as in a file,
/// and their fields as texts.
struct CurvesTable
{
  std::string name; ///< stands for the file in errors
  std::string tool; ///< specification, as sphere:6.35
  std::vector<std::string> columns;
  std::size_t rowCount = 0;
  std::function<std::string(std::size_t row, std::size_t column)> field;
};

/// The same from a table; an error is "name: row 7: what is wrong", rows counting from 0.
PALPATE_EXPORT std::string readCurves(const CurvesTable& table, MeasuredCurves& curves);
} // namespace palpate

#endif

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
 * Reads force-deflection curves, measured or computed by any finite-element code:
 *
 *   # tool: sphere:6.35
 *   # synthetic: how they were made              (only if they were not measured)
 *   site,x_mm,y_mm,z_mm,deflection_mm,force_N,time_s,phase
 *   A,10,0,50,0.02,0.0013,0.1,loading
 *
 * The columns time_s and phase (`loading`, `unloading`, `hold`, or empty) are optional. The column
 * site is optional in a file with one curve; the name of the site is then its position. Columns may
 * be in any order. Other columns (CsvReader) and other comments are ignored. All rows of a site
 * must have the same position. They must be in the order of measurement, and time must not
 * decrease.
 *
 * Units: the name of a column contains its unit: deflection_nm, _um, _mm, _cm or _m; force_nN, _uN,
 * _mN, _N or _kN; time_us, _ms, _s or _min. Signs: deflection and force increase while the tool is
 * pressed in. If a quantity decreases instead, the head of the file must say so: `# negative:
 * force` or `# negative: deflection, force`.
 *
 * Returns an error message of the form "file:line: reason", or "". After an error `curves` is
 * unchanged.
 */
PALPATE_EXPORT std::string readCurves(const std::string& path, MeasuredCurves& curves);

/// Reads curves from a stream. `name` replaces the file name in error messages.
PALPATE_EXPORT std::string readCurves(
  std::istream& stream, const std::string& name, MeasuredCurves& curves);

/// The readings of one tool as a table in memory: columns named as in a file, and fields as text.
struct CurvesTable
{
  std::string name; ///< replaces the file name in error messages
  std::string tool; ///< specification, such as sphere:6.35
  std::vector<std::string> columns;
  std::size_t rowCount = 0;
  std::function<std::string(std::size_t row, std::size_t column)> field;
};

/// Reads curves from a table. Error messages have the form "name: row 7: reason"; rows count from
/// 0.
PALPATE_EXPORT std::string readCurves(const CurvesTable& table, MeasuredCurves& curves);
} // namespace palpate

#endif

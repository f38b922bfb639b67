// SPDX-License-Identifier: BSD-3-Clause
// The data read from curves files. A fault is reported with file and line, and no part of a faulty
// file is loaded.
#include "Identification/CurvesFile.h"

#include <gtest/gtest.h>

#include <sstream>

using palpate::CurvePhase;
using palpate::MeasuredCurves;
using palpate::readCurves;

namespace
{
const std::string Head = "# tool: sphere:6.35\n";
const std::string Columns = "site,x_mm,y_mm,z_mm,deflection_mm,force_N,time_s,phase\n";

std::string read(const std::string& text, MeasuredCurves& curves)
{
  std::istringstream stream(text);
  return readCurves(stream, "press.csv", curves);
}

/// Expects that the text is rejected with this error and that the previous content stays.
void refuse(const std::string& text, const std::string& error)
{
  MeasuredCurves curves;
  curves.file = "before";
  curves.curves.resize(3);
  EXPECT_EQ(read(text, curves), error) << text;
  EXPECT_EQ(curves.file, "before");
  EXPECT_EQ(curves.curves.size(), 3U);
}
} // namespace

TEST(CurvesFile, ReadsSitesInAnyOrderOfColumnsAndRows)
{
  MeasuredCurves curves;
  ASSERT_EQ(read("\xEF\xBB\xBF# measured on Monday\r\n# tool: flat:1.6\r\n# synthetic: by hand\r\n"
                 "force_N,deflection_mm,site,x_mm,y_mm,z_mm\r\n"
                 "0.5,0.1,A,1,2,3\r\n"
                 "-0.01, 0 ,B,4,5,6\r\n\r\n"
                 "1e-1,0.2,A,1,2,3\r\n",
              curves),
    "");
  EXPECT_EQ(curves.file, "press.csv");
  EXPECT_EQ(curves.toolText, "flat:1.6");
  EXPECT_EQ(curves.tool.Shape, palpate::ToolShape::Flat);
  EXPECT_EQ(curves.synthetic, "by hand");
  ASSERT_EQ(curves.curves.size(), 2U);
  EXPECT_EQ(curves.curves[0].site, "A");
  EXPECT_EQ(curves.curves[0].position, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(curves.curves[0].deflection, (std::vector<double>{ 0.1, 0.2 }));
  EXPECT_EQ(curves.curves[0].force, (std::vector<double>{ 0.5, 0.1 }));
  EXPECT_TRUE(curves.curves[0].time.empty());
  EXPECT_TRUE(curves.curves[0].phase.empty());
  EXPECT_EQ(curves.curves[1].force, std::vector<double>{ -0.01 });
}

TEST(CurvesFile, ReadsTimesAndPhases)
{
  MeasuredCurves curves;
  ASSERT_EQ(read(Head + Columns +
                "A,0,0,0,0.1,0.5,1,loading\nA,0,0,0,0.2,0.6,1,hold\nA,0,0,0,0.1,0.4,2,unloading\n"
                "A,0,0,0,0.0,0.0,3,\n",
              curves),
    "");
  EXPECT_TRUE(curves.synthetic.empty());
  EXPECT_EQ(curves.curves[0].time, (std::vector<double>{ 1, 1, 2, 3 }));
  EXPECT_EQ(curves.curves[0].phase,
    (std::vector<CurvePhase>{
      CurvePhase::Loading, CurvePhase::Hold, CurvePhase::Unloading, CurvePhase::Unknown }));
}

TEST(CurvesFile, ReadsUnitsOfTheColumns)
{
  for (const auto& [name, factor] : { std::pair{ "deflection_nm", 1e-6 }, { "deflection_um", 1e-3 },
         { "deflection_\xC2\xB5m", 1e-3 }, { "deflection_cm", 10.0 }, { "deflection_m", 1e3 } })
  {
    MeasuredCurves curves;
    ASSERT_EQ(read(Head + "x_mm,y_mm,z_mm,site,force_N," + name + "\n0,0,0,A,2,3\n", curves), "");
    EXPECT_EQ(curves.curves[0].deflection, std::vector<double>{ 3.0 * factor });
    EXPECT_EQ(curves.curves[0].force, std::vector<double>{ 2.0 });
  }
  for (const auto& [name, factor] : { std::pair{ "force_nN", 1e-9 }, { "force_uN", 1e-6 },
         { "force_\xC2\xB5N", 1e-6 }, { "force_mN", 1e-3 }, { "force_kN", 1e3 } })
  {
    MeasuredCurves curves;
    ASSERT_EQ(
      read(Head + "x_mm,y_mm,z_mm,site,deflection_mm," + name + "\n0,0,0,A,2,3\n", curves), "");
    EXPECT_EQ(curves.curves[0].force, std::vector<double>{ 3.0 * factor });
  }
  MeasuredCurves curves;
  ASSERT_EQ(
    read(Head + "x_mm,y_mm,z_mm,site,deflection_mm,force_N,time_ms\n0,0,0,A,2,3,5\n", curves), "");
  EXPECT_EQ(curves.curves[0].time, std::vector<double>{ 5.0 * 1e-3 });
}

TEST(CurvesFile, TurnsTheSignsThatTheHeadNames)
{
  MeasuredCurves curves;
  const std::string row = "x_mm,y_mm,z_mm,deflection_um,force_N\n-1,0,0,-200,-3\n";
  ASSERT_EQ(read(Head + "# negative: force\n" + row, curves), "");
  EXPECT_EQ(curves.curves[0].force, std::vector<double>{ 3.0 });
  EXPECT_EQ(curves.curves[0].deflection, std::vector<double>{ -200.0 * 1e-3 });
  ASSERT_EQ(read(Head + "# negative: deflection, force\n" + row, curves), "");
  EXPECT_EQ(curves.curves[0].force, std::vector<double>{ 3.0 });
  EXPECT_EQ(curves.curves[0].deflection, std::vector<double>{ 200.0 * 1e-3 });
  EXPECT_EQ(curves.curves[0].position, Eigen::Vector3d(-1, 0, 0));
}

TEST(CurvesFile, ReadsWhatSpreadsheetsWriteWithCommasInNumbers)
{
  MeasuredCurves curves;
  ASSERT_EQ(read("\xEF\xBB\xBF# tool: sphere:6.35;;;;;\r\n"
                 "site;x_mm;y_mm;z_mm;deflection_mm;force_N\r\n"
                 "A;10;0;-50,5;0,02;1,3e-3\r\nA;10;0;-50,5;0,04;0,0026\r\n",
              curves),
    "");
  EXPECT_EQ(curves.toolText, "sphere:6.35");
  EXPECT_EQ(curves.curves[0].position, Eigen::Vector3d(10, 0, -50.5));
  EXPECT_EQ(curves.curves[0].deflection, (std::vector<double>{ 0.02, 0.04 }));
  EXPECT_EQ(curves.curves[0].force, (std::vector<double>{ 0.0013, 0.0026 }));
}

TEST(CurvesFile, WithoutSitesIsOneCurve)
{
  const std::string columns = Head + "x_mm,y_mm,z_mm,deflection_mm,force_N\n";
  MeasuredCurves curves;
  ASSERT_EQ(read(columns + "10,-0.5,50,0.1,1\n10,-0.5,50,0.2,2\n", curves), "");
  ASSERT_EQ(curves.curves.size(), 1U);
  EXPECT_EQ(curves.curves[0].site, "(10, -0.5, 50)"); // the form that other tools write
  EXPECT_EQ(curves.curves[0].force, (std::vector<double>{ 1.0, 2.0 }));
  refuse(columns + "10,0,50,0.1,1\n10,0,51,0.2,2\n",
    "press.csv:4: has another position than the first row, but a file without the column 'site' "
    "has one "
    "curve");
}

TEST(CurvesFile, RefusesTheHead)
{
  const std::string row = "A,0,0,0,0.1,0.5,1,loading\n";
  refuse("", "press.csv:0: there is no line with the names of the columns");
  refuse(Head, "press.csv:1: there is no line with the names of the columns");
  refuse(Head + Columns, "press.csv:2: there are no readings");
  refuse(Columns + row,
    "press.csv:1: the head does not name the tool: '# tool: sphere:6.35' is missing");
  refuse(Head + Head + Columns + row, "press.csv:2: a file has one tool, named in its head");
  refuse(Head + Columns + Head + row, "press.csv:3: a file has one tool, named in its head");
  refuse(
    Head + "site,x_mm,y_mm,z_mm,deflection_mm\n" + row, "press.csv:2: column 'force_N' is missing");
  refuse(Head + "site,x_mm,y_mm,z_mm,deflection_mm,force_lbf\n" + row,
    "press.csv:2: column 'force_N' is missing; 'force_lbf' ends with none of the units N, nN, uN, "
    "\xC2\xB5N, mN, kN");
  refuse(Head + "site,x_mm,y_mm,z_mm,deflection_mm,deflection_um,force_N\n" + row,
    "press.csv:2: has both 'deflection_mm' and 'deflection_um'");
  refuse(Head + "# negative: time\n" + Columns + row,
    "press.csv:2: negative: 'time' is not known; accepted are force, deflection");
  refuse(Head + Columns + "# negative: force\n" + row, "press.csv:3: signs are named in the head");
  refuse(Head + "site,x_mm,x_mm,y_mm,z_mm,deflection_mm,force_N\n" + row,
    "press.csv:2: column 'x_mm' occurs twice");
  MeasuredCurves curves;
  const std::string error = read("# tool: spoon:3\n" + Columns + row, curves);
  EXPECT_EQ(error.rfind("press.csv:1: tool: ", 0), 0U) << error;
  EXPECT_NE(error.find("spoon"), std::string::npos) << error;
}

TEST(CurvesFile, RefusesRows)
{
  const std::string good = "A,0,0,0,0.1,0.5,1,loading\n";
  const auto refuseRow = [&](const std::string& row, const std::string& fault)
  { refuse(Head + Columns + good + row + "\n" + good, "press.csv:4: " + fault); };
  refuseRow("A,0,0,0,0.1,0.5,1", "has 7 fields instead of 8");
  refuseRow("A,0,0,0,0.1,0.5,1,loading,", "has 9 fields instead of 8");
  refuseRow(",0,0,0,0.1,0.5,1,loading", "the site has no name");
  refuseRow("A,0,0,0,0.1,nan,1,loading", "force_N: 'nan' is not a finite number");
  refuseRow("A,0,0,0,inf,0.5,1,loading", "deflection_mm: 'inf' is not a finite number");
  refuseRow("A,0,0,0,1e999,0.5,1,loading", "deflection_mm: '1e999' is not a finite number");
  refuseRow("A,0,0,0,,0.5,1,loading", "deflection_mm: '' is not a finite number");
  refuseRow("A,0,0,0,0.1 mm,0.5,1,loading", "deflection_mm: '0.1 mm' is not a finite number");
  refuseRow("A,0,0,x,0.1,0.5,1,loading", "z_mm: 'x' is not a finite number");
  refuseRow("A,0,0,0,0.1,0.5,0.9,loading", "time_s decreases at site 'A'");
  refuseRow("A,0,0,1,0.1,0.5,1,loading", "site 'A' has another position than in its first row");
  refuseRow("A,0,0,0,0.1,0.5,1,press",
    "phase: 'press' is not known; accepted are loading, unloading, hold");
}

TEST(CurvesFile, NamesAFileThatIsNotThere)
{
  MeasuredCurves curves;
  EXPECT_EQ(readCurves("/nowhere/press.csv", curves), "/nowhere/press.csv: cannot be opened");
}

TEST(CurvesFile, ReadsTablesAsItReadsFiles)
{
  const std::vector<std::vector<std::string>> rows = {
    { "0.5", "0.1", "A", "1", "2", "3", " loading" }, { "0.625", "0.2", "A", "1", "2", "3", "" }
  };
  palpate::CurvesTable table;
  table.name = "table";
  table.tool = "flat:1.6";
  table.columns = { "force_N", "deflection_mm", "site", "x_mm", "y_mm", "z_mm", "phase" };
  table.rowCount = rows.size();
  table.field = [&rows](std::size_t row, std::size_t column) { return rows[row][column]; };
  MeasuredCurves curves;
  ASSERT_EQ(readCurves(table, curves), "");
  EXPECT_EQ(curves.file, "table");
  EXPECT_EQ(curves.toolText, "flat:1.6");
  EXPECT_TRUE(curves.synthetic.empty());
  ASSERT_EQ(curves.curves.size(), 1U);
  EXPECT_EQ(curves.curves[0].force, (std::vector<double>{ 0.5, 0.625 }));
  EXPECT_EQ(
    curves.curves[0].phase, (std::vector<CurvePhase>{ CurvePhase::Loading, CurvePhase::Unknown }));

  const auto refuse = [&curves](const palpate::CurvesTable& wrong, const std::string& error)
  {
    EXPECT_EQ(readCurves(wrong, curves), error);
    EXPECT_EQ(curves.curves.size(), 1U); // the content is unchanged
  };
  palpate::CurvesTable wrong = table;
  wrong.field = [&rows](std::size_t row, std::size_t column)
  { return row == 1 && column == 1 ? "deep" : rows[row][column]; };
  refuse(wrong, "table: row 1: deflection_mm: 'deep' is not a finite number");
  wrong = table;
  wrong.rowCount = 0;
  refuse(wrong, "table: there are no readings");
  wrong = table;
  wrong.columns.front() = "load_N";
  refuse(wrong, "table: column 'force_N' is missing");
}

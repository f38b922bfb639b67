// SPDX-License-Identifier: BSD-3-Clause
// Reads tables as in RFC 4180 and from spreadsheets. The error of an invalid table names file, line
// and column.
#include "Mechanics/Files/CsvReader.h"
#include "Mechanics/Files/CsvRow.h"
#include "Mechanics/Files/MappedFile.h"

#include "ScratchFile.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using palpate::CsvReader;
using palpate::CsvRow;
using palpate::testing::ScratchFile;

namespace
{
using Table = std::vector<std::vector<std::string>>;

/// Returns all records; after a fault only the fault.
Table readAll(const std::string& text)
{
  std::istringstream stream(text);
  CsvReader csv(stream, "t.csv");
  Table table;
  while (csv.next())
  {
    table.emplace_back();
    for (std::size_t i = 0; i < csv.size(); ++i)
    {
      table.back().emplace_back(csv.text(i));
    }
  }
  return csv.fault().empty() ? table : Table{ { csv.fault() } };
}

/// Returns the fault of a table of numbers with the columns a and b, of which b may be missing.
std::string faultOf(const std::string& text)
{
  std::istringstream stream(text);
  CsvReader csv(stream, "t.csv");
  csv.header({ "a", "b" }, 1);
  while (csv.next())
  {
    csv.number(0);
    csv.hasColumn(1) ? csv.number(1) : 0.0;
  }
  return csv.fault();
}
} // namespace

TEST(CsvReader, ReadsWhatTheStandardAndSpreadsheetsWrite)
{
  EXPECT_EQ(readAll(""), Table());
  EXPECT_EQ(readAll("\n \r\n# only this"), Table());
  EXPECT_EQ(readAll("a,b\n1,2"), (Table{ { "a", "b" }, { "1", "2" } }));
  EXPECT_EQ(readAll("\xEF\xBB\xBF"
                    "a, b \r\n\r\n#no\r\n 1 ,\t2\r\n"),
    (Table{ { "a", "b" }, { "1", "2" } }));
  EXPECT_EQ(readAll(",\n"), (Table{ { "", "" } }));
  EXPECT_EQ(readAll("\"a,b\" , \"say \"\"no\"\"\",\"\"\n"), (Table{ { "a,b", "say \"no\"", "" } }));
  EXPECT_EQ(
    readAll("\"one\r\n\r\n#two\",x\ny,z\n"), (Table{ { "one\n\n#two", "x" }, { "y", "z" } }));
  EXPECT_EQ(readAll("5\" tip,1\n"), (Table{ { "5\" tip", "1" } })) << "no quote in front";
  EXPECT_EQ(readAll("\"#a\",b\n"), (Table{ { "#a", "b" } }));
}

TEST(CsvReader, BrokenFilesAreNamedWithLineAndColumn)
{
  EXPECT_EQ(faultOf("a,b\n1,2\n"), "");
  EXPECT_EQ(faultOf("b,other,a\n1,\"x,y\",2\n"), "");
  EXPECT_EQ(faultOf(""), "t.csv:0: there is no line with the names of the columns");
  EXPECT_EQ(faultOf("\n# a,b\n"), "t.csv:2: there is no line with the names of the columns");
  EXPECT_EQ(faultOf("b,c\n1,2\n"), "t.csv:1: column 'a' is missing");
  EXPECT_EQ(faultOf("a,b,a\n1,2,3\n"), "t.csv:1: column 'a' occurs twice");
  EXPECT_EQ(faultOf("a,b\n1,2\n\n1\n"), "t.csv:4: has 1 fields instead of 2");
  EXPECT_EQ(faultOf("a\n1,2\n"), "t.csv:2: has 2 fields instead of 1");
  for (const char* const number : { "", "x", "1 2", "nan", "-inf", "1e999", "0x1", "1,", "1;5" })
  {
    const std::string fault = faultOf("a,b\n1,2\n0,\"" + std::string(number) + "\"\n");
    EXPECT_EQ(fault, "t.csv:3: b: '" + std::string(number) + "' is not a finite number");
  }
  EXPECT_EQ(faultOf("a,b\n1,\"2\n3,4\n"), "t.csv:2: a quote is not closed");
  EXPECT_EQ(faultOf("a,b\n1,\"2\"3\n"), "t.csv:2: field 2 continues after its closing quote");
  EXPECT_EQ(faultOf("a,c\n1,\"2\n\"\nx,4\n"), "t.csv:4: a: 'x' is not a finite number");
}

TEST(CsvReader, SemicolonsAndDecimalCommas)
{
  EXPECT_EQ(readAll("a;b,c\n1;\"2;3\"\n"), (Table{ { "a", "b,c" }, { "1", "2;3" } }));
  EXPECT_EQ(readAll("\"a;b\",c\n1,2;3\n"), (Table{ { "a;b", "c" }, { "1", "2;3" } }));
  const auto numbers = [](const std::string& text)
  {
    std::istringstream stream(text);
    CsvReader csv(stream, "t.csv");
    csv.header({ "a", "b" }, 2);
    std::vector<double> read;
    while (csv.next())
    {
      read.push_back(csv.number(0));
      read.push_back(csv.number(1));
    }
    EXPECT_EQ(csv.fault(), "");
    return read;
  };
  EXPECT_EQ(numbers("a;b\n0,5;-1,25e-3\n2;,5\n"), (std::vector<double>{ 0.5, -1.25e-3, 2.0, 0.5 }));
  EXPECT_EQ(numbers("a;b\n0.5;2\n"), (std::vector<double>{ 0.5, 2.0 }));
  EXPECT_EQ(faultOf("a;b\n1.234,5;2\n"), "t.csv:2: a: '1.234,5' is not a finite number");
  EXPECT_EQ(faultOf("a;b\n1,2,3;2\n"), "t.csv:2: a: '1,2,3' is not a finite number");
  EXPECT_EQ(faultOf("a;b\n0,5;2\n1;2.5\n"),
    "t.csv:3: '2.5' has another decimal mark than the numbers before");
  EXPECT_EQ(faultOf("a,b\n\"0,5\",2\n"), "t.csv:2: a: '0,5' is not a finite number");
}

TEST(CsvReader, TheFirstFaultIsKeptAndEndsTheReading)
{
  std::istringstream stream("a\nx\n1\n");
  CsvReader csv(stream, "t.csv");
  ASSERT_TRUE(csv.header({ "a" }, 1));
  ASSERT_TRUE(csv.next());
  EXPECT_EQ(csv.number(0), 0.0);
  EXPECT_FALSE(csv.fail("later"));
  EXPECT_FALSE(csv.next());
  EXPECT_EQ(csv.fault(), "t.csv:2: a: 'x' is not a finite number");
}

TEST(CsvReader, OfSomeColumnsAllOrNone)
{
  const auto fault = [](const std::string& names)
  {
    std::istringstream stream(names + "\n");
    CsvReader csv(stream, "t.csv");
    csv.header({ "a", "x", "y" }, 1);
    const bool has = csv.hasColumns(1, 3);
    return csv.fault() + (has ? "has" : "");
  };
  EXPECT_EQ(fault("a"), "");
  EXPECT_EQ(fault("y,a,x"), "has");
  EXPECT_EQ(fault("a,y"), "t.csv:1: column 'x' is missing");
}

TEST(CsvReader, CommentsAreSeenAndMayBeFaults)
{
  std::istringstream stream("#  key :  a: b ;;\n#none\na\n1\n# wrong\n2\n");
  CsvReader csv(stream, "t.csv");
  std::vector<std::string> seen;
  csv.comment = [&seen](std::string_view text)
  {
    const palpate::CsvComment comment(text);
    seen.push_back(std::string(comment.key) + "=" + std::string(comment.value));
    return std::string(text == "wrong" ? "no comment" : "");
  };
  while (csv.next())
  {
  }
  EXPECT_EQ(seen, (std::vector<std::string>{ "key=a: b", "none=", "wrong=" }));
  EXPECT_EQ(csv.fault(), "t.csv:5: no comment");
}

TEST(CsvReader, TellsALastLineWithoutAnEnd)
{
  for (const bool ends : { true, false })
  {
    std::istringstream stream(std::string("1\n2") + (ends ? "\n" : ""));
    CsvReader csv(stream, "t.csv");
    EXPECT_TRUE(csv.next() && csv.endsLine());
    EXPECT_TRUE(csv.next());
    EXPECT_EQ(csv.endsLine(), ends);
  }
}

TEST(CsvReader, NamesAFileThatCannotBeRead)
{
  CsvReader missing("/nowhere/t.csv");
  EXPECT_FALSE(missing.next());
  EXPECT_EQ(missing.fault(), "/nowhere/t.csv: cannot be opened");
  CsvReader folder(::testing::TempDir());
  EXPECT_FALSE(folder.next());
  EXPECT_EQ(folder.fault(), ::testing::TempDir() + ": cannot be read to its end");
}

TEST(CsvRow, IsReadBackAsItWas)
{
  std::mt19937 random(3);
  const std::string letters = "ab,\"\n#; ";
  std::string text;
  Table written;
  for (int row = 0; row < 200; ++row)
  {
    // the reader removes blanks at the ends of a cell, so each cell begins and ends with a letter
    written.push_back({ "x" });
    CsvRow line;
    for (int i = 0; i < 5; ++i)
    {
      written.back().back() += letters[random() % letters.size()];
    }
    written.back().back() += "y";
    line.text(written.back().back());
    written.back().push_back(palpate::shortestDecimals(1.0 / (1 + row)));
    line.number(1.0 / (1 + row));
    text += line.line();
  }
  EXPECT_EQ(readAll(text), written);
}

TEST(MappedFile, HasTheBytesOfTheFile)
{
  const ScratchFile scratch(".bin");
  palpate::MappedFile file;
  EXPECT_EQ(file.open("/nowhere/body"), "cannot open '/nowhere/body': No such file or directory");
  std::ofstream(scratch.path()) << "";
  EXPECT_EQ(file.open(scratch.path()), "");
  EXPECT_EQ(file.size(), 0U);
  std::ofstream(scratch.path()) << "bytes";
  EXPECT_EQ(file.open(scratch.path()), "");
  EXPECT_EQ(std::string(file.bytes(), file.bytes() + file.size()), "bytes");
  EXPECT_EQ(file.open(::testing::TempDir()), "");
  EXPECT_EQ(file.bytes(), nullptr);
}

// SPDX-License-Identifier: BSD-3-Clause
// Written files are read with the same bits. Files of other programs are read. For invalid files
// the error names the line.
#include "Haptics/Devices/TrajectoryFile.h"

#include "FileSizeLimit.h"
#include "ScratchFile.h"
#include "Mechanics/Numerics/Constants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace trajectory_file
{
using Eigen::Vector3d;
using namespace palpate::testing;
using palpate::ContactState;
using palpate::NotANumber;
using palpate::Tick;
using palpate::Trajectory;
using palpate::TrajectoryRow;

namespace
{
/// A random finite double: all exponents, both signs, subnormal numbers, -0.
double anyNumber(std::mt19937_64& random)
{
  for (;;)
  {
    const std::uint64_t bits = random() % 50 == 0 ? 1ULL << 63U : random();
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof(value));
    if (std::isfinite(value))
    {
      return value;
    }
  }
}

Vector3d anyVector(std::mt19937_64& random)
{
  const double x = anyNumber(random);
  const double y = anyNumber(random);
  return { x, y, anyNumber(random) };
}

Trajectory anyTrajectory(bool hasContact, bool hasDevice)
{
  std::mt19937_64 random(5);
  Trajectory trajectory;
  trajectory.hasContact = hasContact;
  trajectory.hasDevice = hasDevice;
  trajectory.hasMemory = hasContact && hasDevice;
  double time = -1.0;
  for (int i = 0; i < 500; ++i)
  {
    TrajectoryRow row;
    row.time = time;
    time += std::ldexp(static_cast<double>(random() >> 11U), -60);
    row.tip = anyVector(random);
    if (hasContact)
    {
      row.contact.contactPoint = anyVector(random);
      row.contact.deflection = anyNumber(random);
      row.contact.normalForce = anyNumber(random);
      row.contact.friction = anyVector(random);
      row.idealForce = anyNumber(random);
      row.contact.memory = trajectory.hasMemory ? anyNumber(random) : 0.0;
      row.contact.state = static_cast<ContactState>(random() % 6);
    }
    if (hasDevice)
    {
      row.sample.position = anyVector(random);
      row.sample.velocity = anyVector(random);
      row.sample.buttons = static_cast<std::uint32_t>(random());
      row.sample.valid = random() % 2 == 0;
      row.sample.fresh = random() % 2 == 0;
      row.sentForce = anyVector(random);
      row.isTaken = random() % 2 == 0;
    }
    trajectory.rows.push_back(row);
  }
  return trajectory;
}

bool same(double a, double b)
{
  return std::memcmp(&a, &b, sizeof(a)) == 0;
}

bool same(const Vector3d& a, const Vector3d& b)
{
  return same(a.x(), b.x()) && same(a.y(), b.y()) && same(a.z(), b.z());
}

bool same(const TrajectoryRow& a, const TrajectoryRow& b)
{
  return same(a.time, b.time) && same(a.tip, b.tip) &&
    same(a.contact.contactPoint, b.contact.contactPoint) &&
    same(a.contact.deflection, b.contact.deflection) &&
    same(a.contact.normalForce, b.contact.normalForce) &&
    same(a.contact.memory, b.contact.memory) && same(a.contact.friction, b.contact.friction) &&
    same(a.idealForce, b.idealForce) && a.contact.state == b.contact.state &&
    same(a.sample.position, b.sample.position) && same(a.sample.velocity, b.sample.velocity) &&
    a.sample.buttons == b.sample.buttons && a.sample.valid == b.sample.valid &&
    a.sample.fresh == b.sample.fresh && same(a.sentForce, b.sentForce) && a.isTaken == b.isTaken;
}

std::string firstLine(const std::string& path)
{
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

std::string faultOf(const std::string& text)
{
  std::istringstream stream(text);
  Trajectory untouched;
  untouched.rows.resize(3);
  untouched.hasContact = true;
  const std::string fault = palpate::readTrajectory(stream, "t.csv", untouched);
  if (!fault.empty())
  {
    EXPECT_EQ(untouched.rows.size(), 3U); // a failed reading changes nothing
    EXPECT_TRUE(untouched.hasContact);
  }
  return fault;
}

const std::string Head = "time_s,tip_x_mm,tip_y_mm,tip_z_mm\n";
const std::string Columns =
  "time_s,tip_x_mm,tip_y_mm,tip_z_mm,contact_x_mm,contact_y_mm,contact_z_mm,deflection_mm,"
  "normal_force_N,friction_x_N,friction_y_N,friction_z_N,ideal_force_N,state";
} // namespace

TEST(TrajectoryFile, ReadsWhatItWroteToTheSameBits)
{
  for (const bool hasContact : { false, true })
  {
    for (const bool hasDevice : { false, true })
    {
      const ScratchFile file(".csv");
      const Trajectory written = anyTrajectory(hasContact, hasDevice);
      ASSERT_EQ(palpate::writeTrajectory(file.path(), written), "");
      Trajectory read;
      ASSERT_EQ(palpate::readTrajectory(file.path(), read), "");
      EXPECT_EQ(read.hasContact, hasContact);
      EXPECT_EQ(read.hasDevice, hasDevice);
      EXPECT_EQ(read.hasMemory, written.hasMemory);
      ASSERT_EQ(read.rows.size(), written.rows.size());
      for (std::size_t i = 0; i < read.rows.size(); ++i)
      {
        ASSERT_TRUE(same(read.rows[i], written.rows[i])) << i;
      }
      EXPECT_EQ(firstLine(file.path()) == Columns, hasContact && !hasDevice);
      EXPECT_EQ(firstLine(file.path()).rfind(Columns, 0) == 0, hasContact);
    }
  }
}

TEST(TrajectoryFile, NamesBodyToolAndMaterialFromTheirTimesOn)
{
  using palpate::SetupPart;
  palpate::RecordedSetup setup;
  setup[SetupPart::Body] = "liver, left:\nlobe.stl"; // no line break reaches the file
  setup[SetupPart::Tool] = "sphere:6.35";
  setup[SetupPart::Material] = "E = 0.05 MPa, nu = 0.45";
  palpate::RecordedSetups setups;
  setups.add(0.0, setup);
  setup[SetupPart::Tool] = "flat:1.6";
  setups.add(0.25, setup);
  setups.add(0.3, setup); // no change
  setup[SetupPart::Tool] = "cone:60";
  setup[SetupPart::Material] = "E = 1 MPa, nu = 0.45";
  setups.add(0.5, setup);
  setups.add(7.0, palpate::RecordedSetup()); // after the last tick
  std::vector<Tick> ticks(4);
  const double times[] = { 0.1, 0.2, 0.3, 0.6 };
  for (std::size_t i = 0; i < ticks.size(); ++i)
  {
    ticks[i].time = times[i];
  }
  const ScratchFile file(".csv");
  ASSERT_EQ(palpate::writeTrajectory(file.path(), ticks, setups), "");
  EXPECT_EQ(firstLine(file.path()), Columns); // programs that read the first line find the names
  std::ifstream stream(file.path());
  std::string line;
  std::getline(stream, line);
  for (const char* expected : { "# body: liver, left: lobe.stl", "# tool: sphere:6.35",
         "# material: E = 0.05 MPa, nu = 0.45", "# tool from 0.25 s: flat:1.6",
         "# tool from 0.5 s: cone:60", "# material from 0.5 s: E = 1 MPa, nu = 0.45" })
  {
    std::getline(stream, line);
    EXPECT_EQ(line, expected);
  }
  std::getline(stream, line);
  EXPECT_EQ(line.front(), '0');
  Trajectory read;
  ASSERT_EQ(palpate::readTrajectory(file.path(), read), "");
  EXPECT_EQ(read.rows.size(), ticks.size());
  const auto toolAt = [&read](double time) { return (*read.setups.at(time))[SetupPart::Tool]; };
  EXPECT_EQ(toolAt(-1.0), "sphere:6.35");
  EXPECT_EQ(toolAt(0.249), "sphere:6.35");
  EXPECT_EQ(toolAt(0.25), "flat:1.6");
  EXPECT_EQ(toolAt(0.6), "cone:60");
  EXPECT_EQ((*read.setups.at(0.4))[SetupPart::Material], "E = 0.05 MPa, nu = 0.45");
  EXPECT_EQ(read.setups.lines().size(), 6U);
}

TEST(TrajectoryFile, OldFilesAndRemarksOfOthersNameNoSetup)
{
  for (const char* text :
    { "", "# tools: none\n# from 3 s\n# tool from soon s: flat:1\n#\n#tool\n" })
  {
    std::istringstream stream(text + Head + text + "0,1,2,3\n" + text + "1,1,2,3\n");
    Trajectory read;
    EXPECT_EQ(palpate::readTrajectory(stream, "t.csv", read), "");
    EXPECT_EQ(read.rows.size(), 2U);
    EXPECT_TRUE(read.setups.isEmpty());
    EXPECT_EQ(palpate::replayInWords(read.setups, 0.0, {}),
      "Replay: the record names neither tool nor material");
  }
}

TEST(TrajectoryFile, AReplayNamesWhatDiffers)
{
  using palpate::SetupPart;
  std::istringstream stream(
    "# tool: sphere:1.6\n" + Head + "# material: E = 1 MPa, nu = 0.5\n0,1,2,3\n");
  Trajectory read;
  ASSERT_EQ(palpate::readTrajectory(stream, "t.csv", read), "");
  palpate::RecordedSetup here;
  here[SetupPart::Body] = "ball.stl"; // not recorded: not compared
  here[SetupPart::Tool] = "sphere:1.6";
  here[SetupPart::Material] = "E = 1 MPa, nu = 0.5";
  EXPECT_EQ(palpate::replayInWords(read.setups, 0.0, here),
    "Replay: recorded with tool sphere:1.6, material E = 1 MPa, nu = 0.5");
  here[SetupPart::Tool] = "flat:2";
  EXPECT_EQ(palpate::replayInWords(read.setups, 0.0, here),
    "Replay: recorded with another setup: tool sphere:1.6 (here flat:2)");
}

TEST(TrajectoryFile, TicksOfAServoStep)
{
  std::vector<Tick> ticks(4);
  for (std::size_t i = 0; i < ticks.size(); ++i)
  {
    ticks[i].time = 0.001 * static_cast<double>(i);
    ticks[i].tip = Vector3d(0.1, -0.2, 1.0 / 3.0);
    ticks[i].contact.state = ContactState::Stick;
    ticks[i].contact.force = Vector3d(0.0, 3.0, 4.0);
    ticks[i].contact.friction = Vector3d(0.0, 3.0, 0.0);
    ticks[i].contact.normalForce = 4.0;
    ticks[i].contact.deflection = 0.7;
    ticks[i].contact.contactPoint = Vector3d(5.0, 6.0, 1e-300);
  }
  ticks[2] = Tick(); // no valid sample
  ticks[2].time = 0.002;
  ticks[2].contact.state = ContactState::Invalid;
  ticks[3].tip.y() = NotANumber;
  const ScratchFile file(".csv");
  ASSERT_EQ(palpate::writeTrajectory(file.path(), ticks), "");
  std::ifstream stream(file.path());
  std::ostringstream text;
  text << stream.rdbuf();
  EXPECT_EQ(text.str(),
    Columns +
      "\n0,0.1,-0.2,0.3333333333333333,5,6,1e-300,0.7,4,0,3,0,5,1\n"
      "0.001,0.1,-0.2,0.3333333333333333,5,6,1e-300,0.7,4,0,3,0,5,1\n"
      "0.002,0,0,0,0,0,0,0,0,0,0,0,0,5\n"
      "0.003,0,0,0,0,0,0,0,0,0,0,0,0,5\n");
  Trajectory read;
  ASSERT_EQ(palpate::readTrajectory(file.path(), read), "");
  EXPECT_TRUE(read.rows[1].hasTip());
  EXPECT_FALSE(read.rows[2].hasTip());
  EXPECT_FALSE(read.rows[3].hasTip());
  EXPECT_EQ(read.rows[1].idealForce, 5.0);
  EXPECT_FALSE(read.hasMemory);
}

// While the scene changes, the force of the tick is a combination of both scenes. The row contains
// the contact of the new scene, so that its columns satisfy one law: F² = N² + f².
TEST(TrajectoryFile, ARowDuringAChangeIsThatOfTheNewScene)
{
  std::vector<Tick> ticks(1);
  ticks[0].contact.state = ContactState::Slide;
  ticks[0].contact.force = Vector3d(0.0, 3.0, 4.0);
  ticks[0].contact.friction = Vector3d(0.0, 3.0, 0.0);
  ticks[0].contact.normalForce = 4.0;
  ticks[0].idealForce = Vector3d(0.0, 1.0, 1.0);
  ticks[0].sceneShare = 0.25;
  const ScratchFile file(".csv");
  ASSERT_EQ(palpate::writeTrajectory(file.path(), ticks), "");
  Trajectory read;
  ASSERT_EQ(palpate::readTrajectory(file.path(), read), "");
  ASSERT_EQ(read.rows.size(), 1U);
  EXPECT_EQ(read.rows[0].idealForce, 5.0);
  EXPECT_EQ(read.rows[0].contact.normalForce, 4.0);
  EXPECT_EQ(read.rows[0].contact.friction, Vector3d(0.0, 3.0, 0.0));
}

TEST(TrajectoryFile, TellsMemoryWhereTheBodyRelaxes)
{
  std::vector<Tick> ticks(2);
  ticks[1].time = 0.001;
  ticks[1].contact.state = ContactState::Slide;
  ticks[1].contact.force = Vector3d(0.0, 0.0, 4.0);
  ticks[1].contact.normalForce = 4.0;
  ticks[1].contact.memory = -1.25;
  const ScratchFile file(".csv");
  ASSERT_EQ(palpate::writeTrajectory(file.path(), ticks), "");
  EXPECT_EQ(firstLine(file.path()), Columns + ",memory_force_N");
  Trajectory read;
  ASSERT_EQ(palpate::readTrajectory(file.path(), read), "");
  EXPECT_TRUE(read.hasMemory);
  EXPECT_EQ(read.rows[0].contact.memory, 0.0);
  EXPECT_EQ(read.rows[1].contact.memory, -1.25);
  EXPECT_EQ(faultOf(Columns + ",memory_force_N\n0,0,0,0,0,0,0,0,0,0,0,0,0,5,nan\n"),
    "t.csv:2: memory_force_N: 'nan' is not a finite number");
}

TEST(TrajectoryFile, FilesOfOthers)
{
  std::istringstream stream("\xEF\xBB\xBF# exported\r\n\r\n"
                            "\"tip_z_mm\" , \"remark, free\",\"time_s\",tip_x_mm,\"tip_y_mm\"\r\n"
                            "\"3\",\"a, b\",0.5,1e0, 2 \r\n"
                            "# in between\r\n"
                            "-0.3e1,,0.5,\"1\",2\r\n");
  Trajectory read;
  ASSERT_EQ(palpate::readTrajectory(stream, "t.csv", read), "");
  EXPECT_FALSE(read.hasContact);
  EXPECT_FALSE(read.hasDevice);
  ASSERT_EQ(read.rows.size(), 2U);
  EXPECT_EQ(read.rows[0].tip, Vector3d(1, 2, 3));
  EXPECT_EQ(read.rows[1].tip, Vector3d(1, 2, -3));
  EXPECT_EQ(read.rows[1].time, 0.5);
  EXPECT_TRUE(read.rows[1].hasTip());
}

TEST(TrajectoryFile, ErrorsNameFileAndLine)
{
  EXPECT_EQ(faultOf(Head + "0,1,2,3\n1,1,2,3\n"), "");
  EXPECT_EQ(faultOf(""), "t.csv:0: there is no line with the names of the columns");
  EXPECT_EQ(faultOf(Head), "t.csv:1: there are no lines with numbers");
  EXPECT_EQ(faultOf("time_s,tip_x_mm,tip_z_mm\n0,1,2\n"), "t.csv:1: column 'tip_y_mm' is missing");
  EXPECT_EQ(faultOf("time_s,tip_x_mm,tip_y_mm,tip_z_mm,state\n"),
    "t.csv:1: column 'contact_x_mm' is missing");
  EXPECT_EQ(faultOf("time_s,tip_x_mm,tip_y_mm,tip_z_mm,device_x_m\n"),
    "t.csv:1: column 'device_y_m' is missing");
  EXPECT_EQ(faultOf("time_s,tip_x_mm,tip_y_mm,tip_z_mm,tip_x_mm\n"),
    "t.csv:1: column 'tip_x_mm' occurs twice");
  EXPECT_EQ(faultOf(Head + "0,1,2,3\n0,1,2\n"), "t.csv:3: has 3 fields instead of 4");
  EXPECT_EQ(faultOf(Head + "0,1,2,3,4\n"), "t.csv:2: has 5 fields instead of 4");
  EXPECT_EQ(faultOf(Head + "0,1,nan,3\n"), "t.csv:2: tip_y_mm: 'nan' is not a finite number");
  EXPECT_EQ(faultOf(Head + "0,1,2,inf\n"), "t.csv:2: tip_z_mm: 'inf' is not a finite number");
  EXPECT_EQ(faultOf(Head + "0,1,2,\n"), "t.csv:2: tip_z_mm: '' is not a finite number");
  EXPECT_EQ(faultOf(Head + "0,1,2,3x\n"), "t.csv:2: tip_z_mm: '3x' is not a finite number");
  EXPECT_EQ(faultOf(Head + "0,1e999,2,3\n"), "t.csv:2: tip_x_mm: '1e999' is not a finite number");
  EXPECT_EQ(faultOf(Head + "\n1,1,2,3\n0.5,1,2,3\n"), "t.csv:4: time_s decreases");

  const std::string whole = Columns + "\n";
  EXPECT_EQ(faultOf(whole + "0,0,0,0,0,0,0,0,0,0,0,0,0,6\n"), "");
  for (const char* const state : { "7", "-1", "0.5" })
  {
    EXPECT_EQ(faultOf(whole + "0,0,0,0,0,0,0,0,0,0,0,0,0," + state + "\n"),
      "t.csv:2: state must be a whole number from 0 to 6");
  }
  const std::string device = "time_s,tip_x_mm,tip_y_mm,tip_z_mm,device_x_m,device_y_m,device_z_m,"
                             "velocity_x_m_s,velocity_y_m_s,velocity_z_m_s,buttons,valid,fresh,"
                             "sent_x_N,sent_y_N,sent_z_N,taken\n0,0,0,0,0,0,0,0,0,0,";
  EXPECT_EQ(faultOf(device + "4294967295,1,0,0,0,0,1\n"), "");
  EXPECT_EQ(faultOf(device + "4294967296,1,0,0,0,0,1\n"),
    "t.csv:2: buttons must be a whole number of 32 bits");
  EXPECT_EQ(faultOf(device + "0,1,2,0,0,0,1\n"), "t.csv:2: fresh must be 0 or 1");

  Trajectory none;
  EXPECT_EQ(palpate::readTrajectory("/nowhere/t.csv", none), "/nowhere/t.csv: cannot be opened");
}

TEST(TrajectoryFile, WritesNothingThatCannotBeRead)
{
  const ScratchFile file(".csv");
  Trajectory trajectory = anyTrajectory(true, false);
  trajectory.rows[7].contact.deflection = NotANumber;
  EXPECT_EQ(palpate::writeTrajectory(file.path(), trajectory),
    "cannot write '" + file.path() + "': row 7: deflection_mm is not finite");
  EXPECT_FALSE(std::ifstream(file.path()).good());
  trajectory = anyTrajectory(false, false);
  std::swap(trajectory.rows[8], trajectory.rows[9]);
  EXPECT_EQ(palpate::writeTrajectory(file.path(), trajectory),
    "cannot write '" + file.path() + "': row 9: time_s decreases");
  EXPECT_EQ(palpate::writeTrajectory("/nowhere/t.csv", Trajectory()),
    "cannot write '/nowhere/t.csv': No such file or directory");
}

TEST(TrajectoryFile, OnAFullDiskTheFirstRowsAreKeptAndTheOldFileStands)
{
  const ScratchFile file(".csv");
  const std::string part = file.path() + ".part";
  const Trajectory old = anyTrajectory(false, false);
  ASSERT_EQ(palpate::writeTrajectory(file.path(), old), "");
  Trajectory trajectory = anyTrajectory(true, true);
  palpate::RecordedSetup setup; // two lines below the names of the columns
  setup[palpate::SetupPart::Body] = "ball.stl";
  setup[palpate::SetupPart::Tool] = "flat:1";
  trajectory.setups.add(0.0, setup);
  for (const std::size_t room :
    { 300U, 5000U }) // bytes; space for the names of the columns only, or also for some rows
  {
    std::string error;
    {
      const palpate::testing::FileSizeLimit full(room);
      error = palpate::writeTrajectory(file.path(), trajectory);
    }
    EXPECT_EQ(error.find("cannot write '" + file.path() + "': File too large"), 0U) << error;
    Trajectory read;
    ASSERT_EQ(palpate::readTrajectory(file.path(), read), "");
    EXPECT_EQ(read.rows.size(), old.rows.size());
    const bool isKept = error.find(part) != std::string::npos;
    EXPECT_EQ(isKept, room > 1000);
    EXPECT_EQ(std::ifstream(part).good(), isKept);
    if (isKept)
    {
      ASSERT_EQ(palpate::readTrajectory(part, read), "");
      EXPECT_GT(read.rows.size(), 2U);
      EXPECT_LT(read.rows.size(), trajectory.rows.size());
      EXPECT_NE(error.find("the first " + std::to_string(read.rows.size()) + " of " +
                  std::to_string(trajectory.rows.size()) + " rows"),
        std::string::npos)
        << error;
      for (std::size_t i = 0; i < read.rows.size(); ++i)
      {
        EXPECT_EQ(read.rows[i].time, trajectory.rows[i].time);
        EXPECT_EQ(read.rows[i].tip, trajectory.rows[i].tip);
        EXPECT_EQ(read.rows[i].sentForce, trajectory.rows[i].sentForce);
      }
    }
  }
  std::remove(part.c_str());
  EXPECT_EQ(palpate::writeTrajectory("/dev/full", trajectory),
    "cannot write '/dev/full': No space left on device");
}
} // namespace trajectory_file

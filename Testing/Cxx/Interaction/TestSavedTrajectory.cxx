// SPDX-License-Identifier: BSD-3-Clause
// Replays the recorded hands in Data/Determinism over the saved body there. The resulting files
// must be the same, byte by byte, for any version of VTK; numbers in them are read back with the
// same bits. The only exception is the rounding of functions of the C library such as pow, which
// differs on a processor without FMA. In that case the numbers are compared to 1e-12.
// palpateInteractionTests TestSavedTrajectory DATA compares
// palpateInteractionTests TestSavedTrajectory FOLDER --write writes new body and files
#include "EventfulPath.h"
#include "Response/FlatBodyConversion.h"
#include "Response/FilterChecks.h"
#include "Haptics/Servo/ServoStep.h"
#include "Haptics/Devices/TrajectoryFile.h"

#include "vtkHapticSession.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

namespace
{
using namespace palpate::testing;

constexpr double TickRate = 200.0; // Hz, so that the files are small

struct Feel
{
  const char* file;
  palpate::ContactSurface surface;
  palpate::ForceForm form;
  palpate::FrictionModel friction;
};

constexpr Feel Feels[] = {
  { "facets.csv", palpate::ContactSurface::Facets, palpate::ForceForm::NormalizedDirection,
    palpate::FrictionModel::ElastoPlastic },
  { "smooth.csv", palpate::ContactSurface::Smooth, palpate::ForceForm::EnergyConsistent,
    palpate::FrictionModel::ShapeDerived },
};

vtkSmartPointer<vtkHapticSession> sessionOn(vtkPolyData* body, const Feel& feel)
{
  auto session = vtkSmartPointer<vtkHapticSession>::New();
  session->SetBody(body);
  session->SetRate(TickRate);
  session->GetSettings()->SetContactSurface(static_cast<int>(feel.surface));
  session->GetSettings()->SetForceForm(static_cast<int>(feel.form));
  session->GetSettings()->SetFrictionModel(static_cast<int>(feel.friction));
  session->GetSettings()->SetFrictionCoefficient(0.5);
  session->GetSettings()->SetPoissonRatio(0.3);
  return session;
}

std::string textOf(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Returns the trajectory of `session` over Duration as the text of a file, which remains at
/// `path`.
std::string fileOf(vtkHapticSession* session, const std::string& path)
{
  PALPATE_CHECK(session->Start());
  session->Step(Duration);
  PALPATE_CHECK(palpate::writeTrajectory(path, session->GetRecorder()->GetTicks()).empty());
  return textOf(path);
}

/// Prints the first difference.
void tellDifference(const std::string& name, const std::string& found, const std::string& stored)
{
  std::istringstream one(found);
  std::istringstream other(stored);
  std::string left;
  std::string right;
  for (int line = 1; std::getline(one, left) && std::getline(other, right); ++line)
  {
    if (left != right)
    {
      std::cerr << name << ":" << line << ": is\n" << left << "\ninstead of\n" << right << "\n";
      return;
    }
  }
  std::cerr << name << ": another number of lines\n";
}

/// Returns a line with a hash (FNV-1a) of the last bits of the C library's functions that a tick
/// calls.
std::string roundingOfLibrary()
{
  std::uint64_t digest = 14695981039346656037ULL;
  for (int i = 1; i <= 20000; ++i)
  {
    const double x = 2.3e-4 * i;
    for (const double y : { std::pow(x, 1.37), std::exp(-x), std::expm1(-x), std::atan2(x, 0.7) })
    {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &y, sizeof bits);
      digest = (digest ^ bits) * 1099511628211ULL;
    }
  }
  return std::to_string(digest) + "\n";
}

/// Returns true if the trajectories are equal except for the different rounding of these functions,
/// half a unit in the last place each.
bool agree(const std::string& found, const std::string& stored)
{
  std::istringstream one(found);
  std::istringstream other(stored);
  palpate::Trajectory left;
  palpate::Trajectory right;
  bool good = palpate::readTrajectory(one, "found", left).empty() &&
    palpate::readTrajectory(other, "stored", right).empty() &&
    left.rows.size() == right.rows.size();
  for (std::size_t i = 0; good && i < left.rows.size(); ++i)
  {
    const palpate::TrajectoryRow& a = left.rows[i];
    const palpate::TrajectoryRow& b = right.rows[i];
    constexpr double Off = 1e-12;
    good = a.contact.state == b.contact.state && (a.tip - b.tip).norm() <= Off * Radius &&
      (a.contact.contactPoint - b.contact.contactPoint).norm() <= Off * Radius &&
      std::abs(a.contact.normalForce - b.contact.normalForce) <= Off * b.contact.normalForce &&
      (a.contact.friction - b.contact.friction).norm() <= Off * b.contact.normalForce;
  }
  return good;
}

/// Checks that the file contains every event of a contact.
void checkEvents(vtkHapticSession* session)
{
  std::set<int> states;
  std::set<std::int32_t> triangles;
  for (const palpate::Tick& tick : session->GetRecorder()->GetTicks())
  {
    states.insert(static_cast<int>(tick.contact.state));
    triangles.insert(tick.contact.triangle);
  }
  PALPATE_CHECK((states == std::set<int>{ 0, 1, 2, 3, 4 }));
  PALPATE_CHECK(triangles.size() > 30);
}

void compare(vtkPolyData* body, const std::string& data)
{
  const bool sameLibrary = roundingOfLibrary() == textOf(data + "/library.txt");
  for (const Feel& feel : Feels)
  {
    const std::string file = data + "/" + feel.file;
    const auto session = sessionOn(body, feel);
    PALPATE_CHECK(session->GetDevice()->Open("replay:" + file));
    const std::string scratch = std::string("TestSavedTrajectory-") + feel.file;
    const std::string found = fileOf(session, scratch);
    std::remove(scratch.c_str());
    checkEvents(session);
    const std::string stored = textOf(file);
    const bool same =
      stored.size() > 10000 && (sameLibrary ? found == stored : agree(found, stored));
    PALPATE_CHECK(same);
    if (!same)
    {
      tellDifference(feel.file, found, stored);
    }
  }
}

int write(const std::string& folder)
{
  const Body body = openBall();
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName((folder + "/body.vtp").c_str());
  writer->SetInputData(body);
  writer->SetDataModeToBinary();
  writer->SetCompressorTypeToZLib();
  PALPATE_CHECK(writer->Write() == 1);
  PALPATE_CHECK(palpate::writeFlatBody(body, "Response", folder + "/body.palpate").empty());
  for (const Feel& feel : Feels)
  {
    const auto session = sessionOn(body, feel);
    session->GetDevice()->SetPath(handPath());
    fileOf(session, folder + "/" + feel.file);
  }
  std::ofstream(folder + "/library.txt") << roundingOfLibrary();
  return palpate::testing::result();
}
} // namespace

int TestSavedTrajectory(int argc, char* argv[])
{
  const std::string data = argv[1];
  if (argc > 2 && std::string(argv[2]) == "--write")
  {
    return write(data);
  }
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName((data + "/body.vtp").c_str());
  reader->Update();
  compare(reader->GetOutput(), data);
  std::string error;
  const auto flat = palpate::readFlatBody(data + "/body.palpate", "Response", error);
  PALPATE_CHECK(flat != nullptr && error.empty());
  compare(flat, data);
  return palpate::testing::result();
}

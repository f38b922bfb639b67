// SPDX-License-Identifier: BSD-3-Clause
#include "RelaxationPaths.h"

#include "Mechanics/Files/CsvReader.h"
#include "RelaxationFoundation.h"
#include "SampleSeries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>
#include <utility>

namespace palpate::testing
{
namespace
{
constexpr std::array<double, 3> Exponents = { 1.0, 1.5, 2.0 };
constexpr std::size_t TrueElements = 1000; // 400 and 4000 differ by 2e-6 of F_max
constexpr int TrueSubsteps = 4;            // 16 differ by 4e-6

using Knots = std::vector<std::pair<double, double>>; // s, mm

/// Depths at each tick after 0, linear between the knots.
std::vector<double> along(const Knots& knots)
{
  std::vector<double> depths;
  const auto count = static_cast<int>(std::lround(knots.back().first / RelaxationPeriod));
  std::size_t i = 0;
  for (int tick = 1; tick <= count; ++tick)
  {
    const double t = tick * RelaxationPeriod;
    while (i + 2 < knots.size() && t > knots[i + 1].first)
    {
      ++i;
    }
    const auto& [from, low] = knots[i];
    const auto& [to, high] = knots[i + 1];
    depths.push_back(low + (high - low) * (t - from) / (to - from));
  }
  return depths;
}

std::vector<double> sine(double seconds, int times)
{
  std::vector<double> depths;
  const auto count = static_cast<int>(std::lround(times * seconds / RelaxationPeriod));
  for (int tick = 1; tick <= count; ++tick)
  {
    depths.push_back(0.5 - 0.5 * std::cos(6.283185307179586 * tick * RelaxationPeriod / seconds));
  }
  return depths;
}

/// Presses of random depth and speed that return to a dent before it has recovered.
Knots randomPresses()
{
  std::mt19937 random(8);
  const auto share = [&random] { return (random() % 10000U + 0.5) / 10000.0; };
  Knots knots{ { 0.0, 0.0 } };
  while (knots.back().first < 2.0)
  {
    const double time = knots.back().first + 0.02 + 0.2 * share() * share();
    const bool isIn = knots.size() % 2 == 1;
    knots.emplace_back(time, isIn ? 0.2 + 0.8 * share() : 0.7 * share() - 0.3);
  }
  return knots;
}

std::vector<std::vector<std::string>> tableOf(const std::string& file)
{
  std::vector<std::vector<std::string>> rows;
  for (CsvReader csv(file); csv.next();)
  {
    rows.emplace_back();
    for (std::size_t i = 0; i < csv.size(); ++i)
    {
      rows.back().emplace_back(csv.text(i));
    }
  }
  if (rows.size() < 2)
  {
    throw std::runtime_error("no table " + file);
  }
  return rows;
}

std::size_t tickOf(double seconds)
{
  return static_cast<std::size_t>(std::lround(seconds / RelaxationPeriod)) - 1;
}

double largestOf(const std::vector<double>& forces)
{
  return *std::max_element(forces.begin(), forces.end());
}

/// Adds one path for each press of the table.
void addTing(const std::string& folder, std::vector<RelaxationPath>& paths)
{
  auto rows = tableOf(folder + "/Reference/rate/ting_golden.csv");
  rows.erase(rows.begin());
  const auto sameFields = [](const std::vector<std::string>& a, const std::vector<std::string>& b)
  { return std::equal(a.begin(), a.begin() + 7, b.begin()); };
  for (std::size_t begin = 0; begin < rows.size();)
  {
    const std::vector<std::string>& row = rows[begin];
    RelaxationPath path;
    path.name = "Ting";
    path.source = "ting_golden.csv";
    path.exponent = std::stod(row[0]);
    path.series = relaxation(row[1], row[2]);
    const double up = std::stod(row[4]);
    const double hold = std::stod(row[5]);
    std::size_t end = begin;
    for (; end < rows.size() && sameFields(row, rows[end]); ++end)
    {
      path.ticks.push_back(tickOf(std::stod(rows[end][7])));
      path.forces.push_back(std::stod(rows[end][9]));
    }
    const std::size_t last = *std::max_element(path.ticks.begin(), path.ticks.end());
    for (std::size_t tick = 0; tick <= last; ++tick)
    {
      const double t = static_cast<double>(tick + 1) * RelaxationPeriod;
      path.depths.push_back(
        std::min(t, up) * std::stod(row[3]) - std::max(t - hold, 0.0) * std::stod(row[6]));
    }
    path.largest = largestOf(foundationForces(path, TrueElements, TrueSubsteps));
    paths.push_back(path);
    begin = end;
  }
}

void addFoundations(std::vector<RelaxationPath>& paths)
{
  const PronySeries materials[] = { relaxation({ { 1.0, 0.1 } }),
    testing::relaxation({ { 4.0, 0.05 } }),
    relaxation({ { 0.5, 0.02 }, { 0.8, 0.2 }, { 1.2, 2.0 } }) };
  const std::pair<const char*, std::vector<double>> ways[] = {
    { "hold and release", along({ { 0.0, 0.0 }, { 0.1, 1.0 }, { 0.6, 1.0 }, { 0.7, 0.0 } }) },
    { "two triangles",
      along({ { 0.0, 0.0 }, { 0.2, 1.0 }, { 0.4, 0.0 }, { 0.5, 0.6 }, { 0.7, 0.0 } }) },
    { "sine", sine(0.6, 3) }, { "random presses", along(randomPresses()) }
  };
  for (const double exponent : Exponents)
  {
    for (const PronySeries& series : materials)
    {
      for (const auto& [name, depths] : ways)
      {
        RelaxationPath path;
        path.name = name;
        path.source = "1000 elements";
        path.exponent = exponent;
        path.series = series;
        path.depths = depths;
        path.forces = foundationForces(path, TrueElements, TrueSubsteps);
        for (std::size_t i = 0; i < depths.size(); ++i)
        {
          path.ticks.push_back(i);
        }
        path.largest = largestOf(path.forces);
        paths.push_back(path);
      }
    }
  }
}
} // namespace

const char* toolOfExponent(double exponent)
{
  return exponent == 1.0 ? "flat" : exponent == 1.5 ? "sphere" : "cone";
}

std::vector<double> foundationForces(const RelaxationPath& path, std::size_t elements, int substeps)
{
  RelaxationFoundation foundation(path.exponent, path.series, elements);
  std::vector<double> forces;
  double before = 0.0;
  for (const double depth : path.depths)
  {
    double force = 0.0;
    for (int i = 1; i <= substeps; ++i)
    {
      force =
        foundation.press(before + (depth - before) * i / substeps, RelaxationPeriod / substeps);
    }
    forces.push_back(force);
    before = depth;
  }
  return forces;
}

RelaxationPath stopAndGo(const std::string& folder, double exponent)
{
  RelaxationPath path;
  path.name = "stop and go";
  path.source = "oracle_stop_and_go.csv";
  path.exponent = exponent;
  path.series = relaxation({ { 0.5, 0.02 }, { 0.8, 0.2 }, { 1.2, 2.0 } });
  path.depths = along({ { 0.0, 0.0 }, { 0.05, 0.5 }, { 0.2, 0.5 }, { 0.25, 1.0 }, { 0.4, 1.0 },
    { 0.42, 0.6 }, { 0.55, 0.6 }, { 0.6, 0.9 }, { 0.7, 0.9 }, { 0.75, 0.3 }, { 0.9, 0.3 },
    { 1.0, 0.0 }, { 1.05, -0.15 } });
  const auto rows = tableOf(folder + "/Reference/rate/oracle_stop_and_go.csv");
  const std::size_t column = exponent == 1.0 ? 2 : exponent == 1.5 ? 3 : 4;
  for (std::size_t i = 1; i < rows.size(); ++i)
  {
    path.ticks.push_back(tickOf(std::stod(rows[i][0])));
    path.forces.push_back(std::stod(rows[i][column]));
  }
  path.largest = largestOf(path.forces);
  return path;
}

std::vector<RelaxationPath> relaxationPaths(const std::string& folder)
{
  std::vector<RelaxationPath> paths;
  for (const double exponent : Exponents)
  {
    paths.push_back(stopAndGo(folder, exponent));
  }
  addTing(folder, paths);
  addFoundations(paths);
  return paths;
}
} // namespace palpate::testing

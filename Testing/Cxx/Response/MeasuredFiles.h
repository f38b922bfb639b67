// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_MeasuredFiles_h
#define palpate_testing_MeasuredFiles_h

#include "TestBodies.h"

#include "vtkMeasuredContactResponse.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace palpate::testing
{
/// A made-up site: its position, and F(δ) from first contact on.
struct MadeSite
{
  std::string name;
  std::array<double, 3> position;
  std::function<double(double)> law;
};

/// F(δ) of Hertz's paraboloid of radius R.
inline std::function<double(double)> hertz(double R, double modulus)
{
  return [=](double d) { return 4.0 / 3.0 * modulus * std::sqrt(R) * std::pow(d, 1.5); };
}

/// Writes a file of curves to `path`. `offset` (mm) is the instrument's reading at first contact.
inline std::string writeCurves(const std::string& path, const std::string& tool,
  const std::vector<MadeSite>& sites, double depth = 1.5, double offset = 0.0, double noise = 0.0,
  unsigned seed = 1)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::ofstream file(path);
  file.precision(17);
  file << "# tool: " << tool << "\n# synthetic: closed form\n"
       << "site,x_mm,y_mm,z_mm,deflection_mm,force_N\n";
  for (const MadeSite& site : sites)
  {
    for (int i = -10; i <= 60; ++i)
    {
      const double d = depth * i / 60.0;
      const double force = (d > 0.0 ? site.law(d) : 0.0) + noise * normal(random);
      file << site.name << ',' << site.position[0] << ',' << site.position[1] << ','
           << site.position[2] << ',' << offset + d << ',' << force << '\n';
    }
  }
  return path;
}

using MeasuredFilter = vtkSmartPointer<vtkMeasuredContactResponse>;

inline MeasuredFilter measure(vtkPolyData* body, const std::string& file, const std::string& tool)
{
  auto filter = MeasuredFilter::New();
  filter->SetInputData(body);
  filter->AddFileName(file);
  filter->SetTool(makeTool(tool));
  filter->SetPoissonRatio(0.45);
  return filter;
}

/// Returns a number from the table of sites, or NaN if there is no such column.
inline double siteNumber(vtkMeasuredContactResponse* filter, vtkIdType row, const char* column)
{
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  return table->GetColumnByName(column) ? table->GetValueByName(row, column).ToDouble()
                                        : std::numeric_limits<double>::quiet_NaN();
}

inline std::string siteText(vtkMeasuredContactResponse* filter, vtkIdType row, const char* column)
{
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  return table->GetColumnByName(column) ? table->GetValueByName(row, column).ToString() : "";
}
} // namespace palpate::testing

#endif

// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredResponse/SiteRegistration.h"

#include "Mechanics/Files/CsvReader.h"
#include "Mechanics/Files/NumberText.h"

#include "vtkLandmarkTransform.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>
#include <string_view>
#include <vector>

namespace palpate
{
namespace
{
constexpr double RigidTolerance = 1e-3;
// Largest distance of points on a line from this line, relative to the extent of the points along
// the line.
constexpr double InLine = 1e-3;

const std::vector<std::string_view> PairColumns = { "from_x_mm", "from_y_mm", "from_z_mm",
  "to_x_mm", "to_y_mm", "to_z_mm" };

/// Reads the numbers of a row, separated by blanks or commas. Returns false if the row contains
/// anything else.
bool readNumbers(const CsvReader& csv, std::vector<double>& numbers)
{
  for (std::size_t i = 0; i < csv.size(); ++i)
  {
    std::istringstream words{ std::string(csv.text(i)) };
    for (std::string word; words >> word;)
    {
      numbers.emplace_back();
      if (!readNumber(word, numbers.back()))
      {
        return false;
      }
    }
  }
  return true;
}

void readPair(CsvReader& csv, std::vector<double>& numbers)
{
  for (std::size_t i = 0; i < PairColumns.size(); ++i)
  {
    numbers.push_back(csv.number(i));
  }
}

void readMatrixRow(CsvReader& csv, std::vector<double>& numbers)
{
  const std::size_t before = numbers.size();
  if (!readNumbers(csv, numbers) || numbers.size() != before + 4)
  {
    csv.fail(std::string("expected 4 finite numbers") +
      (before == 0 ? ", or the columns from_x_mm,from_y_mm,from_z_mm,to_x_mm,to_y_mm,to_z_mm"
                   : ""));
  }
}

std::string fromMatrix(const std::vector<double>& numbers, SiteRegistration& registration)
{
  if (numbers.size() != 16)
  {
    return "a matrix has 16 numbers, but there are " + std::to_string(numbers.size());
  }
  const Eigen::Matrix4d matrix = Eigen::Map<const Eigen::Matrix4d>(numbers.data()).transpose();
  const Eigen::Matrix3d turn = matrix.topLeftCorner<3, 3>();
  const bool affine = matrix.row(3) == Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0);
  if (!affine ||
    !((turn * turn.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <=
      RigidTolerance) ||
    turn.determinant() < 0.0)
  {
    std::ostringstream text;
    text << "the matrix is not a rigid motion: its determinant is " << turn.determinant()
         << ", its last row " << matrix.row(3);
    return text.str();
  }
  registration.motion.linear() = turn;
  registration.motion.translation() = matrix.topRightCorner<3, 1>();
  return {};
}

/// Returns whether all points are on one line or coincide.
bool areInLine(vtkPoints* points)
{
  Eigen::Matrix3Xd x(3, points->GetNumberOfPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    points->GetPoint(i, x.col(i).data());
  }
  x.colwise() -= Eigen::Vector3d(x.rowwise().mean());
  const Eigen::Vector3d spread =
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(x * x.transpose()).eigenvalues();
  return !(spread[1] > InLine * InLine * spread[2]);
}

std::string fromPairs(const std::vector<double>& numbers, SiteRegistration& registration)
{
  vtkNew<vtkPoints> from;
  vtkNew<vtkPoints> to;
  from->SetDataTypeToDouble();
  to->SetDataTypeToDouble();
  for (std::size_t i = 0; i + 6 <= numbers.size(); i += 6)
  {
    from->InsertNextPoint(&numbers[i]);
    to->InsertNextPoint(&numbers[i + 3]);
  }
  if (from->GetNumberOfPoints() < 3 || areInLine(from) || areInLine(to))
  {
    return "a registration needs three pairs of points that are not in line";
  }
  vtkNew<vtkLandmarkTransform> transform;
  transform->SetSourceLandmarks(from);
  transform->SetTargetLandmarks(to);
  transform->SetModeToRigidBody();
  transform->Update();
  const vtkMatrix4x4* found = transform->GetMatrix();
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      registration.motion.linear()(row, column) = found->GetElement(row, column);
    }
    registration.motion.translation()[row] = found->GetElement(row, 3);
  }
  registration.pairs = static_cast<std::size_t>(from->GetNumberOfPoints());
  double squares = 0.0;
  for (vtkIdType i = 0; i < from->GetNumberOfPoints(); ++i)
  {
    const Eigen::Vector3d there = Eigen::Map<const Eigen::Vector3d>(to->GetPoint(i));
    const Eigen::Vector3d here = Eigen::Map<const Eigen::Vector3d>(from->GetPoint(i));
    const double distance = (registration.motion * here - there).norm();
    squares += distance * distance;
    registration.largestResidual = std::max(registration.largestResidual, distance);
  }
  registration.residual = std::sqrt(squares / static_cast<double>(registration.pairs));
  return {};
}
} // namespace

std::string readRegistration(const std::string& path, SiteRegistration& registration)
{
  CsvReader csv(path);
  std::vector<double> numbers;
  bool isRow = csv.next();
  const bool pairs = isRow && !csv.text(0).empty() &&
    std::isalpha(static_cast<unsigned char>(csv.text(0).front())) != 0;
  if (pairs)
  {
    isRow = csv.columns(PairColumns, PairColumns.size()) && csv.next();
  }
  for (; isRow; isRow = csv.next())
  {
    pairs ? readPair(csv, numbers) : readMatrixRow(csv, numbers);
  }
  if (!csv.fault().empty())
  {
    return csv.fault();
  }
  SiteRegistration read;
  const std::string fault = pairs ? fromPairs(numbers, read) : fromMatrix(numbers, read);
  if (!fault.empty())
  {
    return path + ": " + fault;
  }
  registration = read;
  return {};
}
} // namespace palpate

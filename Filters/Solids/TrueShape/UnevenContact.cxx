// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/UnevenContact.h"

#include "Mechanics/Numerics/Constants.h"

#include <cmath>
#include <vector>

namespace palpate
{
namespace
{
// Lengths are relative to the contact radius, and pressures to E*.
constexpr double HalfWidth = 1.6; ///< half the width of the disc of cells
constexpr int CellsAcross = 16;
constexpr double CellSide = 2.0 * HalfWidth / CellsAcross;
constexpr auto CellArea = static_cast<float>(CellSide * CellSide);

/// Largest number of attempts. A contact that is off-centre is solved again around its middle. A
/// contact that is wider than the cells is solved again on wider cells.
constexpr int MostAttempts = 5;
constexpr double WideningFactor = 1.4;

constexpr int MostSteps = 60;
/// The iteration ends if a step moves less than this fraction of the load.
constexpr float LoadTolerance = 1e-4F;

/// Gap where no contact is possible, because the position is beyond the tool's wall or the surface
/// is not known.
constexpr float NoContactGap = 1e6F;

/// Returns the displacement of the surface under a cell with the pressure 1 (Love 1929; Johnson
/// 1985, 3.25).
double sinkOfCell(const Eigen::Vector2d& at)
{
  constexpr double h = 0.5 * CellSide;
  const auto term = [](double x, double y)
  { return x * std::log(y + std::hypot(x, y)) + y * std::log(x + std::hypot(x, y)); };
  return (term(at[0] + h, at[1] + h) + term(at[0] - h, at[1] - h) - term(at[0] + h, at[1] - h) -
           term(at[0] - h, at[1] + h)) /
    Pi;
}

/// The cells, which are the same for all contacts.
struct ContactCells
{
  Eigen::Matrix2Xd places;
  Eigen::VectorXf ofHertz; ///< relative pressures of a Hertzian contact with a sphere
  Eigen::MatrixXf sink;    ///< displacement of one cell under the pressure on another
  std::vector<std::pair<Eigen::Index, Eigen::Index>> neighbours;

  ContactCells()
  {
    std::vector<Eigen::Vector2d> inside;
    for (int i = 0; i < CellsAcross * CellsAcross; ++i)
    {
      const Eigen::Vector2d at = CellSide *
        (Eigen::Vector2d(i / CellsAcross, i % CellsAcross).array() + 0.5 * (1 - CellsAcross))
          .matrix();
      if (at.norm() < HalfWidth)
      {
        inside.push_back(at);
      }
    }
    const auto count = static_cast<Eigen::Index>(inside.size());
    this->places = Eigen::Map<const Eigen::Matrix2Xd>(inside.front().data(), 2, count);
    this->ofHertz = (1.0 - this->places.colwise().squaredNorm().array())
                      .max(0.0)
                      .sqrt()
                      .matrix()
                      .transpose()
                      .cast<float>();
    this->sink.resize(count, count);
    for (Eigen::Index i = 0; i < count; ++i)
    {
      for (Eigen::Index j = 0; j < count; ++j)
      {
        const Eigen::Vector2d away = this->places.col(i) - this->places.col(j);
        this->sink(i, j) = static_cast<float>(sinkOfCell(away));
        if (j < i && away.norm() < 1.1 * CellSide)
        {
          this->neighbours.emplace_back(i, j);
        }
      }
    }
  }
};

const ContactCells& contactCells()
{
  static const ContactCells cells;
  return cells;
}

/// Returns the mean of the values over the cells in contact.
float meanUnder(const Eigen::ArrayXf& touching, const Eigen::VectorXf& values)
{
  return (touching * values.array()).sum() / touching.sum();
}

/// Returns the displacement of the cells under the given pressures. Most of the pressures are 0.
Eigen::VectorXf sinkUnder(const Eigen::VectorXf& pressures)
{
  const ContactCells& cells = contactCells();
  Eigen::VectorXf sink = Eigen::VectorXf::Zero(pressures.size());
  for (Eigen::Index i = 0; i < pressures.size(); ++i)
  {
    if (pressures[i] != 0.0F)
    {
      sink += pressures[i] * cells.sink.col(i);
    }
  }
  return sink;
}

/// Finds the pressures that carry the load on a gap. The iteration starts with the given pressures.
/// Returns the depth.
double settle(const Eigen::VectorXf& gap, double load, Eigen::VectorXf& pressures)
{
  const float total = static_cast<float>(load) / CellArea;
  pressures = (gap.array() < NoContactGap).select(pressures, 0.0F);
  if (!(pressures.sum() > 0.0F)) // the cells of the previous contact cannot touch now
  {
    pressures = (gap.array() < NoContactGap).cast<float>();
  }
  pressures *= total / pressures.sum();
  Eigen::VectorXf direction = Eigen::VectorXf::Zero(gap.size());
  Eigen::VectorXf sink = sinkUnder(pressures);
  float depth = 0.0F;
  float squaresBefore = 1.0F;
  bool isConjugate = false;
  for (int step = 0; step < MostSteps; ++step)
  {
    const Eigen::ArrayXf touching = (pressures.array() > 0.0F).cast<float>();
    Eigen::VectorXf open = sink + gap;
    depth = meanUnder(touching, open);
    open.array() -= depth;
    const float squares = (touching * open.array().square()).sum();
    const float kept = isConjugate ? squares / squaresBefore : 0.0F;
    squaresBefore = squares;
    direction = (touching * (open + kept * direction).array()).matrix();
    const Eigen::VectorXf raw = sinkUnder(direction);
    const Eigen::VectorXf rise = raw.array() - meanUnder(touching, raw);
    const float along = open.dot(direction);
    const float against = rise.dot(direction);
    // This is always true for a single cell.
    const bool isBalanced = !(along > 0.0F && against > 0.0F);
    // Cells with tension are released. Cells in which the surface penetrates the tool join the
    // contact.
    const auto enters = touching == 0.0F && open.array() < 0.0F;
    if (isBalanced && !enters.any())
    {
      break; // converged
    }
    const float length = isBalanced ? 1.0F / contactCells().sink(0, 0) : along / against;
    const Eigen::VectorXf before = pressures;
    if (!isBalanced)
    {
      pressures -= length * direction;
    }
    isConjugate = !enters.any();
    const bool isSame = isConjugate && pressures.minCoeff() >= 0.0F;
    pressures = enters.select(-length * open, pressures.cwiseMax(0.0F));
    const float carried = total / pressures.sum();
    pressures *= carried;
    sink = isSame ? Eigen::VectorXf(carried * (sink - length * raw)) : sinkUnder(pressures);
    if ((pressures - before).lpNorm<1>() < LoadTolerance * total)
    {
      break;
    }
  }
  return static_cast<double>(depth);
}
} // namespace

UnevenContact::UnevenContact(const AxisymmetricTool& tool, const SurfaceGap& gap)
  : Tool(tool)
  , Reach(gap.reach())
  , Heights(gap)
  , OnShape(contactCells().ofHertz)
  , OnMean(contactCells().ofHertz)
{
  double least = 0.0;
  for (int k = 0; k < SurfaceGap::Rings * SurfaceGap::Angles; ++k)
  {
    const Eigen::Vector2d at = gap.place(k / SurfaceGap::Angles, k % SurfaceGap::Angles);
    const double here = this->meanGap(at.norm()) + this->Heights.around(at);
    if (here < least)
    {
      least = here;
      this->Middle = at;
    }
  }
}

double UnevenContact::meanGap(double r) const
{
  return r <= this->Reach ? this->Tool.profile(r) + this->Heights.mean(r) : Infinity;
}

UnevenContact::Change UnevenContact::at(double radius, double load)
{
  const ContactCells& cells = contactCells();
  const Eigen::Index count = cells.places.cols();
  Eigen::VectorXf gap(count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const double mean = this->meanGap(radius * cells.places.col(i).norm());
    gap[i] = mean < Infinity ? static_cast<float>(mean / radius) : NoContactGap;
  }
  const double onMean = radius * settle(gap, load / (radius * radius), this->OnMean);
  if (this->Tool.largestContactRadius() < HalfWidth * radius)
  {
    this->Middle.setZero(); // the middle is reset, so that the cells cover the whole tool
  }
  Change change;
  change.isInside = false;
  Eigen::VectorXf around(count);
  double scale = radius;
  for (int turn = 0; turn < MostAttempts && !change.isInside; ++turn)
  {
    if (turn > 0)
    {
      const Eigen::Vector2d aside =
        cells.places * this->OnShape.cast<double>() / static_cast<double>(this->OnShape.sum());
      this->OnShape = cells.ofHertz;
      this->Middle += scale * aside;
      scale *= aside.norm() < CellSide ? WideningFactor : 1.0;
    }
    for (Eigen::Index i = 0; i < count; ++i)
    {
      const Eigen::Vector2d at = this->Middle + scale * cells.places.col(i);
      const double mean = this->meanGap(at.norm());
      around[i] = mean < Infinity ? static_cast<float>(this->Heights.around(at) / scale) : 0.0F;
      gap[i] = mean < Infinity ? static_cast<float>(mean / scale) + around[i] : NoContactGap;
    }
    change.deflection = scale * settle(gap, load / (scale * scale), this->OnShape) - onMean;
    change.isInside = true;
    bool isAtEnd = false; // whether the contact is at the end of the known surface
    for (Eigen::Index i = 0; i < count; ++i)
    {
      if (this->OnShape[i] > 0.0F)
      {
        const Eigen::Vector2d at = this->Middle + scale * cells.places.col(i);
        isAtEnd = isAtEnd || at.norm() > this->Reach - scale * CellSide;
        change.isInside = change.isInside && cells.places.col(i).norm() < HalfWidth - CellSide;
      }
    }
    if (isAtEnd)
    {
      change.isInside = false;
      break;
    }
  }
  double squares = 0.0;
  double steps = 0.0;
  for (const auto& [i, j] : cells.neighbours)
  {
    if (this->OnShape[i] > 0.0F && this->OnShape[j] > 0.0F)
    {
      const double slope = static_cast<double>(around[i] - around[j]) / CellSide;
      // The factor 2 is needed, because a pair of cells gives the slope in only one of two
      // directions.
      squares += 2.0 * slope * slope;
      steps += 1.0;
    }
  }
  change.steepness = steps > 0.0 ? squares / steps : 0.0;
  return change;
}
} // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "MethodErrors.h"

#include "Identification/CurvesFile.h"
#include "Mechanics/ReducedModulus.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace palpate::testing
{
namespace
{
constexpr double Patience = 6.0;      // s, computing time for the tips of one kind
constexpr double Quick = 2e-4;        // s: a method faster than this is evaluated at every tip
constexpr std::size_t FewestTips = 4; // tips per kind, for methods that take seconds

/// The shortest of three calls, s.
double shortestCall(const StudyTips& tips, ContactMethod& method)
{
  using Clock = std::chrono::steady_clock;
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < std::min<std::size_t>(3, tips.sites.size()); ++i)
  {
    method.forget();
    const Clock::time_point start = Clock::now();
    method.force(tips.sites[i].position);
    const std::chrono::duration<double> taken = Clock::now() - start;
    shortest = std::min(shortest, taken.count());
  }
  return shortest;
}

double ratio(double missed, double right)
{
  return right > 0.0 ? std::sqrt(missed / right) : std::numeric_limits<double>::quiet_NaN();
}
} // namespace

ErrorJudge::ErrorJudge(const StudyTips& tips, ContactMethod& reference, std::size_t stride)
  : Tips(tips)
  , Sites(ask(tips.sites, reference, stride))
  , Path(ask(tips.path, reference, stride))
{
}

std::vector<ErrorJudge::Right> ErrorJudge::ask(
  const std::vector<StudyTip>& tips, ContactMethod& reference, std::size_t stride)
{
  std::vector<Right> rights;
  reference.forget();
  for (std::size_t i = 0; i < tips.size(); ++i)
  {
    if (tips[i].isNew)
    {
      reference.forget();
    }
    if (i % stride == 0)
    {
      const Vector3 force = reference.force(tips[i].position);
      if (force.allFinite() && force.norm() > 0.0)
      {
        rights.push_back({ i, force });
      }
    }
  }
  return rights;
}

ErrorJudge::Sums ErrorJudge::compare(const std::vector<StudyTip>& tips,
  const std::vector<Right>& rights, ContactMethod& method, double secondsPerCall)
{
  Sums sums;
  const bool isQuick = secondsPerCall < Quick;
  const auto within = static_cast<std::size_t>(std::min(1e9, Patience / (secondsPerCall + 1e-12)));
  const std::size_t most = std::max(FewestTips, within);
  const std::size_t step = (rights.size() + most - 1) / most;
  std::size_t next = 0;
  const auto one = [&](const Right& right)
  {
    const Vector3 force = method.force(tips[right.tip].position);
    ++sums.tips;
    if (!force.allFinite())
    {
      ++sums.unanswered;
      return;
    }
    const double missed = (force - right.force).squaredNorm();
    sums.missed += missed;
    sums.right += right.force.squaredNorm();
    sums.noticed += std::sqrt(missed) > Noticeable * right.force.norm() ? 1 : 0;
  };
  if (!isQuick)
  {
    for (std::size_t i = 0; i < rights.size(); i += step)
    {
      method.forget();
      one(rights[i]);
    }
    return sums;
  }
  method.forget();
  for (std::size_t i = 0; i < tips.size(); ++i)
  {
    if (tips[i].isNew)
    {
      method.forget();
    }
    if (next < rights.size() && rights[next].tip == i)
    {
      one(rights[next++]);
    }
    else
    {
      method.force(tips[i].position);
    }
  }
  return sums;
}

MethodErrors ErrorJudge::judge(ContactMethod& method) const
{
  const double secondsPerCall = shortestCall(this->Tips, method);
  const Sums sites = compare(this->Tips.sites, this->Sites, method, secondsPerCall);
  const Sums path = compare(this->Tips.path, this->Path, method, secondsPerCall);
  MethodErrors errors;
  errors.sites = ratio(sites.missed, sites.right);
  errors.path = ratio(path.missed, path.right);
  errors.all = ratio(sites.missed + path.missed, sites.right + path.right);
  errors.tips = sites.tips + path.tips;
  errors.unanswered = sites.unanswered + path.unanswered;
  const std::size_t answered = errors.tips - errors.unanswered;
  errors.noticed = answered == 0
    ? std::numeric_limits<double>::quiet_NaN()
    : static_cast<double>(sites.noticed + path.noticed) / static_cast<double>(answered);
  return errors;
}

double errorAgainstCurve(
  const std::string& folder, const StudyScene& scene, const StudyTool& tool, ContactMethod& method)
{
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::string shape = tool.name;
  shape.erase(std::remove(shape.begin(), shape.end(), ':'), shape.end());
  const std::string file = folder + "/" + scene.curves + "-" + shape + "-neohooke.csv";
  if (folder.empty() || scene.curves.empty() || !std::ifstream(file))
  {
    return none;
  }
  MeasuredCurves measured;
  const std::string error = readCurves(file, measured);
  if (!error.empty())
  {
    throw std::runtime_error(error);
  }
  // The curves are for E = 0.1 MPa and the scene's Poisson's ratio. The material is linear in E.
  const double scale =
    scene.material.reducedModulus / reducedModulus(0.1, scene.material.poissonRatio);
  const MeasuredCurve& curve = measured.curves.front();
  double missed = 0.0;
  double right = 0.0;
  for (std::size_t i = 0; i < curve.deflection.size(); ++i)
  {
    if (curve.deflection[i] > tool.range * (1.0 + 1e-9))
    {
      continue;
    }
    method.forget();
    const double force = method.force({ 0.0, 0.0, -curve.deflection[i] }).z();
    missed += (force - scale * curve.force[i]) * (force - scale * curve.force[i]);
    right += scale * scale * curve.force[i] * curve.force[i];
  }
  return ratio(missed, right);
}
} // namespace palpate::testing

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "StudyScene.h"

#include <cstddef>
#include <string>
#include <vector>

namespace palpate::testing
{
/// Errors of forces. Relative RMS: √(Σ|F - F'|² / Σ|F'|²), with F' the reference.
struct MethodErrors
{
  double all = 0.0;     ///< error over sites and path
  double sites = 0.0;   ///< random sites and depths, each a new contact
  double path = 0.0;    ///< the sliding path
  double noticed = 0.0; ///< share of the tips with |F - F'| > 10 % of |F'|
  std::size_t tips = 0; ///< number compared
  std::size_t unanswered = 0;
};

/// Evaluates methods and compares them with the reference of their scene.
class ErrorJudge
{
public:
  /// Just-noticeable difference of force; `noticed` counts errors above it.
  static constexpr double Noticeable = 0.1;

  /// The reference is evaluated at every `stride`-th tip.
  ErrorJudge(const StudyTips& tips, ContactMethod& reference, std::size_t stride);

  /// A slow method is evaluated at fewer of the same tips, each as a new contact.
  MethodErrors judge(ContactMethod& method) const;

private:
  struct Right
  {
    std::size_t tip;
    Vector3 force;
  };
  struct Sums
  {
    double missed = 0.0;
    double right = 0.0;
    std::size_t noticed = 0;
    std::size_t tips = 0;
    std::size_t unanswered = 0;
  };
  static std::vector<Right> ask(
    const std::vector<StudyTip>& tips, ContactMethod& reference, std::size_t stride);
  static Sums compare(const std::vector<StudyTip>& tips, const std::vector<Right>& rights,
    ContactMethod& method, double secondsPerCall);

  const StudyTips& Tips;
  std::vector<Right> Sites;
  std::vector<Right> Path;
};

/// Relative RMS error of the normal force against finite elements with finite strain
/// (FOLDER/PREFIX-TOOL-neohooke.csv), at the depths of the curve within the tool's range. NaN if
/// there is no such curve. Throws std::runtime_error if the file cannot be read.
double errorAgainstCurve(
  const std::string& folder, const StudyScene& scene, const StudyTool& tool, ContactMethod& method);
} // namespace palpate::testing

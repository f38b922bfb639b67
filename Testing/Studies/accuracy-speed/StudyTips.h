// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "StudyBody.h"

#include <cstddef>
#include <vector>

namespace palpate::testing
{
struct StudyTip
{
  Vector3 position;   ///< mm
  bool isNew = false; ///< unrelated to the one before
};

/// The tips of a study: random places and depths, each a new contact, and a sliding path of 0.1 mm
/// per tick with changing depth. Depths are 5 to 100 % of the range. Every run has the same tips.
struct StudyTips
{
  std::vector<StudyTip> sites;
  std::vector<StudyTip> path;
};

/// Tips on the plane z = 0, within |x|, |y| <= half.
StudyTips flatTips(double half, double range, std::size_t sites, std::size_t path);

/// Tips on a ball about the origin; no path.
StudyTips ballTips(double radius, double range, std::size_t sites);

/// Tips at gently curved places of a body: no normal within 4 mm turns by more than 0.35 rad.
StudyTips bodyTips(const StudyBody& body, double range, std::size_t sites, std::size_t path);
} // namespace palpate::testing

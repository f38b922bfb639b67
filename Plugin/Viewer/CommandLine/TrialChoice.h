// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TrialChoice_h
#define palpate_TrialChoice_h

#include "Contact/ContactSettings.h"
#include "LayerChoice.h"

#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// One of the alternatives of a blind comparison, by its changes to the session.
struct TrialChoice
{
  std::string name; ///< as given
  std::string tool; ///< empty: the scene's first
  std::optional<double> youngsModulus;
  std::optional<double> poissonsRatio;
  std::optional<LayerChoice> layer;
  std::optional<bool> hasLump; ///< with the nodules of the body, or without
  ContactSettings contact;     ///< those of the session, with the alternative's changes
};

/**
 * Reads "sphere:6.35,flat:1.6", "friction=0,friction=0.3" or
 * "sphere:6.35+layer=7,sphere:6.35+layer=none": alternatives with commas between them, each made of
 * a tool, settings, or both with a plus between them. Settings: young, poisson, layer (MM or none),
 * layers (as --layers, without scan),
 * the words lump and none (of a body with nodules: as it is, or without them), and those of
 * SettingTable that are options, with the values of the options of these names. A
 * piece that begins with a digit or a sign belongs to the number before it: blunted:1,30.
 *
 * `usual`: settings that the alternatives do not change. Returns an error that names the
 * alternative and leaves `choices` unchanged, or "".
 */
std::string readTrialChoices(
  const std::string& text, const ContactSettings& usual, std::vector<TrialChoice>& choices);
} // namespace palpate

#endif

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
/// One alternative of a blind comparison, with its changes to the session.
struct TrialChoice
{
  std::string name; ///< the alternative as given on the command line
  std::string tool; ///< empty for the scene's first tool
  std::optional<double> youngsModulus;
  std::optional<double> poissonRatio;
  std::optional<LayerChoice> layer;
  std::optional<bool> hasLump; ///< whether the body has its nodules in this alternative
  /// Contact settings of the session, including the changes of this alternative.
  ContactSettings contact;
};

/**
 * Reads alternatives separated by commas, such as "sphere:6.35,flat:1.6", "friction=0,friction=0.3"
 * or "sphere:6.35+layer=7,sphere:6.35+layer=none". Each alternative is a tool, settings, or both,
 * joined by a plus. The settings are
 * - young, poisson, layer (MM or none), layers (as --layers, without scan);
 * - the words lump and none for a body with nodules, for the body with or without its nodules;
 * - the entries of SettingTable that are command-line options, with the values of these options.
 *
 * A part that begins with a digit or a sign belongs to the preceding number, as in blunted:1,30.
 *
 * `usual` contains the settings that apply unless an alternative changes them. Returns "" on
 * success. Otherwise returns an error that names the alternative, and leaves `choices` unchanged.
 */
std::string readTrialChoices(
  const std::string& text, const ContactSettings& usual, std::vector<TrialChoice>& choices);
} // namespace palpate

#endif

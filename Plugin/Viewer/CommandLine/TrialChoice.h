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
/// One alternative of a blind comparison: its changes to the session.
struct TrialChoice
{
  std::string name; ///< the text of the alternative
  std::string tool; ///< empty: the scene's first tool
  std::optional<double> youngsModulus;
  std::optional<double> poissonRatio;
  std::optional<LayerChoice> layer;
  std::optional<bool> hasLump; ///< whether the body has its nodules
  ContactSettings contact; ///< settings of the session, including the changes of this alternative
};

/**
 * Reads alternatives separated by commas, such as "sphere:6.35,flat:1.6", "friction=0,friction=0.3"
 * or "sphere:6.35+layer=7,sphere:6.35+layer=none". Each alternative is a tool, settings, or both,
 * joined by a plus. Settings:
 * - young, poisson, layer (MM or none), layers (as --layers, without scan);
 * - the words lump and none, for a body with nodules: with or without them;
 * - the entries of SettingTable that are command-line options, with the values of these options.
 *
 * A part that begins with a digit or a sign belongs to the number before it: blunted:1,30.
 *
 * `usual` holds the settings that apply unless an alternative changes them. Returns "", or an error
 * that names the alternative; then `choices` is unchanged.
 */
std::string readTrialChoices(
  const std::string& text, const ContactSettings& usual, std::vector<TrialChoice>& choices);
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_OptionChecks_h
#define palpate_OptionChecks_h

#include "LayerChoice.h"
#include "Laws/LawTerms.h"
#include "NumberRange.h"

#include <CLI/CLI.hpp>

#include <string>

namespace palpate
{
/// Returns a validator for a number with readable errors. (The ranges of CLI11 print their limits
/// with 300 digits and accept NaN.)
CLI::Validator within(const NumberRange& range, const char* kind);
CLI::Validator any(const char* what);
CLI::Validator positive(const char* what, double most = NumberRange::Endless);
CLI::Validator notNegative(const char* what);

// Each of the following functions returns "" or the error in the text of an option.

/// Reads the text of --layer, which is "scan", "none" or a thickness.
std::string readLayer(const std::string& text, LayerChoice& layer);
/// Reads the text of --layers, which is "scan" or a list of layers MM:MPA:NU separated by commas,
/// outermost first. MM may be "scan" for one of two layers on the rigid base. MM may be 0 for the
/// last layer, which is then a half-space. ":slip" after a layer means no friction with the layer
/// above it. ",slip" at the end means no friction with the rigid base.
std::string readLayers(const std::string& text, LayerChoice& layer);
/// Reads the text of --solid, which is the size of a tetrahedron or "". For "" the spacing is 0,
/// which means that it is chosen automatically.
std::string readSolid(const std::string& text, double& spacing);
/// Reads the text of --strain: "small", "auto", "neo-hooke", "ogden:ALPHA" or "demiray:B".
std::string readStrain(const std::string& text, LawTerms& terms);
/// Reads the text of --length-unit, and replaces it by the number of mm per unit, for CLI11.
std::string readLengthUnit(std::string& text);
/// Checks the text of --fixed, which has the form of vtkVoxelBody::FixedFaces.
std::string checkFaces(const std::string& text);
/// Checks the text of --tool.
std::string checkToolText(const std::string& text);
} // namespace palpate

#endif

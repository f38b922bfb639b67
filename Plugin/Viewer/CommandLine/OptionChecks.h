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
/// Validates a number with a readable error; CLI11's own ranges print their limits with 300 digits,
/// and accept NaN.
CLI::Validator within(const NumberRange& range, const char* kind);
CLI::Validator any(const char* what);
CLI::Validator positive(const char* what, double most = NumberRange::Endless);
CLI::Validator notNegative(const char* what);

// Each returns what is wrong with the text of an option, or "".

/// --layer: "scan", "none" or a thickness.
std::string readLayer(const std::string& text, LayerChoice& layer);
/// --layers: "scan", or layers MM:MPA:NU with commas between them, outermost first. MM may be
/// "scan" in one of two layers on the rigid base, and 0 in the last, which is then the half-space
/// below;
/// ":slip" after a layer: without friction on the one above, ",slip" at the end: on the rigid base.
std::string readLayers(const std::string& text, LayerChoice& layer);
/// --solid: "" (0, chosen) or the size of a tetrahedron.
std::string readSolid(const std::string& text, double& spacing);
/// --strain: "small", "auto", "neo-hooke", "ogden:ALPHA", "demiray:B".
std::string readStrain(const std::string& text, LawTerms& terms);
/// --length-unit: mm per unit, in CLI11's text.
std::string readLengthUnit(std::string& text);
/// --fixed, as for vtkVoxelBody.
std::string checkFaces(const std::string& text);
/// --tool.
std::string checkToolText(const std::string& text);
} // namespace palpate

#endif

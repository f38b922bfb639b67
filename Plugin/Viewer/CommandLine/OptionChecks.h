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
/// Validates a number, with a readable error. (CLI11's own ranges print their limits with 300
/// digits, and accept NaN.)
CLI::Validator within(const NumberRange& range, const char* kind);
CLI::Validator any(const char* what);
CLI::Validator positive(const char* what, double most = NumberRange::Endless);
CLI::Validator notNegative(const char* what);

// Each of the following functions returns "" or the error in the text of an option.

/// Reads --layer: "scan", "none" or a thickness.
std::string readLayer(const std::string& text, LayerChoice& layer);
/// Reads --layers: "scan", or layers MM:MPA:NU separated by commas, outermost first. MM may be
/// "scan" in one of two layers on the rigid base. MM may be 0 in the last layer, which is then a
/// half-space. ":slip" after a layer means no friction with the layer above it. ",slip" at the end
/// means no friction with the rigid base.
std::string readLayers(const std::string& text, LayerChoice& layer);
/// Reads --solid: the size of a tetrahedron, or "", which gives 0 (the size is chosen
/// automatically).
std::string readSolid(const std::string& text, double& spacing);
/// Reads --strain: "small", "auto", "neo-hooke", "ogden:ALPHA", "demiray:B".
std::string readStrain(const std::string& text, LawTerms& terms);
/// Reads --length-unit: converts the text for CLI11 to mm per unit.
std::string readLengthUnit(std::string& text);
/// Checks --fixed, which has the form of vtkVoxelBody::FixedFaces.
std::string checkFaces(const std::string& text);
/// Checks --tool.
std::string checkToolText(const std::string& text);
} // namespace palpate

#endif

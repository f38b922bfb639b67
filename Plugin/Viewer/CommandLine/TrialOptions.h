// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TrialOptions_h
#define palpate_TrialOptions_h

#include "ViewerOptions.h"

#include <string>

namespace CLI
{
class App;
} // namespace CLI

namespace palpate
{
/// The options of a blind comparison. `alternatives` gets the text of the alternatives, to be read
/// once all options are known.
void addTrialOptions(CLI::App& app, ViewerOptions& options, std::string& alternatives);

/// The tools of the alternatives become those of the scene. Throws CLI::ValidationError.
void takeTrialTools(ViewerOptions& options);
} // namespace palpate

#endif

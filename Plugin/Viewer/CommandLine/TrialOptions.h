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
/// Adds the options of a blind comparison. `alternatives` receives the text of the alternatives,
/// which must be read after all other options.
void addTrialOptions(CLI::App& app, ViewerOptions& options, std::string& alternatives);

/// Makes the tools of the alternatives the tools of the scene. Throws CLI::ValidationError.
void takeTrialTools(ViewerOptions& options);
} // namespace palpate

#endif

// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TissueOptions_h
#define palpate_TissueOptions_h

#include "ViewerOptions.h"

namespace CLI
{
class App;
} // namespace CLI

namespace palpate
{
/// Adds the option --tissue. Must be called after all options that it excludes have been added.
void addTissueOptions(CLI::App& app, ViewerOptions& options);

/// Checks the tissues together, and chooses the window with the map if no other output is
/// requested. Throws CLI::ValidationError.
void checkTissues(const CLI::App& app, ViewerOptions& options);
} // namespace palpate

#endif

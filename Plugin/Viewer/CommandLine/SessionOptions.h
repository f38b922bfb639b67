// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SessionOptions_h
#define palpate_SessionOptions_h

#include "ViewerOptions.h"

namespace CLI
{
class App;
} // namespace CLI

namespace palpate
{
/// Adds an option for each entry of SettingTable that is offered on the command line.
void addContactOptions(CLI::App& app, ContactSettings& contact);

/// Adds the options of the device, the servo thread and its records.
void addDeviceOptions(CLI::App& app, ViewerOptions& options);
} // namespace palpate

#endif

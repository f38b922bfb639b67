// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerModules.h"

#include "Mechanics/JoinedText.h"

namespace palpate
{
namespace
{
template <class Module>
const Module* useModule(
  const LoadedModule& loaded, const char* name, const std::string& option, std::string& fault)
{
  fault =
    loaded.table ? std::string() : joined(option, " needs ", missingModule(name, loaded.fault));
  return static_cast<const Module*>(loaded.table);
}
} // namespace

const SolidsModule* solidsModule(const std::string& option, std::string& fault)
{
  static const LoadedModule loaded = loadModule("palpateViewerSolids");
  return useModule<SolidsModule>(loaded, "Solids", option, fault);
}

const IdentificationModule* identificationModule(const std::string& option, std::string& fault)
{
  static const LoadedModule loaded = loadModule("palpateViewerIdentification");
  return useModule<IdentificationModule>(loaded, "Identification", option, fault);
}

const ComparisonModule* comparisonModule(const std::string& option, std::string& fault)
{
  static const LoadedModule loaded = loadModule("palpateViewerComparison");
  return useModule<ComparisonModule>(loaded, "Comparison", option, fault);
}

const TrialsModule* trialsModule(const std::string& option, std::string& fault)
{
  static const LoadedModule loaded = loadModule("palpateViewerTrials");
  return useModule<TrialsModule>(loaded, "Trials", option, fault);
}
} // namespace palpate

// SPDX-License-Identifier: BSD-3-Clause
#include "OutputCheck.h"

#include "Mechanics/Files/WholeFile.h"

namespace palpate
{
std::string outputProblem(const ViewerOptions& options)
{
  for (const std::string& file :
    { options.record, options.save, options.exportTo, options.screenshot })
  {
    std::string problem = file.empty() ? std::string() : WholeFile::obstacle(file);
    if (!problem.empty())
    {
      return problem;
    }
  }
  return {};
}
} // namespace palpate

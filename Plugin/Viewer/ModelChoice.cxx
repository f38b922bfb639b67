// SPDX-License-Identifier: BSD-3-Clause
#include "ModelChoice.h"

#include "Interaction/Session/LeastForm.h"

#include <chrono>

namespace palpate
{
std::string chooseModel(const ViewerOptions& options, const ViewerScene& scene,
  const ResponseSet& responses, ModelChoice& choice)
{
  choice.body = responses.body;
  if (!options.automatic)
  {
    return {};
  }
  const auto begin = std::chrono::steady_clock::now();
  const LeastFormRequest request{ responses.body, responses.names.front(), options.tolerance,
    scene.depth, scene.solid ? "GlobalCompliance" : "", responses.tools.front(),
    scene.youngsModulus, scene.poissonRatio };
  const LeastForm form = findLeastForm(request);
  if (form.error.empty())
  {
    choice.body = form.body;
    choice.reason = form.reason;
  }
  choice.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return form.error;
}
} // namespace palpate

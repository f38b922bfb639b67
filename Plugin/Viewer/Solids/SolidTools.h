// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SolidTools_h
#define palpate_SolidTools_h

#include "ViewerScene.h"

#include "vtkContactTool.h"

#include <functional>
#include <string>
#include <vector>

class vtkElasticContactResponse;

namespace palpate
{
/// The tools of a scene that are pressed on a solid.
struct SolidTools
{
  std::vector<vtkSmartPointer<vtkContactTool>> tools;
  std::vector<std::size_t> order; ///< indices of the tools; the tool with the widest contact is
                                  ///< first, because the other tools use its solutions
  double widest = 0.0;            ///< radius of the widest contact, mm
};

/// Makes the tools of the scene. Returns "" or an error.
std::string makeSolidTools(
  const ViewerOptions& options, const ViewerScene& scene, SolidTools& made);

/// Sets the values that are common to the responses of all tools.
void setSolidTerms(
  const ViewerOptions& options, const ViewerScene& scene, vtkElasticContactResponse* pressed);

/// Sets the tool with the index `t` of the scene, its law of finite strain, and the name of its
/// response.
void setSolidTool(const ViewerOptions& options, const ViewerScene& scene, const SolidTools& made,
  std::size_t t, vtkElasticContactResponse* pressed);

/// Returns a part of a cache key, with the options of a solid and its law of finite strain.
std::string solidTermsKey(const ViewerOptions& options, const ViewerScene& scene);

/// Makes the body of a scene by calling `solve`, or reads it from the cache file `kind`-HASH.vtp,
/// whose hash depends on `key`. Afterwards the scene's body contains the responses. Returns "" or
/// an error.
std::string solveOrRead(const std::string& kind, const std::string& key, ViewerScene& scene,
  const std::function<std::string()>& solve);
} // namespace palpate

#endif

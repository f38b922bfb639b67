// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ContactMethod.h"
#include "StudyBody.h"
#include "StudyLaw.h"
#include "StudyTips.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace palpate::testing
{
class FiniteBody;

/// A method, and what its bytes are counted by.
struct StudyMethod
{
  std::unique_ptr<ContactMethod> method;
  std::size_t vertices = 0;  ///< of the mesh it is made on
  std::size_t meshBytes = 0; ///< what of its bytes is surface and index
};
using MethodList = std::vector<StudyMethod>;

/// A body, how it is touched, and what is right on it.
struct StudyScene
{
  std::string name;
  StudyMaterial material;
  std::vector<StudyTool> tools; ///< the first is the one that springs are calibrated with
  std::vector<std::unique_ptr<StudyBody>> bodies; ///< from fine to coarse; the first is the scene's
  std::function<StudyTips(const StudyTool&)> tips;
  std::function<std::unique_ptr<ContactMethod>(const StudyLaw&)> reference;
  /// Finite elements beside the tick; may be empty.
  std::function<std::vector<std::unique_ptr<ContactMethod>>(const StudyTool&)> finite;
  std::size_t finiteVertices = 0; ///< nodes that can be touched
  std::size_t stride = 1;         ///< the reference is asked at every so manyth tip
  std::string curves; ///< how files of finite-element curves of this body begin; may be empty
};

/// How much is done.
struct StudyEffort
{
  std::size_t sites = 2000;
  std::size_t path = 4000;
  bool withFinite = true; ///< finite elements beside the tick
  static StudyEffort quick() { return { 150, 300, false }; }
};

StudyScene blockScene(const StudyEffort& effort);
StudyScene layerScene(const StudyEffort& effort);
StudyScene plateScene(const StudyEffort& effort);
/// From files of readStudyBody, fine to coarse.
StudyScene headScene(const StudyEffort& effort, const std::vector<std::string>& files);

/// All methods on a scene, with one tool.
MethodList studyMethods(const StudyScene& scene, const StudyTool& tool);
} // namespace palpate::testing

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

/// A method with the sizes to which its bytes are related.
struct StudyMethod
{
  std::unique_ptr<ContactMethod> method;
  std::size_t vertices = 0;  ///< number of vertices of the method's mesh
  std::size_t meshBytes = 0; ///< bytes of surface and index, a part of the method's bytes
};
using MethodList = std::vector<StudyMethod>;

/// A body, its tools, the tips and its reference.
struct StudyScene
{
  std::string name;
  StudyMaterial material;
  std::vector<StudyTool> tools; ///< springs are calibrated with the first
  std::vector<std::unique_ptr<StudyBody>>
    bodies; ///< bodies from fine to coarse; the first is that of the scene
  std::function<StudyTips(const StudyTool&)> tips;
  std::function<std::unique_ptr<ContactMethod>(const StudyLaw&)> reference;
  /// Finite-element methods in addition to the tick; may be empty.
  std::function<std::vector<std::unique_ptr<ContactMethod>>(const StudyTool&)> finite;
  std::size_t finiteVertices = 0; ///< nodes that can be in contact
  std::size_t stride = 1;         ///< the reference is evaluated at every stride-th tip
  std::string curves; ///< prefix of the files with finite-element curves of this body; may be empty
};

/// Amount of work.
struct StudyEffort
{
  std::size_t sites = 2000;
  std::size_t path = 4000;
  bool withFinite = true; ///< includes finite-element methods
  static StudyEffort quick() { return { 150, 300, false }; }
};

StudyScene blockScene(const StudyEffort& effort);
StudyScene layerScene(const StudyEffort& effort);
StudyScene plateScene(const StudyEffort& effort);
/// A scene from files of readStudyBody, fine to coarse.
StudyScene headScene(const StudyEffort& effort, const std::vector<std::string>& files);

/// All methods on a scene, with one tool.
MethodList studyMethods(const StudyScene& scene, const StudyTool& tool);
} // namespace palpate::testing

// SPDX-License-Identifier: BSD-3-Clause
#ifndef ResponseMaker_h
#define ResponseMaker_h

#include "Interaction/Session/BodyKernels.h"
#include "Laws/BodyMaterial.h"
#include "Laws/LawTerms.h"
#include "Response/Curves/MaterialArrays.h"

#include "vtkContactTool.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// A request for responses. Objects shared with another thread are read only.
struct MadeResponses;

struct ResponseRequest
{
  vtkSmartPointer<vtkPolyData> body;
  std::vector<vtkSmartPointer<vtkContactTool>> tools;
  std::vector<std::string> toolKeys; ///< keys of the tools; equal keys mean equal tools
  std::vector<std::string> names;    ///< prefix of each tool's response
  /// Whether the body already has the responses, so that only the kernels are made.
  bool stored = false;
  double youngsModulus = 0.0; ///< MPa
  double poissonRatio = 0.0;
  double maximumDeflection = 0.0; ///< mm
  double layerThickness = 0.0;    ///< mm, for a body without a thickness array
  std::string thicknessArray; ///< "" if the layer has the thickness layerThickness at all points
  LayerBase base = LayerBase::Bonded;
  std::vector<StackLayer> deeper = {}; ///< layers below the first layer
  /// Array with the thickness of the first of the deeper layers. "" if this thickness is constant.
  std::string secondArray = {};
  std::optional<StackLayer> halfSpace = {}; ///< elastic half-space instead of a rigid base
  std::string complianceArray;              ///< "" if the body has no compliance
  double complianceFactor = 1.0;            ///< factor for the body's compliance and modes
  LawTerms terms;                           ///< terms of the law
  RelaxationRequest relaxation;             ///< relaxation of the responses of all tools
  bool coupling = false; ///< whether each contact deflects the surface at the other contacts
  /// Largest error of the form from which a session computes the force. With 0, the responses are
  /// used unchanged.
  double tolerance = 0.0;
  /// Deflection for which the form is chosen, mm. With 0, half of maximumDeflection is used.
  double choiceDeflection = 0.0;
  /// A kernel with the same surface, or null if there is none.
  std::shared_ptr<const ContactBody> surface;
  /// Responses that were computed earlier, or null. They are scaled if only Young's modulus, or
  /// Poisson's ratio of a half-space, differs (ModulusChange.h).
  std::shared_ptr<const MadeResponses> known;
  bool isFinal = false; ///< whether only final results are allowed, not preliminary ones
};

/// The finished responses, or the error.
struct MadeResponses
{
  vtkSmartPointer<vtkPolyData> from; ///< the body of the request
  vtkSmartPointer<vtkPolyData> body; ///< the same body with the responses; null after an error
  std::vector<vtkSmartPointer<vtkContactTool>> tools;
  double poissonRatio = 0.0;
  ResponseRequest of; ///< the request, without `surface` and `known`
  /// For each response, the body with the form from which a session computes the force.
  std::vector<vtkSmartPointer<vtkPolyData>> forms;
  BodyKernels kernels; ///< kernels of these forms
  /// Reason for the choice of each form; empty if no form was chosen.
  std::vector<std::string> choices;
  std::string error;
  std::string warning;
  /// Whether the forces are exact, but errors and validities were computed for another Poisson's
  /// ratio.
  bool isPreliminary = false;
};

/// Makes the responses. The cost is 1 to 40 µs per point and tool, or less if `known` is scaled
/// (ModulusChange.h). The function calls goOn() with the completed fraction of the work, and stops
/// when goOn() returns false. May run on any thread.
MadeResponses makeResponses(
  const ResponseRequest& request, const std::function<bool(double)>& goOn);
} // namespace palpate

#endif

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
  std::vector<std::string> toolKeys; ///< equal for equal tools
  std::vector<std::string> names;    ///< prefix of each tool's response
  bool stored = false; ///< whether the body already has the responses, so that only the kernels are
                       ///< made
  double youngsModulus = 0.0; ///< MPa
  double poissonRatio = 0.0;
  double maximumDeflection = 0.0; ///< mm
  double layerThickness = 0.0;    ///< mm, for a body without a thickness array
  std::string thicknessArray;     ///< "": layerThickness everywhere
  LayerBase base = LayerBase::Bonded;
  std::vector<StackLayer> deeper = {}; ///< layers below the first
  std::string secondArray = {}; ///< array of the thickness of the first layer of `deeper`; "": the
                                ///< constant of that layer
  std::optional<StackLayer> halfSpace = {}; ///< replaces a rigid base
  std::string complianceArray;              ///< "": none
  double complianceFactor = 1.0;            ///< factor of the body's compliance and modes
  LawTerms terms;                           ///< terms of the law
  RelaxationRequest relaxation;             ///< for the response of every tool
  bool coupling = false;  ///< whether several contacts deflect the surface for one another
  double tolerance = 0.0; ///< largest error of the form from which a session computes the force; 0:
                          ///< the responses are used unchanged
  double choiceDeflection = 0.0; ///< deflection for which the form is chosen, mm; 0: half of the
                                 ///< largest deflection
  /// Kernel of the same surface, if one exists; otherwise null.
  std::shared_ptr<const ContactBody> surface;
  /// Responses that were computed before. They are scaled if only Young's modulus differs, or
  /// Poisson's ratio of a half-space (ModulusChange.h). May be null.
  std::shared_ptr<const MadeResponses> known;
  bool isFinal = false; ///< whether the result must not be preliminary
};

/// The finished responses, or the error.
struct MadeResponses
{
  vtkSmartPointer<vtkPolyData> from; ///< the body of the request
  vtkSmartPointer<vtkPolyData> body; ///< the same body with the responses; null after an error
  std::vector<vtkSmartPointer<vtkContactTool>> tools;
  double poissonRatio = 0.0;
  ResponseRequest of;                              ///< the request, without `surface` and `known`
  std::vector<vtkSmartPointer<vtkPolyData>> forms; ///< the body with the form of each response from
                                                   ///< which a session computes the force
  BodyKernels kernels; ///< kernels of the forms from which a session computes the force
  std::vector<std::string> choices; ///< reason for each form; empty if none was chosen
  std::string error;
  std::string warning;
  /// The forces are exact, but errors and validities are those of another Poisson's ratio.
  bool isPreliminary = false;
};

/// Makes the responses. Cost: 1 to 40 µs per point and tool; less if `known` is scaled
/// (ModulusChange.h). Reports the fraction of the work to goOn(), and
/// stops when goOn() returns false. May run on any thread.
MadeResponses makeResponses(
  const ResponseRequest& request, const std::function<bool(double)>& goOn);
} // namespace palpate

#endif

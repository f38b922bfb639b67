// SPDX-License-Identifier: BSD-3-Clause
#ifndef ResponseMaker_h
#define ResponseMaker_h

#include "Interaction/Session/BodyKernels.h"
#include "Laws/BodyMaterial.h"
#include "Laws/LawTerms.h"
#include "Response/Curves/RelaxationRequest.h"

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
/// A request for responses. Objects shared with another thread are only read.
struct ResponseRequest
{
  vtkSmartPointer<vtkPolyData> body;
  std::vector<vtkSmartPointer<vtkContactTool>> tools;
  std::vector<std::string> names; ///< prefix of each tool's response
  bool stored = false;            ///< the body has them: only the kernels are made
  double youngsModulus = 0.0;     ///< MPa
  double poissonRatio = 0.0;
  double maximumDeflection = 0.0; ///< mm
  double layerThickness = 0.0;    ///< mm, of a body without such an array
  std::string thicknessArray;     ///< "": the constant
  LayerBase base = LayerBase::Bonded;
  std::vector<StackLayer> deeper = {};      ///< below that layer
  std::string secondArray = {};             ///< thickness of the first of these; "": the constant
  std::optional<StackLayer> halfSpace = {}; ///< in place of a rigid base
  std::string complianceArray;              ///< "": none
  double complianceFactor = 1.0; ///< the body's, by which compliance and modes are multiplied
  LawTerms terms;                ///< of the law
  RelaxationRequest relaxation;  ///< of every tool's response
  bool coupling = false;         ///< several contacts feel one another
  double tolerance = 0.0;        ///< of the form used for the force; 0: the responses unchanged
  double choiceDeflection = 0.0; ///< mm, for which the form is chosen; 0: half of the deepest
  /// Kernel of the same surface, if there is one already; may be null.
  std::shared_ptr<const ContactBody> surface;
};

/// The responses that were made, or why not.
struct MadeResponses
{
  vtkSmartPointer<vtkPolyData> from; ///< the body of the request
  vtkSmartPointer<vtkPolyData> body; ///< the same with the responses; null after an error
  std::vector<vtkSmartPointer<vtkContactTool>> tools;
  double poissonRatio = 0.0;
  BodyKernels kernels;              ///< of the forms used for the force
  std::vector<std::string> choices; ///< why these; empty where none was chosen
  std::string error;
  std::string warning;
};

/// Cost: about 1 µs per point and tool. Stops when stale() returns true. On any thread.
MadeResponses makeResponses(const ResponseRequest& request, const std::function<bool()>& stale);
} // namespace palpate

#endif
